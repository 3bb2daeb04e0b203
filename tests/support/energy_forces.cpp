#include "support/energy_forces.hpp"

#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "signorini/fem/strain_law.hpp"

namespace signorini_test {
namespace {

using namespace signorini;
using Eigen::Index;
using Real = long double;
using Complex = std::complex<Real>;
using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

/// Far below the rounding of any number that it is added to.
constexpr Real small_step = 1e-60L;

/// The gradient of a deformation: the block in the plane, and what is across.
template <typename Number>
struct Deformation {
  Number F11, F12, F21, F22, F33;
};

/// A law by its energy per volume.
struct Energy {
  bool rubber;
  Real lambda;
  Real mu;

  template <typename Number>
  [[nodiscard]] Number operator()(const Deformation<Number>& F) const {
    using std::log;
    const Number C11 = F.F11 * F.F11 + F.F21 * F.F21;
    const Number C12 = F.F11 * F.F12 + F.F21 * F.F22;
    const Number C22 = F.F12 * F.F12 + F.F22 * F.F22;
    const Number C33 = F.F33 * F.F33;
    if (rubber) {
      const Number log_J = log((F.F11 * F.F22 - F.F12 * F.F21) * F.F33);
      return mu / 2 * (C11 + C22 + C33 - Real(3) - Real(2) * log_J) + lambda / 2 * log_J * log_J;
    }
    const Number E11 = (C11 - Real(1)) / Real(2);
    const Number E22 = (C22 - Real(1)) / Real(2);
    const Number E33 = (C33 - Real(1)) / Real(2);
    const Number E12 = C12 / Real(2);
    const Number trace = E11 + E22 + E33;
    return lambda / 2 * trace * trace +
           mu * (E11 * E11 + E22 * E22 + E33 * E33 + Real(2) * E12 * E12);
  }
};

Energy energy_of(const Material& material) {
  const Real E = material.youngs_modulus;
  const Real nu = material.poisson_ratio;
  return {material.law->name == std::string("neo_hooke"), E * nu / ((1 + nu) * (1 - 2 * nu)),
          E / (2 * (1 + nu))};
}

/// The stretch across that leaves a sheet without stress there.
Real free_stretch(const Energy& energy, const Deformation<Complex>& F) {
  const Real J = F.F11.real() * F.F22.real() - F.F12.real() * F.F21.real();
  const Real squares = std::norm(F.F11.real()) + std::norm(F.F12.real()) + std::norm(F.F21.real()) +
                       std::norm(F.F22.real());
  if (!energy.rubber)
    return std::sqrt(1 - energy.lambda / (energy.lambda + 2 * energy.mu) * (squares - 2));
  // mu (e^2t - 1) + lambda (ln J + t) = 0 is convex in t: Newton's method comes from the right after one step.
  Real t = 0;
  Real change = 1;
  for (int k = 0; k < 60 && std::abs(change) > 1e-17L; ++k) {
    change = (energy.mu * std::expm1(2 * t) + energy.lambda * (std::log(J) + t)) /
             (2 * energy.mu * std::exp(2 * t) + energy.lambda);
    t -= change;
  }
  return std::exp(t);
}

/// Powers of the monomials that a cell of so many nodes has.
std::vector<std::pair<int, int>> monomials(Index nodes) {
  std::vector<std::pair<int, int>> all = {{0, 0}, {1, 0}, {0, 1}};
  if (nodes > 4) all.insert(all.end(), {{2, 0}, {0, 2}});
  if (nodes != 3) all.emplace_back(1, 1);
  if (nodes == 8) all.insert(all.end(), {{2, 1}, {1, 2}});
  return all;
}

Real power(Real x, int n) { return n < 0 ? 0 : std::pow(x, static_cast<Real>(n)); }

/// Corners of the square or the triangle, then midpoints of sides.
RealMatrix reference_places(Index nodes) {
  const Index corners = nodes % 3 == 0 ? 3 : 4;
  RealMatrix places(nodes, 2);
  if (corners == 3)
    places.topRows(3) << 0, 0, 1, 0, 0, 1;
  else
    places.topRows(4) << -1, -1, 1, -1, 1, 1, -1, 1;
  for (Index k = corners; k < nodes; ++k)
    places.row(k) = (places.row(k - corners) + places.row((k - corners + 1) % corners)) / 2;
  return places;
}

/// Values and slopes of shape functions at a place: columns N, dN/dxi, dN/deta.
RealMatrix shape_at(Index nodes, Real xi, Real eta) {
  const auto powers = monomials(nodes);
  const RealMatrix places = reference_places(nodes);
  RealMatrix at_nodes(nodes, nodes);
  RealMatrix here(nodes, 3);
  for (Index j = 0; j < nodes; ++j) {
    const auto [a, b] = powers[static_cast<std::size_t>(j)];
    for (Index k = 0; k < nodes; ++k)
      at_nodes(j, k) = power(places(k, 0), a) * power(places(k, 1), b);
    here(j, 0) = power(xi, a) * power(eta, b);
    here(j, 1) = a * power(xi, a - 1) * power(eta, b);
    here(j, 2) = b * power(xi, a) * power(eta, b - 1);
  }
  return at_nodes.fullPivLu().solve(here);
}

const std::vector<GaussPoint>& rule_of(Index nodes) {
  if (nodes == 3) return gauss_triangle(3);
  if (nodes == 6) return gauss_triangle(6);
  return gauss_square(nodes == 4 ? 2 : 3);
}

/// A point of a cell before it moved.
struct Place {
  Real volume;
  Real radius;  // 0: none
  RealVector value;
  RealMatrix gradient;  // `m x 2`
};

std::vector<Place> places_of(const RealMatrix& X, const Material& material) {
  const bool axial = material.state == PlaneState::Axial;
  std::vector<Place> places;
  for (const GaussPoint& point : rule_of(X.rows())) {
    const RealMatrix N = shape_at(X.rows(), point.xi, point.eta);
    const RealMatrix jacobian = X.transpose() * N.rightCols(2);
    const Real radius = axial ? X.col(0).dot(N.col(0)) : 0;
    const Real depth = axial ? 2 * std::acos(Real(-1)) * radius : material.thickness;
    places.push_back({point.weight * jacobian.determinant() * depth, radius, N.col(0),
                      N.rightCols(2) * jacobian.inverse()});
  }
  return places;
}

using Displacements = Eigen::Matrix<Complex, Eigen::Dynamic, 2>;

Deformation<Complex> deformation(const Place& at, const Displacements& u) {
  Complex H11 = 0, H12 = 0, H21 = 0, H22 = 0, out = 0;
  for (Index k = 0; k < u.rows(); ++k) {
    H11 += u(k, 0) * at.gradient(k, 0);
    H12 += u(k, 0) * at.gradient(k, 1);
    H21 += u(k, 1) * at.gradient(k, 0);
    H22 += u(k, 1) * at.gradient(k, 1);
    out += u(k, 0) * at.value(k);
  }
  const Real one = 1;
  return {one + H11, H12, H21, one + H22, at.radius > 0 ? one + out / at.radius : Complex(1)};
}

/// The energy of a cell.
struct CellEnergy {
  Energy law;
  bool sheet;
  bool averaged;
  std::vector<Place> places;

  [[nodiscard]] Complex operator()(const Displacements& u) const {
    const auto change = [this](const Deformation<Complex>& F) {
      const Complex area = F.F11 * F.F22 - F.F12 * F.F21;
      return sheet ? area : area * F.F33;
    };
    Complex mean = 0;
    Real whole = 0;
    for (const Place& at : places) {
      mean += at.volume * change(deformation(at, u));
      whole += at.volume;
    }
    Complex sum = 0;
    for (const Place& at : places) {
      Deformation<Complex> F = deformation(at, u);
      if (averaged) {
        const Complex r = std::sqrt(mean / whole / change(F));
        F = {r * F.F11, r * F.F12, r * F.F21, r * F.F22, F.F33};
      }
      // It makes the energy least, so that its own derivatives do not count.
      if (sheet) F.F33 = free_stretch(law, F);
      sum += at.volume * law(F);
    }
    return sum;
  }
};

}  // namespace

LongNodes energy_forces(const Mesh& mesh, const Element& element, const Material& material,
                        const LongNodes& u) {
  LongNodes forces = LongNodes::Zero(mesh.n_nodes(), 2);
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const Index m = mesh.cell_size(cell);
    RealMatrix X(m, 2);
    Displacements own(m, 2);
    for (Index k = 0; k < m; ++k) {
      X.row(k) = mesh.nodes.row(mesh.cells(cell, k)).cast<Real>();
      own.row(k) = (u.row(mesh.cells(cell, k))).cast<Complex>();
    }
    const CellEnergy energy{energy_of(material), material.state == PlaneState::Stress,
                            m == 4 && element.mean_volume, places_of(X, material)};
    for (Index k = 0; k < m; ++k)
      for (const Index axis : {0, 1}) {
        Displacements aside = own;
        aside(k, axis) += Complex(0, small_step);
        forces(mesh.cells(cell, k), axis) += energy(aside).imag() / small_step;
      }
  }
  return forces;
}

}  // namespace signorini_test
