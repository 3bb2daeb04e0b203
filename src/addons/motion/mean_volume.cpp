// # The mean change of volume of a cell
//
// Near incompressibility four points that each keep their volume are too many for a cell of four
// nodes. So F is replaced by \f$ \tilde F = rF \f$ in the plane, \f$ r = (\bar J/J)^{1/2} \f$: each point then has the mean
// change of volume. With \f$ \ell = \ln r \f$ and its gradient g, \f$ \delta\tilde F = r(\delta F + F\,\delta\ell) \f$, so G
// becomes \f$ r(G + F g^T) \f$, and the second derivative of \f$ \tilde F \f$ adds
// \f[ w\left[ r (G^T P\,g^T + g\,P^T G) + (P : \tilde F)\,(g g^T + \nabla\nabla\ell) \right] \f]
// to K. For small strain this is the element q4_bbar.

#include "addons/motion/mean_volume.hpp"

#include <cmath>

namespace signorini {
namespace {

using Eigen::Index;

/// Components of the derivative of det F, of the block in the plane.
Eigen::Vector4d cofactor(const Components& H) {
  return {1 + H(3), -H(2), -H(1), 1 + H(0)};
}

/// J - 1 at a point, and the derivatives of J; beyond the plane J is (1 + H33) times the area, but for plane stress, where H33
/// follows.
double volume_change(const CellPlace& at, bool across, CellVector& first, CellMatrix& second) {
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

}  // namespace

/// ln r = (ln of the mean of J - ln J) / 2.
void mean_volume(const std::vector<CellPlace>& places, bool across, MeanVolume& mean) {
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

void scale_gradient(const MeanVolume& mean, std::size_t q, CellPlace& at) {
  at.H.head<4>() += std::expm1(mean.log[q]) * deformation(at.H).head<4>();
}

void scale_map(const MeanVolume& mean, std::size_t q, const Components& piola, CellPlace& at,
               CellMatrix& tangent) {
  Components F = deformation(at.H);  // that is scaled already
  F(4) = 0;  // which is not averaged
  const CellVector& g = mean.gradient[q];
  at.G.topRows<4>() *= std::exp(mean.log[q]);
  const CellVector pushed = at.G.topRows<4>().transpose() * piola.head<4>();
  tangent += at.volume * (pushed * g.transpose() + g * pushed.transpose() +
                          piola.dot(F) * (g * g.transpose() + mean.curvature[q]));
  at.G += F * g.transpose();
}

}  // namespace signorini
