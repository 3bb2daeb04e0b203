// The scene files in examples/ give the numbers of their chapters, and are short.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>

#include "addons/files/problem_file.hpp"
#include "addons/files/scene_file.hpp"
#include "addons/steps/steps.hpp"
#include "addons/text/text_reader.hpp"
#include "catch_compat.hpp"
#include "closed_form/footing.hpp"
#include "closed_form/hertz_fit.hpp"
#include "closed_form/moduli.hpp"
#include "papers/examples.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/problem/active_set_system.hpp"
#include "signorini/report/pressure_table.hpp"
#include "signorini/scene/readings.hpp"

using namespace signorini;
using Eigen::Index;

namespace {

const std::filesystem::path root = std::filesystem::path(SIGNORINI_TEST_DATA) / ".." / "..";

std::string content(const std::filesystem::path& file) {
  return file_content(root / file, std::size_t{1} << 20);
}

SolvedScene run_of(const std::string& name) {
  const SceneFile file = read_scene(root / "examples" / (name + ".toml"));
  return at_file(file, [&] { return solved(file.scene, file.title); });
}

/// A number that a chapter has committed.
double committed(const std::string& chapter, const std::string& key) {
  std::istringstream lines(
      content("chapters/" + chapter + "/results/" + chapter.substr(0, 4) + ".results"));
  std::string line;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string name;
    double value = 0;
    if (words >> name >> value && name == key) return value;
  }
  throw std::invalid_argument(text(chapter, " has no number '", key, "'"));
}

void check_equal(double value, double expected) {
  CAPTURE(value, expected);
  CHECK(std::abs(value - expected) <= 1e-9 * std::abs(expected));
}

}  // namespace

TEST_CASE("no example is longer than 25 lines", "[scene_file]") {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(root / "examples")) {
    if (entry.path().extension() != ".toml" && entry.path().extension() != ".txt") continue;
    CAPTURE(entry.path().filename().string());
    const std::string all = file_content(entry.path(), 100000);
    CHECK(std::count(all.begin(), all.end(), '\n') <= 25);
    ++count;
  }
  CHECK(count >= 9);
}

TEST_CASE("the cantilever of the examples is that of chapter 6", "[scene_file][examples]") {
  const SolvedScene run = run_of("cantilever");
  const std::string chapter = "ch06_cantilever";
  check_equal(resultants(run.model, run.solution).force.y(),
              committed(chapter, "total_contact_force"));
  CHECK(static_cast<double>(run.solution.contact.active().size()) ==
        committed(chapter, "closed_nodes"));
}

TEST_CASE("the rigid pin of the examples is that of chapter 7", "[scene_file][examples]") {
  const SolvedScene run = run_of("rigid_pin");
  const std::string chapter = "ch07_rigid_pin";
  const Index right = boundary_nodes(run.model.bodies[0].mesh, "right").front();
  check_equal(run.solution.displacements[0](right, 0), committed(chapter, "right_t"));
  const BoundaryForces hole = boundary_forces(run, {"hole"});
  check_equal(-2 * hole.force.col(0).sum(), committed(chapter, "resultant_t"));
}

TEST_CASE("the cylinder of the examples is that of chapter 11", "[scene_file][examples]") {
  const SolvedScene run = run_of("hertz");
  const std::string chapter = "ch11_hertz";
  const BoundaryForces side = boundary_forces(run, {"rim", "disc"});
  std::vector<Index> order(static_cast<std::size_t>(side.weight.size()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return side.position(a, 0) < side.position(b, 0); });
  std::vector<double> x, force, pressure;
  for (const Index k : order) {
    x.push_back(side.position(k, 0));
    force.push_back(side.force(k, 1));
    pressure.push_back(side.force(k, 1) / side.weight(k));
  }
  const double b = committed(chapter, "b"), q0 = committed(chapter, "q0");
  const double peak = q0 * (1 + committed(chapter, "q_fit_error") / 100);
  const double width = b * (1 + committed(chapter, "b_m2_error") / 100);
  check_equal(fit_hertz(x, pressure).peak_pressure, peak);
  check_equal(half_width_of_forces(x, force), width);
  check_equal(2 * std::accumulate(force.begin(), force.end(), 0.0),
              committed(chapter, "resultant"));
}

TEST_CASE("the Brazilian disc of the examples is that of chapter 12", "[scene_file][examples]") {
  const SolvedScene run = run_of("brazilian_disc");
  const BodyModel& disc = run.model.bodies[0];
  const StressArray stress =
      nodal_stress(disc.mesh, disc.element, disc.material, run.solution.displacements[0]);
  Index middle = 0;
  (disc.mesh.nodes.rowwise() - Eigen::RowVector2d(0, 50)).rowwise().squaredNorm().minCoeff(&middle);
  check_equal(stress(middle, 0), committed("ch12_brazilian_disc", "middle"));
}

TEST_CASE("the footing of the examples is that of chapter 13", "[scene_file][examples]") {
  const SolvedScene run = run_of("footing");
  const std::string chapter = "ch13_strip_footing";
  const Mesh& soil = run.model.bodies[1].mesh;
  const Index axis = boundary_nodes(soil, "loaded").back();
  check_equal(-1000 * run.solution.displacements[1](axis, 1), committed(chapter, "settlement"));
  check_equal(run.solution.pressure.maxCoeff() / 15, committed(chapter, "corner_pressure"));
}

TEST_CASE("the lining of the examples is that of chapter 14", "[scene_file][examples]") {
  const SolvedScene run = run_of("lining");
  const std::string chapter = "ch14_lining";
  check_equal(run.solution.pressure.mean(), committed(chapter, "p_q4_incompatible"));
  const std::vector<Index> rim = boundary_nodes(run.model.bodies[0].mesh, "inner");
  check_equal(run.solution.displacements[0](rim, Eigen::all).rowwise().norm().mean(),
              committed(chapter, "u_q4_incompatible"));
}

TEST_CASE("the random programme of the examples is one of chapter 5", "[scene_file][examples]") {
  const KnownProgramme known = rosen_suzuki(4, 4, 1);
  const ProblemFile file = read_problem(root / "examples" / "random_programme.txt");
  const auto& programme = std::get<TwoSidedProgramme>(file);
  CHECK(programme.P == known.programme.stiffness);
  CHECK(programme.q == -known.programme.load);
  CHECK(programme.A == known.programme.A);
  CHECK(programme.upper == known.programme.initial_gap);
  REQUIRE(programme.published_optimum);
  CHECK(std::abs(*programme.published_optimum - known.energy) <= 1e-12);
}

TEST_CASE("the punch of the examples sticks inside and slides at its front",
          "[scene_file][examples]") {
  const SolvedScene run = run_of("punch");
  const Resultants sum = resultants(run.model, run.solution);
  CHECK(std::abs(sum.force.y() - 1000) < 1e-9 * 1000);  // the load, upwards on the punch
  CHECK(std::abs(sum.force.x() + 150) < 1e-9 * 1000);
  std::size_t stuck = 0, slid = 0;
  for (const ContactStatus contact_status : run.solution.contact.contact_status) {
    stuck += contact_status == ContactStatus::Stick ? 1 : 0;
    slid += contact_status == ContactStatus::SlipForward ||
                    contact_status == ContactStatus::SlipBackward
                ? 1
                : 0;
  }
  CHECK(stuck > 0);
  CHECK(slid > 0);
}

TEST_CASE("the wheel of the examples rolls on no more than friction lets it",
          "[scene_file][examples]") {
  const SolvedScene run = run_of("wheel_on_rail");
  const Resultants sum = resultants(run.model, run.solution);
  CHECK(sum.force.y() > 0);
  CHECK(sum.force.x() < 0);  // the rail holds the wheel back
  CHECK(-sum.force.x() <= 0.3 * sum.force.y() * (1 + 1e-12));
}

// Lame: two bodies of one material that are long, with free ends, E d (c^2 - b^2) / (2 b c^2).
TEST_CASE("the bolt of the examples is pressed as by a long tube", "[scene_file][examples]") {
  const SolvedScene run = run_of("bolt_in_tube");
  CHECK(run.solution.contact.active().size() == run.model.pairs.node.size());
  Index middle = 0;
  run.model.pairs.position.col(1).cwiseAbs().minCoeff(&middle);
  const double long_bodies = 210e3 * 0.01 * (20 * 20 - 10 * 10) / (2 * 10 * 20 * 20);
  CAPTURE(run.solution.pressure(middle), long_bodies);
  CHECK(std::abs(run.solution.pressure(middle) / long_bodies - 1) < 0.02);
}

// Along a track that hardly gives way friction is mu times the pressure, over however many edges.
TEST_CASE("the dragged block of the examples moves, at mu times its force", "[scene_file][examples]") {
  const SceneFile file = read_scene(root / "examples" / "dragged_block.toml");
  const PathEnd end = solve_steps(file.scene, [&](const Model& model, const Step& step) {
    const Resultants sum = resultants(model, step.solution);
    CHECK(step.solution.certificate.holds());
    if (step.state.time > 1.3)
      CHECK(std::abs(sum.force.x() / sum.force.y()) == Approx(0.3).epsilon(1e-5));
  });
  INFO(end.reason);
  CHECK(end.status == SolveStatus::Solved);
}

TEST_CASE("the keys of the examples are those that are read", "[scene_file]") {
  CHECK(content("examples/results/keys.md") == key_reference());
  CHECK(content("examples/README.md")
            .find("```toml\n" + content("examples/cantilever.toml") + "```") != std::string::npos);
}

// A block that slides carries mu times its load: 0.3 x 5 x 40. Each step of 0.01 then loses 60 x 0.01, and round the loop
// from the end of the first way to the end of the last the work of the drag is what friction lost.
TEST_CASE("the block of the examples slides at the force of its weight times mu",
          "[scene_file][examples]") {
  const SceneFile file = read_scene(root / "examples" / "to_and_fro.toml");
  std::vector<double> drag, lost;
  Work at_first, at_last;
  WorkMeter meter;
  const PathEnd end = solve_steps(file.scene, [&](const Model& model, const Step& step) {
    meter.add(model, step);
    drag.push_back(resultants(model, step.solution).force.x());
    lost.push_back(step.state.dissipation.sum());
    if (step.state.steps == 11) at_first = meter.work();
    at_last = meter.work();
  });
  REQUIRE(end.status == SolveStatus::Solved);
  REQUIRE(drag.size() == 51);
  for (const std::size_t k : {8, 9, 10, 48, 49, 50}) {
    CHECK(drag[k] == Approx(-60).epsilon(1e-12));
    CHECK(lost[k] - lost[k - 1] == Approx(60 * 0.01).epsilon(1e-10));
  }
  CHECK(drag[30] == Approx(60).epsilon(1e-12));
  const double put_in = at_last.put_in() - at_first.put_in();
  const double dissipated = at_last.dissipation - at_first.dissipation;
  const double between = at_last.between - at_first.between;
  CHECK(at_last.strain == Approx(at_first.strain).epsilon(1e-10));
  CHECK(put_in == Approx(dissipated + between).epsilon(1e-10));
  CHECK(dissipated > 11);
}
