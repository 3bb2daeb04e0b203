// Pairs whose gaps equations say. A tie may join the sides of a contact, a relation may put a side onto an obstacle: a contact
// force there and the force of the equation act on the same displacement, and only their sum is determined. So the pair is left
// out, as one between two supports is, and the equation has all of the force.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "addons/equations/bonds.hpp"
#include "addons/equations/equations.hpp"
#include "addons/equations/take_equations.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/pair_up.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

/// Beside the sum of what was added up, that is rounding: elimination lets entries below 1e-12 say nothing.
constexpr double cancelling = 1e-12;

bool has_entries(const NodalRows& rows, Index row) {
  return static_cast<bool>(NodalRows::InnerIterator(rows, row));
}

/// Numbers that rows have where equations and supports alone move something.
struct Given {
  Given(const NodalRows& rows, const VectorXd& initial, double sign, const VectorXd& s)
      : value(initial + sign * (rows * s)),
        rounding(cancelling * (initial.cwiseAbs() + rows.cwiseAbs() * s.cwiseAbs())) {}

  VectorXd value;
  VectorXd rounding;  // of it
};

/// What the unknowns are where those that are left are 0 [length]. \param right  what the equations say of them
VectorXd given_by(const Equations& all, const Unknowns& unknowns, const VectorXd& right) {
  VectorXd given = VectorXd::Zero(unknowns.count);
  given(all.solved.unknown) = VectorXd(all.solved.right * right);
  return given;
}

/// Contacts are followed by the pairs that are kept; those whose pairs have no nodes are not, as what equations hold there cannot be told.
void cut_followed(const std::vector<Index>& kept, Plan& draft) {
  if (!draft.followed) return;
  std::vector<FollowedContact> followed = *draft.followed;
  std::size_t pair = 0;
  for (std::size_t k = 0; k < followed.size(); ++k) {
    std::vector<Index> own;
    const std::size_t first = pair;
    for (; pair < draft.contact_of.size() && draft.contact_of[pair] == k; ++pair)
      if (std::binary_search(kept.begin(), kept.end(), static_cast<Index>(pair)))
        own.push_back(static_cast<Index>(pair - first));
      else if (draft.gaps.pairs.node[pair] >= 0)
        followed[k].given.push_back(draft.gaps.pairs.node[pair]);
      else
        followed[k].linear = true;
    std::sort(followed[k].given.begin(), followed[k].given.end());
    followed[k].gap = VectorXd(followed[k].gap(own));
  }
  draft.followed = std::make_shared<const std::vector<FollowedContact>>(std::move(followed));
}

/// Those of the numbered arrays of pairs that are kept.
void cut_pairs(const std::vector<Index>& kept, Plan& draft) {
  cut_followed(kept, draft);
  Gaps& gaps = draft.gaps;
  Pairs& pairs = gaps.pairs;
  for (NodalRows* rows : {&pairs.opening, &pairs.sliding, &gaps.A, &gaps.T})
    if (rows->rows() > 0) *rows = selected_rows(*rows, kept);
  for (VectorXd* numbers : {&pairs.initial_gap, &pairs.weight, &gaps.initial_slip})
    if (numbers->size() > 0) *numbers = VectorXd((*numbers)(kept));
  for (NodeArray* means : {&pairs.position, &pairs.normal, &pairs.moment, &pairs.target_moment})
    *means = NodeArray((*means)(kept, Eigen::all));
  for (std::size_t k = 0; k < kept.size(); ++k) {
    pairs.node[k] = pairs.node[at(kept[k])];
    draft.contact_of[k] = draft.contact_of[at(kept[k])];
  }
  pairs.node.resize(kept.size());
  draft.contact_of.resize(kept.size());
}

/// Leaves the slips of such pairs out, and those that are given as none.
void cut_law(const std::vector<Index>& kept, const std::vector<bool>& slides, FrictionLaw& law) {
  std::vector<Index> rows;
  std::vector<Index> pairs;
  for (std::size_t k = 0; k < law.pair.size(); ++k) {
    const auto place = std::lower_bound(kept.begin(), kept.end(), law.pair[k]);
    if (place == kept.end() || *place != law.pair[k] || !slides[at(*place)]) continue;
    rows.push_back(static_cast<Index>(k));
    pairs.push_back(static_cast<Index>(place - kept.begin()));
  }
  law.pair = std::move(pairs);
  law.coefficient = VectorXd(law.coefficient(rows));
  law.cohesion = VectorXd(law.cohesion(rows));
}

/// What messages call a contact.
std::string in_words(const Scene& scene, const Plan& draft, std::size_t contact) {
  if (contact >= scene.contacts.size()) return draft.contacts[contact];  // a relation
  const std::string words = describe(draft.bodies, scene.contacts[contact]);
  const std::vector<std::size_t>& ties = scene.bonds->two_sided;
  return std::find(ties.begin(), ties.end(), contact) == ties.end() ? words : "sliding tie" + words.substr(7);
}

/// Refuses a pair that no force can close or open.
void check_given(const Scene& scene, const Plan& draft, Index pair, double gap, double rounding,
                 std::optional<double> time) {
  const std::string when = time ? text(" at time ", *time) : "";
  const std::string place =
      text(in_words(scene, draft, draft.contact_of[at(pair)]), ": the pair at ",
           in_brackets(draft.gaps.pairs.position.row(pair)), " is held by supports, ties, relations or rigid sides and ");
  const bool of_relation = draft.contact_bodies[draft.contact_of[at(pair)]].acts_elsewhere;
  require_input(gap >= -rounding, place, of_relation ? "is beyond its number by " : "overlaps by ", -gap, when,
                of_relation ? ". Change the number, or what holds it"
                            : ". Leave it out there, or change what holds it");
  const bool stays = std::binary_search(draft.two_sided.begin(), draft.two_sided.end(), pair);
  require_input(!stays || gap <= rounding, place, "stays ", gap, " apart", when,
                ", and never lifts off: leave out one of those that hold it");
}

/// Asks it of pairs at a time. \param given  their numbers \param held  displacements that supports give then
/// \param others  what the unknowns are then
void check_gaps(const Scene& scene, const Plan& draft, const std::vector<Index>& given, const NodeArray& held,
                const VectorXd& others, std::optional<double> time) {
  const Gaps& gaps = draft.gaps;
  const VectorXd moved = (held - draft.unknowns.held).reshaped<Eigen::RowMajor>();
  const Given opening(gaps.A, gaps.pairs.initial_gap + gaps.pairs.opening * moved, -1, others);
  for (const Index pair : given) {
    const Eigen::Vector2d x = gaps.pairs.position.row(pair).transpose();
    const std::size_t contact = draft.contact_of[at(pair)];
    const double to_come = contact < scene.contacts.size()
                               ? interference_to_come(scene, scene.contacts[contact], x, time)
                               : 0;
    check_given(scene, draft, pair, opening.value(pair) + to_come,
                gap_rounding(gaps.pairs) + opening.rounding(pair), time);
  }
}

/// Marks pairs that equations and supports make slide at a time.
void see_slips(const Plan& draft, const NodeArray& held, const VectorXd& others, std::vector<bool>& slides) {
  const Gaps& gaps = draft.gaps;
  const VectorXd moved = (held - draft.unknowns.held).reshaped<Eigen::RowMajor>();
  const Given sliding(gaps.T, gaps.initial_slip + gaps.pairs.sliding * moved, 1, others);
  for (Index pair = 0; pair < sliding.value.size(); ++pair)
    if (std::abs(sliding.value(pair)) > gap_rounding(gaps.pairs) + sliding.rounding(pair))
      slides[at(pair)] = true;
}

/// Where bodies move, pairs are found again and again, and it would have to be asked of each.
void check_moves(const Scene& scene, const Plan& draft, Index pair) {
  require_input(!bodies_move(scene), in_words(scene, draft, draft.contact_of[at(pair)]), ": the pair at ",
                in_brackets(draft.gaps.pairs.position.row(pair)),
                " is held by supports, ties, relations or rigid sides, and bodies of this scene move: let the boundaries of "
                "a contact have no node in common with theirs");
}

void note_given(const Scene& scene, const std::vector<Index>& given, Plan& draft) {
  for (std::size_t k = 0; k < draft.contacts.size(); ++k) {
    const auto own = std::count_if(given.begin(), given.end(), [&](Index pair) {
      return draft.contact_of[at(pair)] == k;
    });
    if (own == 0) continue;
    draft.notes.push_back(text(in_words(scene, draft, k), ": ", own, own == 1 ? " pair" : " pairs",
                               " can neither open nor close, for supports, ties, relations or rigid sides hold ",
                               own == 1 ? "it" : "them", ": no contact force there"));
    const auto nodeless = [&](Index pair) {
      return draft.contact_of[at(pair)] == k && draft.gaps.pairs.node[at(pair)] < 0;
    };
    if (std::any_of(given.begin(), given.end(), nodeless))
      draft.notes.back() += ". How far the other pairs of this contact slide is not looked at";
  }
}

}  // namespace

Factors factors_at(const std::vector<History>& histories, double time) {
  return [&histories, time](const std::string& history) { return factor_of(histories, history, time); };
}

VectorXd right_sides(const Equations& all, const NodeArray& held, const Factors& factors) {
  VectorXd right = -(all.matrix * Eigen::Map<const VectorXd>(held.data(), held.size()));
  for (Index k = 0; k < right.size(); ++k)
    right(k) += factors(all.rows[at(k)].history) * all.rows[at(k)].right;
  return right;
}

void each_given(const Scene& scene, const Plan& draft, const Equations& all,
                const std::function<void(const NodeArray&, const VectorXd&, std::optional<double>)>& visit) {
  const std::vector<History> none;
  each_given(scene, draft, [&](const NodeArray& held, std::optional<double> time) {
    const std::vector<History>& histories = scene.path ? scene.path->histories : none;
    visit(held, right_sides(all, held, factors_at(histories, time.value_or(draft.time))), time);
  });
}

NodalRows on_free_unknowns(const NodalRows& rows, const Sparse& by_free) {
  NodalRows found = rows * by_free;
  const NodalRows terms = rows.cwiseAbs() * by_free.cwiseAbs();
  for (Index row = 0; row < found.rows(); ++row) {
    double most = 0;
    for (NodalRows::InnerIterator it(terms, row); it; ++it) most = std::max(most, it.value());
    for (NodalRows::InnerIterator it(found, row); it; ++it)
      if (std::abs(it.value()) <= cancelling * most) it.valueRef() = 0;
  }
  found.prune(0.0);
  return found;
}

void leave_out_given_pairs(const Scene& scene, Equations& all, Plan& draft) {
  const Index count = draft.gaps.A.rows();
  if (count == 0) return;
  const Sparse T = by_free_unknowns(all.solved, draft.unknowns.count);
  const NodalRows free = on_free_unknowns(draft.gaps.A, T);
  std::vector<Index> kept;
  std::vector<Index> given;
  for (Index pair = 0; pair < count; ++pair) (has_entries(free, pair) ? kept : given).push_back(pair);
  for (const Index pair : given) check_moves(scene, draft, pair);
  std::vector<bool> slides(at(count), true);
  if (!draft.law.pair.empty()) {
    const NodalRows sliding = on_free_unknowns(draft.gaps.T, T);
    for (Index pair = 0; pair < count; ++pair) slides[at(pair)] = has_entries(sliding, pair);
  }
  if (given.empty() && std::count(slides.begin(), slides.end(), false) == 0) return;
  each_given(scene, draft, all, [&](const NodeArray& held, const VectorXd& right, std::optional<double> time) {
    const VectorXd others = given_by(all, draft.unknowns, right);
    check_gaps(scene, draft, given, held, others, time);
    if (!draft.law.pair.empty()) see_slips(draft, held, others, slides);
  });
  for (const Index pair : draft.law.pair)
    if (!slides[at(pair)]) check_moves(scene, draft, pair);
  cut_law(kept, slides, draft.law);
  if (given.empty()) return;
  note_given(scene, given, draft);
  cut_pairs(kept, draft);
  std::vector<Index> two_sided;
  for (std::size_t k = 0; k < kept.size(); ++k)
    if (std::binary_search(draft.two_sided.begin(), draft.two_sided.end(), kept[k]))
      two_sided.push_back(static_cast<Index>(k));
  draft.two_sided = std::move(two_sided);
}

}  // namespace signorini
