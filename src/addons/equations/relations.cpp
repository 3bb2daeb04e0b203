// Linear relations between displacements, with = or up to a number.
#include <algorithm>
#include <cmath>
#include <utility>

#include "addons/equations/bonds.hpp"
#include "addons/equations/equations.hpp"
#include "addons/equations/terms.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d;

/// A term with its nodes among those of all bodies.
struct Placed {
  const RelationTerm* term;
  std::vector<Index> nodes;
};

std::string side_in_words(const Side& side) { return text('\'', side.boundary, "' of '", side.body, '\''); }

/// Puts the nodes of whole sides into the order along the first of them, and refuses sides that a shift does not take there.
void match(const std::string& what, std::vector<Placed>& all, const Plan& draft) {
  const auto whole = [](const Placed& one) { return !one.term->only_at; };
  const auto first = std::find_if(all.begin(), all.end(), whole);
  if (first == all.end()) return;
  const Vector2d along = place_of(draft, first->nodes.back()) - place_of(draft, first->nodes.front());
  for (Placed& one : all)
    if (whole(one))
      std::stable_sort(one.nodes.begin(), one.nodes.end(), [&](Index a, Index b) {
        return along.dot(place_of(draft, a) - place_of(draft, b)) < 0;
      });
  for (const Placed& one : all) {
    if (!whole(one)) continue;
    require_input(one.nodes.size() == first->nodes.size(), what, ": ", side_in_words(one.term->side), " has ",
                  one.nodes.size(), " nodes and ", side_in_words(first->term->side), " has ",
                  first->nodes.size(), ": a relation takes one node of each; a [[tie]] takes any mesh");
    const Vector2d shift = place_of(draft, one.nodes.front()) - place_of(draft, first->nodes.front());
    for (std::size_t k = 0; k < one.nodes.size(); ++k) {
      const Vector2d off = place_of(draft, one.nodes[k]) - place_of(draft, first->nodes[k]) - shift;
      require_input(off.norm() <= 1e-6 * along.norm(), what, ": the node of ",
                    side_in_words(one.term->side), " at ", in_brackets(place_of(draft, one.nodes[k])),
                    " has no partner on ", side_in_words(first->term->side), ", it is ", off.norm(),
                    " off: a shift must take the nodes of one side to those of the other");
    }
  }
}

void check_relation(const Relation& relation, const std::string& what) {
  require_input(!relation.terms.empty(), what, ": it needs one term or more");
  require_input(std::isfinite(relation.right), what, ": right must be finite, got ", relation.right);
  for (const RelationTerm& term : relation.terms)
    require_input(term.along.allFinite() && std::isfinite(term.times) &&
                      (term.times * term.along).norm() > 0,
                  what, ": a term must have a direction and a factor that are not 0, got ",
                  in_brackets(term.along), " times ", term.times);
  const double stiffness = relation.stiffness.value_or(1);
  require_input(std::isfinite(stiffness) && stiffness > 0, what,
                ": a stiffness must be a number > 0, got ", stiffness);
  require_input(!relation.stiffness || relation.holds == Holds::Equal, what, ": stiffness = ", stiffness,
                " is of a spring that pulls and presses, and at_most and at_least let go: leave stiffness out, "
                "or write right in their place");
  require_input(relation.history.empty() || relation.holds == Holds::Equal, what, ": it follows the history '",
                relation.history, "', and a bound that at_most or at_least gives stays where it is: leave the history "
                "out, or make the bound a contact whose interference follows it");
}

}  // namespace

void add_relation(const Relation& relation, std::size_t number, Plan& draft, Equations& all) {
  Bond bond;
  bond.name = bond.what = text("relation ", number);
  check_relation(relation, bond.what);
  std::vector<Placed> placed;
  for (const RelationTerm& term : relation.terms)
    placed.push_back({&term, nodes_of(term.side, term.only_at, draft)});
  match(bond.what, placed, draft);
  std::size_t count = 1;
  for (const Placed& one : placed) count = std::max(count, one.nodes.size());
  std::vector<Equation> rows;
  for (std::size_t k = 0; k < count; ++k) {
    Terms terms;
    for (const Placed& one : placed)
      add_to(terms, one.nodes[one.term->only_at ? 0 : k], one.term->times * one.term->along);
    rows.push_back(equation_of(terms, relation.right));
    rows.back().stiffness = relation.stiffness;
    rows.back().history = relation.history;
  }
  const bool equal = relation.holds == Holds::Equal;
  draft.on.push_back(text(bond.what, " of ", relation.terms.size(),
                          relation.terms.size() == 1 ? " term: " : " terms: ", count,
                          !equal ? " pairs" : relation.stiffness ? " springs" : " equations"));
  if (!equal) return add_one_sided(relation, bond.name, rows, placed.front().nodes, draft);
  bond.nodes = placed.front().nodes;
  bond.first = all.rows.size();
  all.rows.insert(all.rows.end(), rows.begin(), rows.end());
  bond.end = all.rows.size();
  all.bonds.push_back(std::move(bond));
}

}  // namespace signorini
