// Which motions are free, which pairs they move, and what is said of it, is the same wherever a scene lies.
#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <vector>

#include "catch_compat.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/rigid_modes.hpp"
#include "support/far.hpp"
#include "support/random_scenes.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;
using namespace signorini_test;

namespace {

/// Letters only: numbers depend on the place, and so does what is called x or y.
std::string without_numbers(const std::string& said) {
  std::string words;
  for (const char c : said)
    if (std::isalpha(static_cast<unsigned char>(c)) != 0 && c != 'x' && c != 'y' && c != 'e')
      words += c;
  return words;
}

/// What is known of the motions of a scene without solving it.
struct Motions {
  std::string refused;             ///< why it is, without numbers; then nothing else is known
  std::vector<Index> count;        ///< of free motions, of each body
  std::vector<std::string> notes;  ///< without numbers
  std::set<Index> still;           ///< pairs that no motion moves
  bool operator==(const Motions& other) const {
    return refused == other.refused && count == other.count && notes == other.notes &&
           still == other.still;
  }
};

Motions motions_of(const Scene& scene) {
  Motions found;
  try {
    const Plan planned = plan(scene);
    for (const BodyModel& body : planned.bodies) {
      const Eigen::MatrixXd shapes = mode_shapes(planned.modes);
      Index count = 0;
      for (Index k = 0; k < shapes.cols(); ++k)
        count += shapes.col(k).segment(body.first_unknown, body.unknowns.count).any() ? 1 : 0;
      found.count.push_back(count);
    }
    for (const std::string& note : planned.notes) found.notes.push_back(without_numbers(note));
    std::sort(found.notes.begin(), found.notes.end());
    const Eigen::MatrixXd R =
        rigid_gaps(contact_rows(planned.gaps, planned.law), mode_entries(planned.modes),
                   direction_rounding(planned.modes));
    for (Index pair = 0; pair < R.rows(); ++pair)
      if ((R.row(pair).array() == 0).all()) found.still.insert(pair);
  } catch (const ProblemError& error) {
    found.refused = without_numbers(error.what());
  }
  return found;
}

/// How many motions supports leave to a body in one piece, by comparing coordinates, which are exact on a grid: two rows of
/// supports that are not on one line stop the turn, else the body turns about the place where these lines meet.
Index free_by_hand(const Body& body, const Unknowns& unknowns) {
  std::set<double> heights, places;  // of what is held in x, in y
  for (Index node = 0; node < body.mesh.n_nodes(); ++node) {
    if (unknowns.number(node, 0) < 0) heights.insert(body.mesh.nodes(node, 1));
    if (unknowns.number(node, 1) < 0) places.insert(body.mesh.nodes(node, 0));
  }
  const bool turns = heights.size() < 2 && places.size() < 2;
  if (body.material.state == PlaneState::Axial) return places.empty() ? 1 : 0;
  return (heights.empty() ? 1 : 0) + (places.empty() ? 1 : 0) + (turns ? 1 : 0);
}

}  // namespace

TEST_CASE(
    "random scenes have the same free motions, still pairs and notes after a turn and far away",
    "[scene][floating][far][random]") {
  int compared = 0, loose = 0, refused = 0, without_digits = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const RandomScenes kind = seed % 2 == 0 ? RandomScenes::Frictionless : RandomScenes::Frictional;
    const RandomScene drawn = random_scene(seed, kind);
    const Scene& scene = drawn.scene;
    const double size = size_of(scene);
    CAPTURE(seed, drawn.text);
    const Motions here = motions_of(scene);
    if (!here.refused.empty()) ++refused;
    if (here.refused.empty()) {
      const Plan planned = plan(scene);
      // Rounded to a grid, equal coordinates are equal.
      const Scene exact = on_grid(scene, std::exp2(std::ilogb(size) - 24));
      for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        CHECK(here.count[b] == free_by_hand(exact.bodies[b], planned.bodies[b].unknowns));
      if (!planned.modes.empty()) ++loose;
    }
    const Vector2d far = 1e6 * size * Vector2d(0.6123, -0.7906);
    std::vector<Scene> others = {quarter_turned(scene), quarter_turned(quarter_turned(scene))};
    if (!here.refused.empty() || !hidden(scene, far)) {
      others.push_back(moved(scene, far));
      others.push_back(moved(quarter_turned(scene), far));
    }
    for (const Scene& other : others) {
      const Motions there = motions_of(other);
      if (there.refused.find("haslostitsdigits") != std::string::npos) {
        ++without_digits;
        continue;
      }
      CAPTURE(here.refused, there.refused, here.notes, there.notes, here.count, there.count);
      CAPTURE(here.still, there.still);
      CHECK((here == there));
      ++compared;
    }
  }
  CAPTURE(compared, loose, refused, without_digits);
  CHECK(compared >= 1850);
  CHECK(loose >= 100);
}
