#include "addons/checks/sliding_verdict.hpp"

#include <algorithm>

#include "addons/certified/certified_scene.hpp"
#include "addons/certified/known_forces.hpp"
#include "addons/checks/sliding.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/wording.hpp"

namespace signorini {
namespace {

/// A share of the edge that makes a note if as large a share of the forces acts on other nodes, though their sum may be
/// right. A mesh says where a force acts to half an edge, for which a node stands on each side: half of that is noted.
constexpr double noted_way = 0.25;

/// How far the pairs of a contact have slid, and what that makes of its force.
std::string in_words(const Model& model, const SlidingChange& one) {
  std::string words = "its pairs are those of the meshes as they are";
  if (one.pair >= 0)
    words += text(", but the one at ", in_brackets(model.pairs.position.row(one.pair)),
                  " has slid by ", one.slip, ", ", one.slip / one.edge, " of its edge");
  words += ". Where the bodies have moved to, ";
  if (!one.lost.empty()) return words + "there are none: " + one.lost;
  if (!one.new_force) return words + "no forces are found that balance the loads";
  return words + text("the force on the source would to first order be ",
                      in_brackets(*one.new_force), " in the place of ", in_brackets(one.force),
                      ", ", 100 * one.elsewhere, " % of it on other nodes");
}

}  // namespace

void check_sliding(const Model& model, const Condensed& condensed, Solution& solution) {
  if (!model.followed || solution.contact.force.size() == 0) return;
  const auto none = [&] {
    const PrimalDual& refined = solution.refined;
    return std::max(known_well * largest(refined.force), largest(no_forces(model, refined)));
  };
  const std::vector<SlidingChange> all = sliding_changes(model, condensed, none, solution);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const SlidingChange& one = all[k];
    const bool past = one.moves && one.slip > one.edge && one.elsewhere > noted_change;
    const bool aside = one.moves && one.slip > noted_way * one.edge && one.elsewhere > noted_way;
    if (!past && !aside && one.change <= noted_change) continue;
    if (one.normal <= none()) continue;
    const std::string words = text("contact ", model.contacts[k], ": ", in_words(model, one));
    if (!past || model.small_sliding[k]) {
      solution.notes.push_back(text(words,
                                    ". Let the bodies move (moves = true, with [[steps]]), take "
                                    "smaller movements, or move the "
                                    "meshes near to where they come to stand"));
      continue;
    }
    solution.contact.report.status = SolveStatus::SlidTooFar;
    solution.contact.reason =
        text(words,
             ". Let the bodies move (moves = true, with [[steps]]), move the meshes near to where "
             "they come to stand, or, if the force may act where it does, set small_sliding = true "
             "in this contact");
    return;
  }
}

}  // namespace signorini
