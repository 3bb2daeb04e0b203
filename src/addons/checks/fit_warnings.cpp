#include "addons/checks/fit_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "signorini/core/errors.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/fem/side_curve.hpp"
#include "signorini/pairing/side_tree.hpp"
#include "signorini/pairing/target_search.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d;

/// How far the straight sides of a round boundary lie within the curve at most: of two that turn by an angle, each of
/// length h has the sag h angle / 8. Edges by which a boundary turns more than a curve does have none.
class Sags {
 public:
  explicit Sags(const TargetSearch& search) : sag_(static_cast<std::size_t>(search.n_sides())) {
    for (Index s = 0; s < search.n_sides(); ++s)
      for (Index t : {s - 1, s + 1})
        if (t >= 0 && t < search.n_sides()) see(search.side(s), search.side(t), s);
  }
  [[nodiscard]] double at(const Projection& place) const {
    return sag_[static_cast<std::size_t>(place.side)] * (1 - place.xi * place.xi);
  }
  [[nodiscard]] bool any() const {
    return std::any_of(sag_.begin(), sag_.end(), [](double sag) { return sag > 0; });
  }

 private:
  void see(const SideCurve& side, const SideCurve& next, Index number) {
    if (side.nodes().size() > 2) return;  // a parabola follows the curve
    const Vector2d chord = side.point(1) - side.point(-1);
    const Vector2d other = next.point(1) - next.point(-1);
    const double angle = angle_between(chord, other);
    if (std::cos(angle) < corner_cosine) return;
    double& sag = sag_[static_cast<std::size_t>(number)];
    sag = std::max(sag, chord.norm() * angle / 8);
  }
  std::vector<double> sag_;
};

double size_of(const Mesh& mesh) {
  return (mesh.nodes.colwise().maxCoeff() - mesh.nodes.colwise().minCoeff()).norm();
}

/// The smallest of the bodies that a pair acts on. \param sizes  of all bodies
std::size_t smallest(const Model& model, const std::vector<double>& sizes, Index pair) {
  std::size_t found = sizes.size();
  for (NodalRows::InnerIterator it(model.pairs.opening, pair); it; ++it) {
    const std::size_t b = body_of_node(model.bodies, it.col() / 2);
    if (found == sizes.size() || sizes[b] < sizes[found]) found = b;
  }
  return found;
}

}  // namespace

std::vector<std::string> sag_warning(const ContactSpec& contact,
                                     const std::vector<BodyModel>& bodies, const Pairs& pairs) {
  const Side* side = std::get_if<Side>(&contact.target);
  if (side == nullptr || pairs.initial_gap.size() == 0) return {};
  const Surface source = surface(bodies, contact.source);
  const Surface target = surface(bodies, *side);
  const TargetSearch search(target.mesh, target.boundary);
  const Sags sags(search);
  if (!sags.any()) return {};
  const std::vector<SideCurve> sides = side_curves(source.mesh, source.boundary);
  double most = 0;
  for (const auto& [number, node] : nodes_on_sides(sides)) {
    const Projection place = search.closest(source.mesh.nodes.row(number).transpose(), node.normal);
    if (place.found) most = std::max(most, sags.at(place));
  }
  // An interference lacks about a third of the sag. A sag of this share changes pressures by some two percent.
  constexpr double much = 0.05;
  const double mean = pairs.initial_gap.cwiseAbs().mean();
  const double interference = contact.interference.value_or(0);
  const bool press_fit = interference > 0 && mean < 2 * interference;
  const double meant = press_fit ? much * interference : mean;
  if (most <= std::max({meant, contact.adjust.value_or(0), gap_rounding(pairs)})) return {};
  return {
      text(describe(bodies, contact), ": the straight edges of the target lie up to ", most,
           " within the curve that they stand for, but the ",
           press_fit ? "interference is " : "mean gap is ", press_fit ? interference : mean,
           press_fit ? ". So pressures are those of a looser fit"
                     : ". So the meshes, not the bodies, say where they touch",
           ": let both sides have the same nodes, take finer edges or quadratic cells, "
           "or adjust gaps by the sag")};
}

std::vector<std::string> closed_gap_warnings(const Model& model, const Solution& solution) {
  std::vector<double> sizes;
  for (const BodyModel& body : model.bodies) sizes.push_back(size_of(body.mesh));
  double farthest = 1;
  Index most = -1;
  for (const Index pair : solution.contact.active()) {
    if (solution.contact.force(pair) <= 0) continue;
    const double times = model.pairs.initial_gap(pair) / sizes[smallest(model, sizes, pair)];
    if (times <= farthest) continue;
    farthest = times;
    most = pair;
  }
  if (most < 0) return {};
  return {text("contact ", model.contacts[model.contact_of[static_cast<std::size_t>(most)]],
               ": the pair at ", in_brackets(model.pairs.position.row(most)),
               " has closed a gap of ", model.pairs.initial_gap(most), ", ", farthest,
               " times the size of '", model.bodies[smallest(model, sizes, most)].mesh.name,
               "'. Gaps are small beside the bodies: check where the bodies are, and the units")};
}

}  // namespace signorini
