// # A cell under finite strain
//
// The energy of a cell is \f$ \sum_q w_q W(F_q) \f$ over its points, with volumes \f$ w_q \f$ before strain. With the linear
// map G from displacements to gradients, \f$ H = Gu \f$, its first and second derivatives are
// \f[ f = \sum_q w_q G^T P, \qquad K = \sum_q w_q G^T \frac{\partial P}{\partial H} G. \f]
// That is all, for an element whose gradients are those of its shape functions.
//
// *Mean change of volume.* Near incompressibility four points that each keep their volume are too many for a cell of four
// nodes. So F is replaced by \f$ \tilde F = rF \f$ in the plane, \f$ r = (\bar J/J)^{1/2} \f$: each point then has the mean
// change of volume. With \f$ \ell = \ln r \f$ and its gradient g, \f$ \delta\tilde F = r(\delta F + F\,\delta\ell) \f$, so G
// becomes \f$ r(G + F g^T) \f$, and the second derivative of \f$ \tilde F \f$ adds
// \f[ w\left[ r (G^T P\,g^T + g\,P^T G) + (P : \tilde F)\,(g g^T + \nabla\nabla\ell) \right] \f]
// to K. For small strain this is the element q4_bbar.
//
// *Plane stress.* The strain across is what leaves no stress there: one equation per point, by Newton's method, after which
// the fifth component is eliminated from the tangent.

#include "addons/motion/finite_strain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using GradientMap = Eigen::Matrix<double, 5, Eigen::Dynamic, Eigen::ColMajor, 5, 2 * max_cell_nodes>;

/// One point of a cell: its map G and its gradient.
struct Place {
  double volume;
  GradientMap G;
  Components H;
};

/// ln r of all points of a cell whose change of volume is averaged, and its derivatives.
struct MeanVolume {
  std::array<double, max_strain_points> log;
  std::array<CellVector, max_strain_points> gradient;
  std::array<CellMatrix, max_strain_points> curvature;
};

Lame lame_of(const Material& material) {
  const double E = material.youngs_modulus;
  const double nu = material.poisson_ratio;
  return {E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))};
}

/// G at a point, read off its strain operator: the shear of a cell has all derivatives of its shape functions, whatever was
/// done to its volume. In axial symmetry the circle through the point becomes longer by u_r / r.
void write_map(const StrainMatrix& B, GradientMap& G) {
  G.setZero(5, B.cols());
  for (Index k = 0; k < B.cols(); k += 2) {
    G(0, k) = B(2, k + 1);
    G(1, k) = B(2, k);
    G(2, k + 1) = B(2, k + 1);
    G(3, k + 1) = B(2, k);
    if (B.rows() == 4) G(4, k) = B(3, k);
  }
}

void require_upright(const Cell& cell, double J) {
  if (J > 0) return;
  const Eigen::Vector2d x = cell.body.middle;
  throw ProblemError(text("cell ", cell.number, " of '", cell.mesh.name, "', at (", x.x(), ", ",
                          x.y(), ") before it moved, inverts: take shorter steps, or a ",
                          "finer mesh there"));
}

/// Components of the derivative of det F, of the block in the plane.
Eigen::Vector4d cofactor(const Components& H) {
  return {1 + H(3), -H(2), -H(1), 1 + H(0)};
}

/// J - 1 at a point, and the derivatives of J; beyond the plane J is (1 + H33) times the area, but for plane stress, where H33
/// follows.
double volume_change(const Place& at, bool across, CellVector& first, CellMatrix& second) {
  const auto plane = at.G.topRows<4>();
  const double area = 1 + area_change(at.H);
  const double H33 = across ? at.H(4) : 0;
  const double F33 = 1 + H33;
  const CellVector along = plane.transpose() * cofactor(at.H);
  first = F33 * along;
  second = F33 * (plane.row(0).transpose() * plane.row(3) - plane.row(1).transpose() * plane.row(2));
  if (across) {
    const CellVector hoop = at.G.row(4).transpose();
    first += area * hoop;
    second += along * hoop.transpose();
  }
  second = (second + CellMatrix(second.transpose())).eval();
  return area_change(at.H) * F33 + H33;
}

/// ln r = (ln of the mean of J - ln J) / 2.
void mean_volume(const std::vector<Place>& places, bool across, MeanVolume& mean) {
  double whole = 0;
  double change = 0;  // of volume
  const Index n = places[0].G.cols();
  CellVector first = CellVector::Zero(n);
  CellMatrix second = CellMatrix::Zero(n, n);
  for (std::size_t q = 0; q < places.size(); ++q) {
    const double volume = places[q].volume;
    mean.log[q] = volume_change(places[q], across, mean.gradient[q], mean.curvature[q]);
    change += volume * mean.log[q];
    first += volume * mean.gradient[q];
    second += volume * mean.curvature[q];
    whole += volume;
  }
  const double J = 1 + change / whole;
  first /= whole * J;
  second /= whole * J;
  for (std::size_t q = 0; q < places.size(); ++q) {
    const double own_J = 1 + mean.log[q];
    const CellVector own = mean.gradient[q] / own_J;
    mean.log[q] = 0.5 * (std::log1p(change / whole) - std::log1p(mean.log[q]));
    mean.curvature[q] = 0.5 * (second - first * first.transpose() - mean.curvature[q] / own_J +
                               own * own.transpose());
    mean.gradient[q] = 0.5 * (first - own);
  }
}

/// Finds the strain across that leaves no stress there, and takes it out of the tangent.
void release_across(HyperelasticLaw law, const Cell& cell, const Lame& lame, Components& H,
                    StressResponse& response) {
  constexpr int most_tries = 50;  // each doubles the digits, behind a few that only come closer
  const double nu = cell.material.poisson_ratio;
  H(4) = std::expm1(-nu / (1 - nu) * std::log1p(area_change(H)));
  for (int k = 0; k < most_tries; ++k) {
    law(lame, H, response);
    const double change = -response.piola(4) / response.tangent(4, 4);
    if (!(response.tangent(4, 4) > 0) || !(1 + H(4) + change > 0)) break;
    H(4) += change;
    if (std::abs(change) > epsilon * (1 + H(4))) continue;
    const Components coupled = response.tangent.col(4);
    response.piola += change * coupled;  // what is nothing beside 1 is all of a small strain
    response.tangent -= coupled * coupled.transpose() / coupled(4);
    response.piola(4) = 0;
    return;
  }
  throw ProblemError(text("cell ", cell.number, " of '", cell.mesh.name,
                          "': no strain across leaves a sheet of its law without stress there; "
                          "take neo_hooke, or shorter steps"));
}

Eigen::Vector4d true_stress(const Components& H, const Components& P) {
  Eigen::Matrix2d F;
  F << 1 + H(0), H(1), H(2), 1 + H(3);
  Eigen::Matrix2d piola;
  piola << P(0), P(1), P(2), P(3);
  const double area = 1 + area_change(H);
  const Eigen::Matrix2d stress = piola * F.transpose() / (area * (1 + H(4)));
  return {stress(0, 0), stress(1, 1), (stress(0, 1) + stress(1, 0)) / 2, P(4) / area};
}

/// F of the plane block, as components.
Components deformation(const Components& H) {
  return H + (Components() << 1, 0, 0, 1, 0).finished();
}

/// Maps and gradients at the points of a cell.
void sample(const Cell& cell, const CellVector& displacement, std::vector<Place>& places) {
  thread_local StrainPoints points;
  cell.element.strain(cell.body, points);
  places.resize(static_cast<std::size_t>(points.size));
  for (std::size_t q = 0; q < places.size(); ++q) {
    Place& at = places[q];
    at.volume = points.point[q].volume;
    write_map(points.point[q].B, at.G);
    at.H = at.G * displacement;
    require_upright(cell, std::min(1 + area_change(at.H), 1 + at.H(4)));
  }
}

/// Takes G to the scaled gradient, and adds the second derivative of that gradient to the tangent of a cell.
void scale_map(const MeanVolume& mean, std::size_t q, const Components& piola, Place& at,
               CellMatrix& tangent) {
  Components F = deformation(at.H);  // that is scaled already
  F(4) = 0;
  const CellVector& g = mean.gradient[q];
  at.G.topRows<4>() *= std::exp(mean.log[q]);
  const CellVector pushed = at.G.topRows<4>().transpose() * piola.head<4>();
  tangent += at.volume * (pushed * g.transpose() + g * pushed.transpose() +
                          piola.dot(F) * (g * g.transpose() + mean.curvature[q]));
  at.G += F * g.transpose();
}

/// \f$ w G^T P \f$ and \f$ w G^T A G \f$ of a point, with the number of unknowns as a constant, so that products are
/// unrolled: lazily, or Eigen takes those of eight unknowns for large ones.
template <int n>
void add_point(const Place& at, const StressResponse& response, CellAnswer& answer) {
  const Eigen::Map<const Eigen::Matrix<double, 5, n>> G(at.G.data());
  const Eigen::Matrix<double, 5, n> pushed = at.volume * response.tangent.lazyProduct(G);
  Eigen::Map<Eigen::Matrix<double, n, 1>>(answer.force.data()) +=
      at.volume * (G.transpose() * response.piola);
  Eigen::Map<Eigen::Matrix<double, n, n>>(answer.tangent.data()) +=
      G.transpose().lazyProduct(pushed);
}

void add_point(const Place& at, const StressResponse& response, CellAnswer& answer) {
  switch (at.G.cols()) {
    case 6: return add_point<6>(at, response, answer);
    case 8: return add_point<8>(at, response, answer);
    case 12: return add_point<12>(at, response, answer);
    default: return add_point<16>(at, response, answer);
  }
}

}  // namespace

void finite_answer(HyperelasticLaw law, const Cell& cell, const CellVector& displacement,
                   CellAnswer& answer) {
  thread_local std::vector<Place> places;
  thread_local MeanVolume mean;
  const Lame lame = lame_of(cell.material);
  const bool sheet = cell.material.state == PlaneState::Stress;
  const bool averaged = cell.element.mean_volume;
  const Index n = displacement.size();
  sample(cell, displacement, places);
  if (averaged) mean_volume(places, !sheet, mean);
  answer.force.setZero(n);
  answer.tangent.setZero(n, n);
  answer.stress.resize(static_cast<Index>(places.size()), 4);
  answer.energy = 0;
  for (std::size_t q = 0; q < places.size(); ++q) {
    Place& at = places[q];
    StressResponse response;
    if (averaged) at.H.head<4>() += std::expm1(mean.log[q]) * deformation(at.H).head<4>();
    if (sheet)
      release_across(law, cell, lame, at.H, response);
    else
      law(lame, at.H, response);
    if (averaged) scale_map(mean, q, response.piola, at, answer.tangent);
    add_point(at, response, answer);
    answer.stress.row(static_cast<Index>(q)) = true_stress(at.H, response.piola).transpose();
    answer.energy += at.volume * response.energy;
  }
  answer.tangent = (0.5 * (answer.tangent + CellMatrix(answer.tangent.transpose()))).eval();
}

}  // namespace signorini
