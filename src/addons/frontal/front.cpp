#include "addons/frontal/front.hpp"

#include <algorithm>
#include <cmath>

namespace signorini {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using Block = Eigen::Ref<MatrixXd>;
using Constant = Eigen::Ref<const MatrixXd>;

constexpr Index tile = 4;   // sums of a tile stay in registers
constexpr Index wide = 64;  // columns from which Eigen's products are faster than tiles

/// C -= X Y^T on one tile, X and Y given by the first of their columns.
void subtract_tile(const double* x, const double* y, Index stride, Index depth, double* c,
                   Index c_stride) {
  Eigen::Matrix<double, tile, tile> sum = Eigen::Matrix<double, tile, tile>::Zero();
  for (Index k = 0; k < depth; ++k, x += stride, y += stride)
    for (Index j = 0; j < tile; ++j)
      sum.col(j) += Eigen::Map<const Eigen::Matrix<double, tile, 1>>(x) * y[j];
  for (Index j = 0; j < tile; ++j)
    Eigen::Map<Eigen::Matrix<double, tile, 1>>(c + j * c_stride) -= sum.col(j);
}

/// The same where less than a tile is left.
void subtract_edge(const double* x, const double* y, Index stride, Index depth, double* c,
                   Index c_stride, Index rows, Index columns) {
  for (Index k = 0; k < depth; ++k, x += stride, y += stride)
    for (Index j = 0; j < columns; ++j)
      for (Index i = 0; i < rows; ++i) c[j * c_stride + i] -= x[i] * y[j];
}

/// C -= X X^T where C is as high as X and has its first columns only; nothing above the tiles on the diagonal.
void subtract_square(const Constant& X, Block C) {
  if (X.cols() == 0) return;
  const Index height = C.rows();
  for (Index j = 0; j < C.cols(); j += tile) {
    const Index columns = std::min(tile, C.cols() - j);
    for (Index i = j; i < height; i += tile) {
      const Index rows = std::min(tile, height - i);
      const double* x = X.data() + i;
      const double* y = X.data() + j;
      double* c = &C(i, j);
      if (rows == tile && columns == tile)
        subtract_tile(x, y, X.outerStride(), X.cols(), c, C.outerStride());
      else
        subtract_edge(x, y, X.outerStride(), X.cols(), c, C.outerStride(), rows, columns);
    }
  }
}

/// Eliminates few columns, one after another.
Index eliminate_tile(Block L, const Eigen::Ref<const VectorXd>& least) {
  for (Index j = 0; j < L.cols(); ++j) {
    const Index below = L.rows() - j - 1;
    if (!(L(j, j) > least(j))) return j;
    L(j, j) = std::sqrt(L(j, j));
    L.col(j).tail(below) /= L(j, j);
    for (Index k = j + 1; k < L.cols(); ++k)
      L.col(k).tail(L.rows() - k) -= L(k, j) * L.col(j).tail(L.rows() - k);
  }
  return L.cols();
}

/// Eliminates columns tile by tile; each is first brought up to date with those before it.
Index eliminate_narrow(Block L, const Eigen::Ref<const VectorXd>& least) {
  for (Index j = 0; j < L.cols(); j += tile) {
    const Index columns = std::min(tile, L.cols() - j);
    const Index below = L.rows() - j;
    subtract_square(L.block(j, 0, below, j), L.block(j, j, below, columns));
    const Index done = eliminate_tile(L.block(j, j, below, columns), least.segment(j, columns));
    if (done < columns) return j + done;
  }
  return L.cols();
}

}  // namespace

Index eliminate(Block columns, Block update, const Eigen::Ref<const VectorXd>& least) {
  const Index own = columns.cols();
  const Index rim = update.rows();
  for (Index j = 0; j < own; j += wide) {
    const Index width = std::min(wide, own - j);
    const Index rest = own - j - width;
    const Index done =
        eliminate_narrow(columns.block(j, j, own + rim - j, width), least.segment(j, width));
    if (done < width) return j + done;
    const Block pivots = columns.block(j + width, j, rest, width);
    if (rest > 0) {
      columns.block(j + width, j + width, rest, rest)
          .selfadjointView<Eigen::Lower>()
          .rankUpdate(pivots, -1);
      columns.block(own, j + width, rim, rest).noalias() -=
          columns.block(own, j, rim, width) * pivots.transpose();
    }
  }
  const Block below = columns.bottomRows(rim);
  if (own < wide)
    subtract_square(below, update);
  else
    update.selfadjointView<Eigen::Lower>().rankUpdate(below, -1);
  return own;
}

}  // namespace signorini
