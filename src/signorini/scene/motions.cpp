#include "signorini/scene/motions.hpp"

#include <algorithm>
#include <utility>

#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/fem/far.hpp"
#include "signorini/scene/rigid_modes.hpp"

namespace signorini {

using Eigen::Index;

namespace {

/// A spring stops every motion that it resists, however soft it is: as if it held its nodes.
Unknowns held_by_springs(const BodyModel& body) {
  Unknowns unknowns = body.unknowns;
  for (Index k = 0; k < body.springs.cols(); ++k)
    if (body.springs.coeff(k, k) > 0) unknowns.number(k / 2, k % 2) = -1;
  return unknowns;
}

/// The first unknown that a motion moves, and the one after the last.
std::pair<Index, Index> moved_unknowns(const FreeMotion& mode) {
  Index begin = 0;
  Index end = mode.shape.size();
  while (begin < end && mode.shape(begin) == 0) ++begin;
  while (end > begin && mode.shape(end - 1) == 0) --end;
  return {begin, end};
}

}  // namespace

Eigen::MatrixXd mode_shapes(const std::vector<FreeMotion>& modes) {
  Eigen::MatrixXd shapes(modes.empty() ? 0 : modes.front().shape.size(),
                         static_cast<Index>(modes.size()));
  for (Index k = 0; k < shapes.cols(); ++k)
    shapes.col(k) = modes[static_cast<std::size_t>(k)].shape;
  return shapes;
}

double direction_rounding(const std::vector<BodyModel>& bodies) {
  double most = 0;
  for (const BodyModel& body : bodies) most = std::max(most, direction_rounding(body.mesh));
  return most;
}

double direction_rounding(const std::vector<FreeMotion>& modes) {
  double most = 0;
  for (const FreeMotion& mode : modes) most = std::max(most, mode.directions);
  return most;
}

std::vector<FreeMotion> rigid_modes(const std::vector<BodyModel>& bodies) {
  const BodyModel& last = bodies.back();
  std::vector<FreeMotion> modes;
  for (const BodyModel& body : bodies)
    for (FreeMotion& mode :
         body.springs.rows() == 0
             ? free_motions(body.mesh, body.pieces, body.unknowns, body.material.base.state)
             : free_motions(body.mesh, body.pieces, held_by_springs(body),
                            body.material.base.state)) {
      const Eigen::VectorXd own = std::move(mode.shape);
      mode.shape.setZero(last.first_unknown + last.unknowns.count);
      mode.shape.segment(body.first_unknown, own.size()) = own;
      modes.push_back(std::move(mode));
    }
  if (modes.empty()) return modes;
  // Contact may take its normals from any of the bodies.
  const double directions = direction_rounding(bodies);
  for (FreeMotion& mode : modes) mode.directions = directions;
  return modes;
}

std::vector<std::string> motions_without_contact(
    const Eigen::SparseMatrix<double, Eigen::RowMajor>& A, const std::vector<FreeMotion>& modes) {
  std::vector<std::string> sentences;
  if (modes.empty()) return sentences;
  const double directions = direction_rounding(modes);
  Eigen::MatrixXd moved = rigid_gaps(A, mode_shapes(modes), directions);
  Eigen::VectorXd unit = Eigen::VectorXd::Ones(moved.cols());
  const double rounding = 64 * std::max(epsilon, directions);
  // Against the terms: where these cancel, as for a ring that turns on a pin, what is left is rounding.
  const Eigen::RowVectorXd size =
      (A.cwiseAbs() * mode_shapes(modes).cwiseAbs()).colwise().lpNorm<Eigen::Infinity>();
  for (Index k = 0; k < moved.cols(); ++k)
    if (size(k) > 0) moved.col(k) /= unit(k) = size(k);
  if (moved.rows() < moved.cols())
    moved.conservativeResizeLike(Eigen::MatrixXd::Zero(moved.cols(), moved.cols()));
  const ColumnSpan span = column_span(moved, rounding * static_cast<double>(moved.cols()));
  const std::vector<Index> held(span.order.begin(), span.order.begin() + span.rank);
  for (auto k = span.order.begin() + span.rank; k != span.order.end(); ++k) {
    Eigen::VectorXd amplitude = Eigen::VectorXd::Zero(moved.cols());
    amplitude(*k) = 1;
    amplitude(held) = -least_norm_solution(moved(Eigen::all, held), moved.col(*k));
    const std::vector<std::string> words = in_words(modes, amplitude.cwiseQuotient(unit));
    sentences.push_back(joined(words, " while "));
  }
  return sentences;
}

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
    Eigen::MatrixXd shapes(count, last - first);
    for (Index k = 0; k < count; ++k)
      shapes.row(k) = modes[begin + static_cast<std::size_t>(k)].shape.segment(first, last - first);
    const std::vector<Index> order = column_span(shapes).order;
    for (Index k = 0; k < count; ++k)
      unknowns.push_back(first + order[static_cast<std::size_t>(k)]);
  }
  return unknowns;
}

}  // namespace signorini
