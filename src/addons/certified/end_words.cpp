#include "addons/certified/end_words.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/core/table.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {

using Eigen::Index;

std::string pair_in_words(const Model& model, Index pair) {
  const Index node = model.pairs.node[at(pair)];
  std::string words = text("pair ", pair);
  if (node >= 0) {
    const BodyModel& body = model.bodies[body_of_node(model.bodies, node)];
    words += text(" of node ", node - body.first_node, " of body '", body.mesh.name, '\'');
  }
  return words + " at " + in_brackets(model.pairs.position.row(pair));
}

std::string uniqueness_warning_in_words(const Model& model, const UniquenessWarning& figure) {
  const std::string warning =
      "friction: there are other solutions of the same loads, this is one of them";
  const FrictionLaw& law = model.law;
  const auto found = std::find(law.pair.begin(), law.pair.end(), figure.pair);
  if (found == law.pair.end())
    return text(warning,
                ": the determinant of the pairs that slide, normalised to 1 without friction, is ",
                figure.determinant, ", and below 0 there are several");
  const double mu = law.coefficient(found - law.pair.begin());
  return text(warning, ": the determinant of ", pair_in_words(model, *figure.pair),
              ", normalised to 1 without its friction, is ", figure.determinant,
              ", and several solutions begin below 0, from a friction coefficient of ",
              mu / (1 - figure.determinant), " on; there it is ", mu);
}

std::string ray_in_words(const Model& model) {
  const FrictionLaw& law = model.law;
  const std::string end = "Lemke's method ran off along a ray, which proves nothing: ";
  if (model.modes.empty())
    return end +
           "supports and springs hold all bodies, so there is a solution unless pairs depend on "
           "each other, and rounding hides it; take smaller friction coefficients";
  const std::string hold = "hold the bodies by a support or a soft spring";
  if (law.pair.empty()) return end + hold;
  Index most = 0;
  const double mu = law.coefficient.maxCoeff(&most);
  return text(end,
              "where only contact holds a body, there need be no solution once friction is "
              "beyond some value. The largest friction coefficient is ",
              mu, ", of ", pair_in_words(model, law.pair[at(most)]),
              ", the largest cohesion of a pair ", law.cohesion.maxCoeff(), "; take less, or ",
              hold);
}

std::string contradiction_in_words(const Model& model, const Eigen::VectorXd& proof) {
  std::vector<Index> order;
  for (Index pair = 0; pair < proof.size(); ++pair)
    if (proof(pair) > std::sqrt(epsilon) * largest(proof)) order.push_back(pair);
  if (order.empty()) return "";
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return proof(a) > proof(b); });
  constexpr std::size_t few = 3;
  std::string pairs;
  for (std::size_t k = 0; k < std::min(few, order.size()); ++k)
    pairs += text(k == 0 ? "" : "; ", pair_in_words(model, order[k]), ", of '",
                  model.contacts[model.contact_of[at(order[k])]], '\'');
  return text(order.size() == 1 ? "no displacement opens " : "no displacement opens these pairs together: ",
              pairs, order.size() > few ? text("; and ", order.size() - few, " more") : "",
              ". Move one of the sides away, or let supports and bounds leave them room");
}

std::string force_uncertainty_in_words(const Model& model, const ForceUncertainty& figure) {
  std::string contact;
  if (!model.contacts.empty())
    contact = text("contact '", model.contacts[model.contact_of[at(figure.pair)]], "': ");
  const std::string share =
      figure.share < 0.99
          ? text("known only to ", number(100 * figure.share, "%.2g"), " % of the largest")
          : std::string("not known at all");
  return text(contact, "contact forces of single pairs are ", share, ", such as that of ",
              pair_in_words(model, figure.pair),
              ": the gaps are rounded, and some pattern of forces moves hardly more than that, "
              "mostly plus and minus in turns where a stiff source presses on a softer side. "
              "Loads and forces still balance; take the softer or coarser side as source");
}

}  // namespace signorini
