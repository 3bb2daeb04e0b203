#include "addons/checks/shared_words.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "addons/certified/end_words.hpp"
#include "addons/certified/known_forces.hpp"
#include "addons/checks/undetermined.hpp"
#include "signorini/contact/gaps.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;
using MatrixX2 = Eigen::Matrix<double, Eigen::Dynamic, 2>;

/// What the forces of some pairs amount to on one of the bodies that have them.
struct SharedSum {
  std::size_t body = 0;
  Eigen::Vector2d force = {0.0, 0.0};
  bool determined = false;  ///< whether no exchange changes it
};

SharedSum sum_of(const Model& model, const VectorXd& force, const SharedForces& group) {
  const Index pairs = model.pairs.opening.rows();
  SharedSum sum{body_of_node(
      model.bodies, NodalRows::InnerIterator(model.pairs.opening, group.pairs.front()).col() / 2)};
  MatrixX2 push = MatrixX2::Zero(force.size(), 2);  // of a unit of each row
  const auto add = [&](const NodalRows& rows, Index pair, Index row) {
    for (NodalRows::InnerIterator it(rows, pair); it; ++it)
      if (body_of_node(model.bodies, it.col() / 2) == sum.body)
        push(row, it.col() % 2) += it.value();
  };
  const std::vector<Index>& frictional_pairs = model.law.pair;
  for (const Index pair : group.pairs) {
    add(model.pairs.opening, pair, pair);
    const auto slip = std::lower_bound(frictional_pairs.begin(), frictional_pairs.end(), pair);
    if (slip != frictional_pairs.end() && *slip == pair)
      add(model.pairs.sliding, pair, pairs + (slip - frictional_pairs.begin()));
  }
  sum.force = push.transpose() * force;
  const MatrixX2 changed = group.exchanges.transpose() * push;
  const MatrixX2 terms = group.exchanges.cwiseAbs().transpose() * push.cwiseAbs();
  // Along each unknown an exchange may leave so much of its terms, whatever their direction.
  const double rounding = static_cast<double>(pairs) * certificate_tolerance;
  const VectorXd least = rounding * terms.rowwise().maxCoeff();
  sum.determined = (changed.cwiseAbs().rowwise().maxCoeff().array() <= least.array()).all();
  return sum;
}

/// Numbers such as "0, 4 to 9".
std::string runs_in_words(const std::set<Index>& numbers) {
  std::string words;
  for (auto first = numbers.begin(); first != numbers.end();) {
    auto next = first;
    Index last = *first;
    while (++next != numbers.end() && *next == last + 1) last = *next;
    words += text(words.empty() ? "" : ", ", *first);
    if (last > *first) words += text(last > *first + 1 ? " to " : ", ", last);
    first = next;
  }
  return words;
}

Index pair_of(const Model& model, const ForceRange& range) {
  const Index pairs = model.pairs.opening.rows();
  return range.row < pairs ? range.row
                           : model.law.pair[static_cast<std::size_t>(range.row - pairs)];
}

/// How far one force goes.
std::string range_in_words(const Model& model, const ForceRange& range) {
  const bool normal = range.row < model.pairs.opening.rows();
  const std::string what =
      pair_in_words(model, pair_of(model, range)) + (normal ? " presses with" : " has the friction force");
  if (std::isinf(range.low) && std::isinf(range.high)) return what + " any force";
  if (std::isinf(range.high)) return text(what, ' ', range.low, " or more");
  if (std::isinf(range.low)) return text(what, ' ', range.high, " or less");
  return text(what, ' ', range.low, " to ", range.high);
}

/// Why pairs share what they carry, and the way out.
std::string cause_in_words(const Model& model, const std::vector<Index>& pairs) {
  std::set<Index> nodes;
  for (const Index pair : pairs) nodes.insert(model.pairs.node[static_cast<std::size_t>(pair)]);
  if (nodes.count(-1) > 0)
    return "There are more points than nodes to tell them apart: take fewer, or the operator "
           "'mortar'";
  if (nodes.size() < pairs.size())
    return "A node is in several contacts: let one of them have it, or read the sum";
  return "Their rows repeat each other: leave out what is there twice, or read the sum";
}

}  // namespace

std::string shared_forces_in_words(const Model& model, const Solution& solution, double least) {
  std::set<Index> all;
  for (const SharedForces& group : solution.shared)
    for (const ForceRange& range : group.forces)
      if (!(range.high - range.low <= least)) all.insert(pair_of(model, range));
  if (all.empty()) return {};
  const SharedForces& widest = solution.shared.front();
  std::string words =
      text("contact forces of ", all.size(),
           (all.size() == 1 ? " pair are not determined (" : " pairs are not determined ("),
           runs_in_words(all), "): with others displacements, gaps and slips are the same");
  constexpr std::size_t most_told = 4;
  std::size_t told = 0;
  for (const ForceRange& range : widest.forces) {
    if (!(range.high - range.low > least)) continue;
    if (++told > most_told) break;
    words += text(told == 1 ? ". " : ", ", range_in_words(model, range));
  }
  const SharedSum sum = sum_of(model, solution.refined.force, widest);
  if (sum.determined)
    words +=
        text(told == 0 ? ". Pairs " : "; pairs ",
             runs_in_words({widest.pairs.begin(), widest.pairs.end()}), " together push body '",
             model.bodies[sum.body].mesh.name, "' with ", in_brackets(sum.force));
  return text(words, ". ", cause_in_words(model, widest.pairs));
}

void note_shared_forces(const Model& model, const Condensed& /*condensed*/, Solution& solution) {
  const PrimalDual& refined = solution.refined;
  Carried all = carried(model.programme, refined, model.law, solution.contact.contact_status);
  // Gaps and slips are rounded as the positions that they were made of.
  all.rounding.array() += gap_rounding(model.pairs);
  solution.shared = undetermined_forces(all);
  std::string note = shared_forces_in_words(model, solution, known_well * largest(refined.force));
  if (!note.empty()) solution.notes.push_back(std::move(note));
}

}  // namespace signorini
