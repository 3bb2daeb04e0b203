#include "support/random_paths.hpp"

#include <utility>
#include <vector>

#include "addons/steps/histories.hpp"

namespace signorini_test {
namespace {

using namespace signorini;

constexpr int steps = 5;

/// Values at the times 0 to 5, in sixteenths.
std::vector<double> shape(Draws& draw, bool turns) {
  const int what = draw.whole(0, 5);
  std::vector<double> values = {0};
  for (int k = 1; k <= steps; ++k) {
    double value = draw.whole(turns ? -16 : 4, 24);
    if (what == 0) value = 16;
    if (what == 1) value = 16.0 * k / steps;
    if (what == 2 && turns) value = k % 2 == 1 ? 16 : -16;
    if (what == 3) value = 8.0 * (k <= 2 ? k : 4 - k);
    if (what == 3 && !turns && k > 3) value = 4.0 * k;
    values.push_back(value);
  }
  for (double& value : values) value /= 16;
  return values;
}

/// Histories of two kinds, and who follows which.
class Histories {
 public:
  explicit Histories(Draws& draw) : draw_(draw) {
    path.times = equal_steps(steps, steps);
    for (const char* name : {"press", "drag", "third", "heat"}) {
      const bool turns = name == std::string("drag") || name == std::string("third");
      History history{name, {0, 1, 2, 3, 4, 5}, shape(draw, turns)};
      draw.say("; ", name);
      for (const double value : history.values) draw.say(' ', value);
      path.histories.push_back(std::move(history));
    }
  }
  /// Of loads that press bodies together, and of those of which no sign is better.
  std::string pressing() { return chosen({"press", "press", "press", "", "heat"}); }
  std::string turning() { return chosen({"drag", "drag", "third", "third", ""}); }
  std::string heating() { return chosen({"heat", "press", ""}); }
  Path path;

 private:
  std::string chosen(std::initializer_list<const char*> names) {
    std::string name = draw_.pick(names);
    draw_.say(" '", name, "'");
    return name;
  }
  Draws& draw_;
};

}  // namespace

void add_path(Draws& draw, Scene& scene) {
  Histories histories(draw);
  draw.say("; they follow");
  for (Body& body : scene.bodies) {
    std::vector<EdgeLoad> drags;
    for (EdgeLoad& load : body.loads.edges) {
      load.history = histories.pressing();
      if (!load.traction) continue;
      drags.push_back({load.boundary, 0, std::exchange(load.traction, {}), histories.turning()});
    }
    for (EdgeLoad& drag : drags) body.loads.edges.push_back(std::move(drag));
    if (body.loads.body_force) body.loads.body_force_history = histories.pressing();
    for (PointForce& load : body.loads.points) load.history = histories.turning();
    for (Support& support : body.supports) support.history = histories.turning();
    if (body.temperature) body.temperature->history = histories.heating();
  }
  for (ContactSpec& contact : scene.contacts)
    if (contact.interference) contact.interference_history = histories.heating();
  scene.path = std::move(histories.path);
}

}  // namespace signorini_test
