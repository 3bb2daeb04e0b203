#include "signorini/problem/residual.hpp"

#include <algorithm>
#include <utility>

#include "signorini/core/errors.hpp"
#include "signorini/problem/exact_sum.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Columns = Eigen::SparseMatrix<double>;

/// Whether u carries a second, smaller part.
bool has_low(const PrimalDual& solution) { return solution.displacement_low.size() > 0; }

/// u as the sum of two vectors, and what the residual is made of beside it.
struct Terms {
  const QuadraticProgramme& programme;
  const VectorXd& force;
  Columns A;  // by columns, as the equilibrium of an unknown needs it
  VectorXd high;
  VectorXd low;
};

/// u without its rigid part: the difference is exact.
Terms terms_of(const QuadraticProgramme& programme, const PrimalDual& solution) {
  Terms terms{programme, solution.force, programme.A, solution.displacement,
              solution.displacement_low};
  if (!has_low(solution)) terms.low.setZero(terms.high.size());
  for (Index i = 0; i < solution.rigid.size(); ++i) {
    ExactSum difference(terms.high(i));
    difference.add(-solution.rigid(i));
    terms.high(i) = difference.high();
    terms.low(i) += difference.low();
  }
  return terms;
}

/// Whether this and the next column of K have entries in the same rows, as the unknowns of a node mostly have.
bool twins(const Columns& K, Index column) {
  if (column + 1 >= K.cols() || !K.isCompressed()) return false;
  const int* const outer = K.outerIndexPtr() + column;
  const int* const inner = K.innerIndexPtr();
  return outer[1] - outer[0] == outer[2] - outer[1] &&
         std::equal(inner + outer[0], inner + outer[1], inner + outer[1]);
}

/// The residual of one unknown, or of two that are twins side by side: that takes half of the time. K has both triangles, so
/// columns serve as rows.
template <int rows>
void fill_residual(const Terms& terms, Index row, VectorXd& residual) {
  using Numbers = Eigen::Array<double, rows, 1>;
  const Columns& K = terms.programme.stiffness;
  const double* const values = K.valuePtr() + K.outerIndexPtr()[row];
  const int* const inner = K.innerIndexPtr() + K.outerIndexPtr()[row];
  const Index count = K.col(row).nonZeros();
  ExactSumOf<Numbers> sum(terms.programme.load.segment<rows>(row), Numbers::Zero());
  Numbers small = Numbers::Zero();
  for (Index k = 0; k < count; ++k) {
    Numbers entry;
    for (int r = 0; r < rows; ++r) entry(r) = values[r * count + k];
    sum.add_product(-entry, Numbers::Constant(terms.high(inner[k])));
    small += entry * terms.low(inner[k]);
  }
  sum.add(-small);
  for (int r = 0; r < rows; ++r) {
    ExactSum one(sum.high()(r), sum.low()(r));
    for (Columns::InnerIterator entry(terms.A, row + r); entry; ++entry)
      one.add_product(-entry.value(), terms.force(entry.row()));
    residual(row + r) = one.value();
  }
}

}  // namespace

void check_sizes(const QuadraticProgramme& programme, const PrimalDual& solution) {
  const Index n = programme.load.size();
  const Index pairs = programme.initial_gap.size();
  require_argument(programme.stiffness.rows() == n && programme.stiffness.cols() == n &&
                       programme.A.rows() == pairs && programme.A.cols() == n,
                   "certify: K must be ", n, " x ", n, " and A ", pairs, " x ", n, ", got ",
                   programme.stiffness.rows(), " x ", programme.stiffness.cols(), " and ",
                   programme.A.rows(), " x ", programme.A.cols());
  require_argument(solution.displacement.size() == n && solution.force.size() == pairs &&
                       (!has_low(solution) || solution.displacement_low.size() == n) &&
                       (solution.rigid.size() == 0 || solution.rigid.size() == n),
                   "certify: need ", n, " displacements and ", pairs, " forces, got ",
                   solution.displacement.size(), " and ", solution.force.size());
}

void add_displacement(PrimalDual& solution, const VectorXd& change) {
  for (Index i = 0; i < change.size(); ++i)
    add_to(solution.displacement(i), solution.displacement_low(i), change(i));
}

VectorXd strained(const PrimalDual& solution) {
  VectorXd u = solution.displacement;
  if (solution.rigid.size() > 0) u -= solution.rigid;
  if (has_low(solution)) u += solution.displacement_low;
  return u;
}

VectorXd equilibrium_residual(const QuadraticProgramme& programme, const PrimalDual& solution) {
  check_sizes(programme, solution);
  const Terms terms = terms_of(programme, solution);
  VectorXd residual(programme.load.size());
  for (Index i = 0; i < residual.size(); ++i)
    if (twins(programme.stiffness, i))
      fill_residual<2>(terms, i++, residual);
    else
      fill_residual<1>(terms, i, residual);
  return residual;
}

VectorXd gaps(const QuadraticProgramme& programme, const PrimalDual& solution) {
  check_sizes(programme, solution);
  VectorXd gap(programme.initial_gap.size());
  for (Index pair = 0; pair < gap.size(); ++pair) {
    ExactSum sum(programme.initial_gap(pair));
    for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(programme.A, pair);
         entry; ++entry) {
      sum.add_product(-entry.value(), solution.displacement(entry.col()));
      if (has_low(solution)) sum.add(-entry.value() * solution.displacement_low(entry.col()));
    }
    gap(pair) = sum.value();
  }
  return gap;
}

}  // namespace signorini
