// The accuracy of the example of Lin et al., section 3.1, over many meshes and on fine ones.
#include <algorithm>
#include <cmath>

#include "catch_compat.hpp"
#include "support/hertz_reading.hpp"

using Eigen::Index;
using namespace signorini;
using signorini_test::HertzProblem;
using signorini_test::HertzReading;
using signorini_test::read_hertz;
using signorini_test::scene_of;

TEST_CASE("Hertz: 72 meshes of 1200 to 1412 nodes stay within 0.4 % in pressure, 0.6 % in width",
          "[hertz][LinEtAl-43]") {
  std::vector<double> q, b;
  for (const double core : {1.3, 1.4, 1.5, 1.6})
    for (const Index plate_cells : {14, 15, 16})  // 16 matches
      for (const Index layers : {14, 15, 16})
        for (const double grading : {1.0, 3.0}) {
          HertzProblem problem;
          problem.mesh.core = core;
          problem.mesh.plate_cells = plate_cells;
          problem.mesh.disc_layers = layers;
          problem.mesh.plate_layers = layers + 1;
          problem.mesh.layer_grading = grading;
          CAPTURE(core, plate_cells, layers, grading);
          const HertzReading out = read_hertz(problem, solved(scene_of(problem), "Hertz"));
          q.push_back(std::abs(out.peak_error));
          b.push_back(std::abs(out.width_error));
          CHECK(q.back() <= 4e-3);
          CHECK(b.back() <= 6e-3);
        }
  REQUIRE(q.size() == 72);
  std::nth_element(q.begin(), q.begin() + 36, q.end());
  std::nth_element(b.begin(), b.begin() + 36, b.end());
  CHECK(q[36] <= 1.1e-3);  // medians
  CHECK(b[36] <= 1.6e-3);
}

TEST_CASE("Hertz: 20 000 nodes give pressure to 0.02 % and half-width to 0.05 %",
          "[hertz][LinEtAl-43]") {
  HertzProblem problem;
  problem.mesh.disc_cells = problem.mesh.plate_cells = 64;
  problem.mesh.disc_rows = problem.mesh.plate_rows = 48;
  problem.mesh.disc_layers = problem.mesh.plate_layers = 60;
  CHECK(signorini_test::n_nodes(problem.mesh) <= 20000);
  const SolvedScene run = solved(scene_of(problem), "Hertz");
  const HertzReading out = read_hertz(problem, run);
  CHECK(std::abs(out.peak_error) <= 2e-4);
  CHECK(std::abs(out.width_error) <= 5e-4);
  CHECK(run.solution.certificate.holds());
}
