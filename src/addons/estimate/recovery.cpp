#include "addons/estimate/recovery.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

#include "addons/estimate/stress_samples.hpp"
#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d;

/// Numbers of the nodes of cells, other ones for every material. \param[out] count  of the numbers
CellArray numbered_by_material(const Mesh& mesh, const MaterialField& material, Index& count) {
  CellArray cells = mesh.cells;
  count = mesh.n_nodes();
  if (material.number_of.empty()) return cells;
  std::vector<Index> number(at(mesh.n_nodes()), -1);
  count = 0;
  for (std::size_t k = 0; k <= material.others.size(); ++k) {
    std::fill(number.begin(), number.end(), -1);
    for (Index cell = 0; cell < cells.rows(); ++cell) {
      if (material.number(cell) != k) continue;
      for (Index i = 0; i < mesh.cell_size(cell); ++i) {
        Index& own = number[at(mesh.cells(cell, i))];
        if (own < 0) own = count++;
        cells(cell, i) = own;
      }
    }
  }
  return cells;
}

/// The cells around every corner, one list after the other.
struct Around {
  std::vector<Index> first;  // of the lists, and the end of the last
  std::vector<Index> cell;

  Around(const Mesh& mesh, const CellArray& cells, Index count) : first(at(count) + 1, 0) {
    const auto each = [&](auto&& visit) {
      for (Index c = 0; c < cells.rows(); ++c)
        for (int k = 0; k < mesh.corners(c); ++k) visit(at(cells(c, k)), c);
    };
    each([&](std::size_t node, Index) { ++first[node + 1]; });
    for (std::size_t node = 0; node < at(count); ++node) first[node + 1] += first[node];
    cell.resize(at(first.back()));
    std::vector<Index> next(first.begin(), first.end() - 1);
    each([&](std::size_t node, Index c) { cell[at(next[node]++)] = c; });
  }
};

/// Whether cells surround a corner: then each of its sides belongs to two of them, and there are as many sides as cells.
bool surrounded(const Mesh& mesh, const CellArray& cells, const Around& around, Index node) {
  const Index begin = around.first[at(node)], end = around.first[at(node) + 1];
  const auto follows = [&](Index c, int step) {  // the corner after this one, or before it
    const int n = mesh.corners(c);
    int k = 0;
    while (cells(c, k) != node) ++k;
    return cells(c, (k + n + step) % n);
  };
  for (Index a = begin; a < end; ++a) {
    const Index next = follows(around.cell[at(a)], 1);
    bool shared = false;
    for (Index b = begin; b < end && !shared; ++b)
      shared = b != a && follows(around.cell[at(b)], -1) == next;
    if (!shared) return false;
  }
  return begin < end;
}

/// Monomials of a polynomial in the plane.
template <int n_terms>
Eigen::Matrix<double, n_terms, 1> monomials(const Vector2d& x) {
  static_assert(n_terms == 3 || n_terms == 6, "linear or quadratic");
  Eigen::Matrix<double, n_terms, 1> terms;
  terms.template head<3>() << 1, x.x(), x.y();
  if constexpr (n_terms == 6)
    terms.template tail<3>() << x.x() * x.x(), x.x() * x.y(), x.y() * x.y();
  return terms;
}

/// A polynomial around a node. It is fitted in coordinates in which the samples are spread evenly, so that flat cells
/// do as well as square ones: which polynomial fits best does not depend on the coordinates.
template <int n_terms>
class Patch {
 public:
  explicit Patch(Index columns) : right_(n_terms, columns) {}

  /// \return whether there is one polynomial that fits best
  bool fit(const StressSamples& samples, const Around& around, Index node, const Vector2d& origin) {
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    origin_ = origin;
    int count = 0;
    each(samples, around, node, [&](Index row) {
      const Vector2d arm = samples.place[at(row)] - origin;
      spread += arm * arm.transpose();
      ++count;
    });
    // Its inverse root, from the corner of the matrix: L^-1 of spread = L L^T.
    const double xx = std::sqrt(spread(0, 0)), xy = spread(0, 1) / xx;
    const double yy = std::sqrt(spread(1, 1) - xy * xy), size = std::sqrt(double(count));
    if (!(xx > 0) || !(yy > std::sqrt(std::numeric_limits<double>::epsilon()) * std::abs(xy)))
      return false;
    even_ << size / xx, 0, -size * xy / (xx * yy), size / yy;
    normal_.setZero();
    right_.setZero();
    each(samples, around, node, [&](Index row) {
      const Eigen::Matrix<double, n_terms, 1> terms = at_place(samples.place[at(row)]);
      normal_ += terms * terms.transpose();
      right_.noalias() += terms * samples.value.row(row);
    });
    factor_.compute(normal_);
    const auto pivots = factor_.matrixLLT().diagonal().array();
    if (factor_.info() != Eigen::Success ||
        !(pivots.minCoeff() >
          std::sqrt(std::numeric_limits<double>::epsilon()) * pivots.maxCoeff()))
      return false;
    factor_.solveInPlace(right_);
    return true;
  }

  /// Adds what the polynomial says at a place.
  template <typename Row>
  void add(const Vector2d& place, Row&& row) const {
    row.noalias() += at_place(place).transpose() * right_;
  }

 private:
  template <typename Visit>
  static void each(const StressSamples& samples, const Around& around, Index node, Visit&& visit) {
    for (Index a = around.first[at(node)]; a < around.first[at(node) + 1]; ++a) {
      const Index cell = around.cell[at(a)];
      for (int i = 0; i < samples.count[at(cell)]; ++i) visit(cell * StressSamples::most + i);
    }
  }
  [[nodiscard]] Eigen::Matrix<double, n_terms, 1> at_place(const Vector2d& place) const {
    return monomials<n_terms>(even_ * (place - origin_));
  }

  Vector2d origin_;
  Eigen::Matrix2d even_;
  Eigen::Matrix<double, n_terms, n_terms> normal_;
  Eigen::LLT<Eigen::Matrix<double, n_terms, n_terms>> factor_;
  Eigen::Matrix<double, n_terms, Eigen::Dynamic, Eigen::RowMajor> right_;
};

/// Smooth stresses as they are collected.
struct Collected {
  const Mesh& mesh;
  const StressSamples& samples;
  SmoothStress& smooth;
  std::vector<Index> node;       // of the mesh, of each number
  std::vector<int> polynomials;  // that have spoken at each number

  Collected(const Mesh& of, const StressSamples& sampled, Index count, SmoothStress& into)
      : mesh(of), samples(sampled), smooth(into), node(at(count), 0), polynomials(at(count), 0) {
    smooth.value.setZero(count, samples.value.cols());
    for (Index c = 0; c < smooth.cells.rows(); ++c)
      for (Index k = 0; k < mesh.cell_size(c); ++k) node[at(smooth.cells(c, k))] = mesh.cells(c, k);
  }
  [[nodiscard]] Vector2d place(Index i) const { return mesh.nodes.row(node[at(i)]).transpose(); }

  /// Fits a polynomial around every corner inside, for itself and those around it that are not.
  template <int n_terms>
  void fit() {
    const CellArray& cells = smooth.cells;
    const Index count = smooth.value.rows();
    const Around around(mesh, cells, count);
    std::vector<signed char> inside(at(count));
    for (Index i = 0; i < count; ++i) inside[at(i)] = surrounded(mesh, cells, around, i) ? 1 : 0;
    std::vector<Index> last(at(count), -1);  // of the polynomials that have spoken
    Patch<n_terms> patch(samples.value.cols());
    for (Index i = 0; i < count; ++i) {
      if (inside[at(i)] == 0 || !patch.fit(samples, around, i, place(i))) continue;
      const auto speak = [&](Index to) {
        patch.add(place(to), smooth.value.row(to));
        ++polynomials[at(to)];
      };
      speak(i);
      for (Index a = around.first[at(i)]; a < around.first[at(i) + 1]; ++a) {
        const Index c = around.cell[at(a)];
        for (Index k = 0; k < mesh.cell_size(c); ++k) {
          const Index other = cells(c, k);
          if (inside[at(other)] != 0 || last[at(other)] == i) continue;
          last[at(other)] = i;
          speak(other);
        }
      }
    }
  }

  /// Takes means: of what polynomials said, or of the cells where none did.
  void average() {
    std::vector<int> spoken = polynomials;
    for (Index c = 0; c < smooth.cells.rows(); ++c)
      for (Index k = 0; k < mesh.cell_size(c); ++k) {
        const Index i = smooth.cells(c, k);
        if (polynomials[at(i)] > 0) continue;
        for (int s = 0; s < samples.count[at(c)]; ++s)
          smooth.value.row(i) += samples.value.row(c * StressSamples::most + s);
        spoken[at(i)] += samples.count[at(c)];
      }
    for (Index i = 0; i < smooth.value.rows(); ++i)
      if (spoken[at(i)] > 1) smooth.value.row(i) /= spoken[at(i)];
  }
};

}  // namespace

SmoothStress recovered(const PrimalAndDuals& fields) {
  check_primal_and_duals(fields);
  SmoothStress smooth;
  Index count = 0;
  smooth.cells = numbered_by_material(fields.mesh, fields.material, count);
  smooth.strains = element_strains(fields);
  const StressSamples samples = sampled(fields, smooth.strains);
  Collected collected(fields.mesh, samples, count, smooth);
  if (fields.mesh.order() == MeshOrder::Linear)
    collected.fit<3>();
  else
    collected.fit<6>();
  collected.average();
  return smooth;
}

}  // namespace signorini
