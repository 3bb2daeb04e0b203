// # A cell under finite strain
//
// The energy of a cell is \f$ \sum_q w_q W(F_q) \f$ over its points, with volumes \f$ w_q \f$ before strain. With the linear
// map G from displacements to gradients, \f$ H = Gu \f$, its first and second derivatives are
// \f[ f = \sum_q w_q G^T P, \qquad K = \sum_q w_q G^T \frac{\partial P}{\partial H} G. \f]
// That is all, for an element whose gradients are those of its shape functions.
//
// *Plane stress.* The strain across is what leaves no stress there: one equation per point, by Newton's method, after which
// the fifth component is eliminated from the tangent.

#include "addons/motion/finite_strain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "addons/motion/law_limits.hpp"
#include "addons/motion/mean_volume.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {
namespace {

using Eigen::Index;

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

/// Finds the strain across that leaves no stress there, and takes it out of the tangent.
void release_across(HyperelasticLaw law, const Cell& cell, const Lame& lame, Components& H,
                    StressResponse& response) {
  constexpr int most_tries = 50;  // each doubles the digits, behind a few that only come closer
  const double nu = cell.material.poisson_ratio;
  H(4) = std::expm1(-nu / (1 - nu) * std::log1p(area_change(H)));
  for (int k = 0; k < most_tries; ++k) {
    law(lame, H, response);
    if (!(response.tangent(4, 4) > 0)) break;
    const double change = std::max(-response.piola(4) / response.tangent(4, 4), -0.5 * (1 + H(4)));
    H(4) += change;
    if (!(std::abs(change) <= epsilon * std::max(1 + H(4), std::abs(H(4))))) continue;
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
  using InPlane = Eigen::Map<const Eigen::Matrix<double, 2, 2, Eigen::RowMajor>>;
  const Eigen::Matrix2d F = InPlane(H.data()) + Eigen::Matrix2d::Identity();
  const double area = 1 + area_change(H);
  const Eigen::Matrix2d stress = InPlane(P.data()) * F.transpose() / (area * (1 + H(4)));
  return {stress(0, 0), stress(1, 1), (stress(0, 1) + stress(1, 0)) / 2, P(4) / area};
}

/// Maps and gradients at the points of a cell.
void sample(const Cell& cell, const CellVector& displacement, std::vector<CellPlace>& places) {
  thread_local StrainPoints points;
  cell.element.strain(cell.body, points);
  places.resize(static_cast<std::size_t>(points.size));
  for (std::size_t q = 0; q < places.size(); ++q) {
    CellPlace& at = places[q];
    at.volume = points.point[q].volume;
    write_map(points.point[q].B, at.G);
    at.H = at.G * displacement;
    require_input(std::min(1 + area_change(at.H), 1 + at.H(4)) > 0, "cell ", cell.number, " of '",
                  cell.mesh.name, "', at (", cell.body.middle.x(), ", ", cell.body.middle.y(),
                  ") before it moved, inverts: take shorter steps, or a finer mesh there");
  }
}

/// Asks a law at the points of a cell, and hands on what it says: the number of the point, the mean change of volume if that
/// is averaged, the point and the response.
template <typename Use>
void ask_points(HyperelasticLaw law, const Cell& cell, const CellVector& displacement, const Use& use) {
  thread_local std::vector<CellPlace> places;
  thread_local MeanVolume mean;
  const Lame lame = lame_of(cell.material);
  const bool sheet = cell.material.state == PlaneState::Stress;
  const bool averaged = cell.element.mean_volume;
  sample(cell, displacement, places);
  if (averaged) mean_volume(places, !sheet, mean);
  for (std::size_t q = 0; q < places.size(); ++q) {
    CellPlace& at = places[q];
    StressResponse response;
    if (averaged) scale_gradient(mean, q, at);
    if (sheet)
      release_across(law, cell, lame, at.H, response);
    else
      law(lame, at.H, response);
    use(q, averaged ? &mean : nullptr, at, response);
  }
}

/// \f$ w G^T P \f$ and \f$ w G^T A G \f$ of a point, with the number of unknowns as a constant, so that products are
/// unrolled: lazily, or Eigen takes those of eight unknowns for large ones.
template <int n>
void add_point(const CellPlace& at, const StressResponse& response, CellAnswer& answer) {
  const Eigen::Map<const Eigen::Matrix<double, 5, n>> G(at.G.data());
  const Eigen::Matrix<double, 5, n> pushed = at.volume * response.tangent.lazyProduct(G);
  Eigen::Map<Eigen::Matrix<double, n, 1>>(answer.force.data()) +=
      at.volume * (G.transpose() * response.piola);
  Eigen::Map<Eigen::Matrix<double, n, n>>(answer.tangent.data()) +=
      G.transpose().lazyProduct(pushed);
}

void add_point(const CellPlace& at, const StressResponse& response, CellAnswer& answer) {
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
  const Index n = displacement.size();
  answer.force.setZero(n);
  answer.tangent.setZero(n, n);
  answer.energy = 0;
  ask_points(law, cell, displacement,
             [&](std::size_t q, const MeanVolume* mean, CellPlace& at, const StressResponse& response) {
               answer.stress.conservativeResize(static_cast<Index>(q) + 1, 4);
               if (mean != nullptr) scale_map(*mean, q, response.piola, at, answer.tangent);
               add_point(at, response, answer);
               answer.stress.row(static_cast<Index>(q)) = true_stress(at.H, response.piola).transpose();
               answer.energy += at.volume * response.energy;
             });
  answer.tangent = (0.5 * (answer.tangent + CellMatrix(answer.tangent.transpose()))).eval();
}

double finite_stability(HyperelasticLaw law, const Cell& cell, const CellVector& displacement) {
  double least = std::numeric_limits<double>::infinity();
  ask_points(law, cell, displacement,
             [&](std::size_t, const MeanVolume*, CellPlace&, const StressResponse& response) {
               least = std::min(least, least_wave_stiffness(response));
             });
  return least;
}

}  // namespace signorini
