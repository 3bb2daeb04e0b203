// A certificate speaks of residuals: where rounding of the gaps moves the forces all the same, a note says how far.
#include <algorithm>
#include <cmath>

#include "catch_compat.hpp"
#include "support/two_bodies.hpp"

using Eigen::Index;
using Eigen::VectorXd;
using namespace signorini;
using namespace signorini_test;

namespace {

/// Nine nodes of a stiff block on eight of a soft one: pressures of plus and minus in turns move no node of the latter.
/// \param overlap  of blocks that are held far from each other, or 0: then a pressure of 1 brings them together
Scene zigzag(double ratio, double overlap, double unit = 1) {
  Scene scene = two_blocks(named_block("lower", {0, -2}, {4, 2}, 7, 3),
                           named_block("upper", {0, -overlap}, {4, 2}, 8, 4));
  scene.bodies[0].material = {1000 * unit, 0, PlaneState::Strain, 1};
  scene.bodies[1].material = {1000 * unit * ratio, 0, PlaneState::Strain, 1};
  if (overlap > 0) {
    scene.bodies[1].supports = {fixed("top")};
  } else {
    scene.bodies[1].supports = {symmetric("left")};
    scene.bodies[1].loads.edges = {{"top", unit, {}}};
  }
  return scene;
}

/// The note on single forces, or nothing.
std::string note_of(const Solution& solution) {
  for (const std::string& note : solution.notes)
    if (note.find("contact forces of single pairs") != std::string::npos) return note;
  return "";
}

/// The share of the largest force that a note tells.
double share_of(const std::string& note) {
  if (note.find("not known at all") != std::string::npos) return 1;
  const std::string mark = "known only to ";
  const std::size_t at = note.find(mark);
  REQUIRE(at != std::string::npos);
  return std::stod(note.substr(at + mark.size())) / 100;
}

/// How wrong the largest error of a force of uniform pressure is, over the largest force.
double error_of(const Scene& scene, double pressure, const Solution& solution) {
  Ledger ledger;
  const VectorXd exact = pressure * build(scene, ledger).pairs.weight;
  const VectorXd& force = solution.contact.force;
  return (force - exact).cwiseAbs().maxCoeff() / force.cwiseAbs().maxCoeff();
}

/// What the note says and how wrong the forces are, of a scene whose exact pressure is uniform.
struct Told {
  double share;
  double error;
};

Told told(const Scene& scene, double pressure) {
  const Solution solution = solve(scene);
  REQUIRE(solution.contact.report.status == SolveStatus::Solved);
  CHECK(solution.certificate.holds(1e-12));
  return {share_of(note_of(solution)), error_of(scene, pressure, solution)};
}

void check_estimate(const Told& it) {
  CAPTURE(it.share, it.error);
  CHECK(it.share < 10 * it.error);
  CHECK(it.share > it.error / 10);
}

}  // namespace

// Patch tests: the exact pressure is uniform.
TEST_CASE("pressures that rounding makes wrong are told, with how much", "[scene][hard]") {
  for (const double ratio : {1e10, 1e11, 1e12, 1e13, 1e14}) {
    CAPTURE(ratio);
    check_estimate(told(zigzag(ratio, 0), 1));
  }
  // One rounding may be lucky. Of several the worst is as told, and none is worse than that.
  for (const double ratio : {1e10, 1e11, 1e12, 1e13, 1e14, 1e15}) {
    CAPTURE(ratio);
    Told worst{0, 0};
    for (const double overlap : {0.125, 1e-3, 0.3, 0.07, 0.011}) {
      const Told now = told(zigzag(ratio, overlap), 1000 * overlap / (2 + 2 / ratio));
      worst = {std::max(worst.share, now.share), std::max(worst.error, now.error)};
      CAPTURE(overlap, now.share, now.error);
      CHECK(now.error < 10 * now.share);
    }
    check_estimate(worst);
  }
  check_estimate(told(zigzag(1e16, 0.125), 62.5));  // rounding has opened two pairs
}

TEST_CASE("the note on single forces names its contact, a pair and the way out, in any unit",
          "[scene][hard]") {
  const std::string note = note_of(solve(zigzag(1e12, 0.125)));
  CHECK_THAT(note, ContainsSubstring("contact 'upper.bottom on lower.top'") &&
                       ContainsSubstring("of body 'upper' at (") &&
                       ContainsSubstring("take the softer or coarser side as source"));
  const double unit = std::ldexp(1, -40);
  CHECK(note_of(solve(zigzag(1e12, 0.125, unit))) == note);
}

TEST_CASE("forces that are known well have no such note", "[scene][hard]") {
  CHECK(note_of(solve(zigzag(1e6, 0.125))).empty());
  Scene turned = zigzag(1e12, 0.125);  // the way out
  turned.contacts = {{{"top", "lower"}, Side{"bottom", "upper"}}};
  const Solution solution = solve(turned);
  CHECK(note_of(solution).empty());
  CHECK(error_of(turned, 62.5, solution) < 1e-9);
}

// Friction has the same patterns, along and across; nothing slides where nothing pulls.
TEST_CASE("forces of pairs that rub are told, too", "[scene][hard][friction]") {
  Scene scene = zigzag(1e12, 0.125);
  scene.contacts[0].friction = Friction{0.3, 0};
  check_estimate(told(scene, 62.5));
}

// Rows of A that repeat each other: other forces do as well, and nothing else depends on them.
TEST_CASE("repeated rows are no rounding", "[scene][hard]") {
  Scene scene = two_blocks(named_block("lower", {0, -2}, {4, 2}, 8, 4),
                           named_block("upper", {0, -0.125}, {4, 2}, 8, 4));
  scene.bodies[1].supports = {fixed("top")};
  scene.contacts[0].gap_operator = "gauss_points";
  scene.contacts[0].points = GENERATE(2, 3, 4, 6);
  const Solution solution = solve(scene);
  REQUIRE(solution.contact.report.status == SolveStatus::Solved);
  CHECK(note_of(solution).empty());
}
