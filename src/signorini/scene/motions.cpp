// # Rigid motions of a scene
//
// Supports and springs take rigid motions away from a body. What is left is at most two
// shifts and a turn per piece of a mesh, and in axial symmetry one shift along the axis. For
// example, a body is held across a line of symmetry x = 0. A rigid motion moves the point
// (x, y) by
// \f[ (a - c\,y,\; b + c\,x). \f]
// On the line the first component must vanish for every y, so \f$ a = c = 0 \f$. One motion
// is left: b, along the line.
//
// Three questions follow. Which motions are there? Does contact notice all of them? Where do
// we ground the bodies, so that K can be factored in spite of them?

#include "signorini/scene/motions.hpp"

#include <algorithm>
#include <utility>

#include "signorini/core/dense.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/sparse_lu.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/fem/far.hpp"
#include "signorini/scene/rigid_modes.hpp"

namespace signorini {

using Eigen::Index;

namespace {

// A spring stops every motion that it resists, even a soft spring. So for this question its
// nodes count as held.
Unknowns held_by_springs(const BodyModel& body) {
  Unknowns unknowns = body.unknowns;
  for (Index k = 0; k < body.springs.cols(); ++k)
    if (body.springs.coeff(k, k) > 0) unknowns.number(k / 2, k % 2) = -1;
  return unknowns;
}

// The first unknown that a motion moves, and the one after the last. A mode is a vector of
// all unknowns, but it has entries of its own body only.
std::pair<Index, Index> moved_unknowns(const FreeMotion& mode) {
  const Index entries = mode.shape.nonZeros();
  if (entries == 0) return {mode.shape.size(), mode.shape.size()};
  const auto* const place = mode.shape.innerIndexPtr();
  return {place[0], place[entries - 1] + 1};
}

}  // namespace

// Formulas want a matrix N with one column per mode. Messages want the modes with their
// names. So both forms exist.
//
// Of many bodies N has few entries. A column is as long as all of them have unknowns, and one body
// moves. A thousand blocks of 18 unknowns that stand on rollers have a thousand motions: 18 million
// numbers, of which 9000 are not zero. The columns of N are written one after the other, and so
// nothing that is there has to move.
Eigen::SparseMatrix<double> mode_entries(const std::vector<FreeMotion>& modes) {
  Eigen::SparseMatrix<double> shapes(modes.empty() ? 0 : modes.front().shape.size(),
                                     static_cast<Index>(modes.size()));
  for (Index k = 0; k < shapes.cols(); ++k) shapes.col(k) = modes[at(k)].shape;
  return shapes;
}

// Dense methods want the zeros, too.
Eigen::MatrixXd mode_shapes(const std::vector<FreeMotion>& modes) { return mode_entries(modes); }

// The body whose directions are known worst decides for all, because a contact takes its
// normals from either side.
double direction_rounding(const std::vector<BodyModel>& bodies) {
  double most = 0;
  for (const BodyModel& body : bodies) most = std::max(most, direction_rounding(body.mesh));
  return most;
}

// Each mode carries this number, so that whoever has only the modes can ask for it.
double direction_rounding(const std::vector<FreeMotion>& modes) {
  double most = 0;
  for (const FreeMotion& mode : modes) most = std::max(most, mode.directions);
  return most;
}

// Each body finds its own motions, on its own unknowns. They are then written into vectors of all
// unknowns, where those of the body begin, without entries for the other bodies.
std::vector<FreeMotion> rigid_modes(const std::vector<BodyModel>& bodies) {
  const BodyModel& last = bodies.back();
  std::vector<FreeMotion> modes;
  for (const BodyModel& body : bodies)
    for (FreeMotion& mode :
         body.springs.rows() == 0
             ? free_motions(body.mesh, body.pieces, body.unknowns, body.material.base.state)
             : free_motions(body.mesh, body.pieces, held_by_springs(body),
                            body.material.base.state)) {
      Eigen::SparseVector<double> all(last.first_unknown + last.unknowns.count);
      all.reserve(mode.shape.nonZeros());
      for (Eigen::SparseVector<double>::InnerIterator it(mode.shape); it; ++it)
        all.insertBack(body.first_unknown + it.index()) = it.value();
      mode.shape.swap(all);
      modes.push_back(std::move(mode));
    }
  if (modes.empty()) return modes;
  // Contact may take its normals from any of the bodies.
  const double directions = direction_rounding(bodies);
  for (FreeMotion& mode : modes) mode.directions = directions;
  return modes;
}

// A motion that opens and closes no gap meets no resistance at all: the scene has no unique
// answer, and the user must add a support. One mode at a time is not enough. Of two blocks
// on top of each other, with one pair between them, the upper one may rise and so may the
// lower one, with \f$ R = (1, -1) \f$. Either moves the gap, but both together do not:
// \f$ R\,(1, 1)^T = 0 \f$. So we ask which columns of R depend on others, and say the
// combination in words.
//
// Nearly always none does. Columns of few entries say so for little: R has three per body, and the
// sparse matrix \f$ R^T R \f$ is factored. Only if that leaves a doubt are the columns taken
// dense, and orthogonalised one after the other.
std::vector<std::string> motions_without_contact(
    const Eigen::SparseMatrix<double, Eigen::RowMajor>& A, const std::vector<FreeMotion>& modes) {
  std::vector<std::string> sentences;
  if (modes.empty()) return sentences;
  const Eigen::SparseMatrix<double> shapes = mode_entries(modes);
  Eigen::SparseMatrix<double> few = rigid_gaps(A, shapes, direction_rounding(modes));
  Eigen::VectorXd unit = Eigen::VectorXd::Ones(few.cols());
  const double rounding = 64 * std::max(epsilon, direction_rounding(modes));
  // Against the terms: where these cancel, as for a ring that turns on a pin, what is left is rounding.
  const Eigen::SparseMatrix<double> terms =
      Eigen::SparseMatrix<double>(A.cwiseAbs()) * Eigen::SparseMatrix<double>(shapes.cwiseAbs());
  for (Index k = 0; k < few.cols(); ++k) {
    double size = 0;
    for (Eigen::SparseMatrix<double>::InnerIterator it(terms, k); it; ++it)
      size = std::max(size, it.value());
    if (size == 0) continue;
    unit(k) = size;
    for (Eigen::SparseMatrix<double>::InnerIterator it(few, k); it; ++it) it.valueRef() /= size;
  }
  // Of many bodies each pair feels a few. If the Gram matrix takes any load by much less than what
  // dependent columns make of it, beyond 1/rounding^2, none depends on others.
  const Eigen::VectorXd any = Eigen::VectorXd::LinSpaced(few.cols(), 1, 9).array().sin();
  if (SparseLuFactor gram; gram.factorise(few.transpose() * few))
    if (largest(gram.solve(any)) < 1e12) return sentences;
  Eigen::MatrixXd moved = few;
  if (moved.rows() < moved.cols())
    moved.conservativeResizeLike(Eigen::MatrixXd::Zero(moved.cols(), moved.cols()));
  const ColumnSpan span = column_span(moved, rounding * static_cast<double>(moved.cols()));
  const std::vector<Index> held(span.order.begin(), span.order.begin() + span.rank);
  for (auto k = span.order.begin() + span.rank; k != span.order.end(); ++k) {
    Eigen::VectorXd amplitude = Eigen::VectorXd::Zero(moved.cols());
    amplitude(*k) = 1;
    amplitude(held) = -least_norm_solution(moved(Eigen::all, held), moved.col(*k));
    sentences.push_back(joined(in_words(modes, amplitude.cwiseQuotient(unit)), " while "));
  }
  return sentences;
}

// One spring per mode, at unknowns where the modes of a body differ as much as possible. A
// lift and a turn of three nodes at x = -1, 0, 1 have the columns (1, -1), (1, 0), (1, 1).
// Pivoting takes the two outer nodes. Two neighbours of a fine mesh would move nearly alike,
// and springs there would leave K nearly singular.
std::vector<Index> grounding(const std::vector<FreeMotion>& modes) {
  // Motions of one body follow each other and move unknowns that those of no other body move.
  std::vector<Index> unknowns;
  for (std::size_t begin = 0, end = 0; begin < modes.size(); begin = end) {
    auto [first, last] = moved_unknowns(modes[begin]);
    for (end = begin + 1; end < modes.size(); ++end) {
      const auto [low, high] = moved_unknowns(modes[end]);
      if (low >= last) break;
      first = std::min(first, low);
      last = std::max(last, high);
    }
    const Index count = static_cast<Index>(end - begin);
    Eigen::MatrixXd shapes = Eigen::MatrixXd::Zero(count, last - first);
    for (Index k = 0; k < count; ++k)
      for (Eigen::SparseVector<double>::InnerIterator it(modes[begin + at(k)].shape); it; ++it)
        shapes(k, it.index() - first) = it.value();
    const std::vector<Index> order = column_span(shapes).order;
    for (Index k = 0; k < count; ++k) unknowns.push_back(first + order[at(k)]);
  }
  return unknowns;
}

}  // namespace signorini
