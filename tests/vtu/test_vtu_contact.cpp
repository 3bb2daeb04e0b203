#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "addons/steps/steps.hpp"
#include "addons/vtu/vtu.hpp"
#include "catch_compat.hpp"
#include "meshes/reshape.hpp"
#include "signorini/scene/readings.hpp"
#include "support/cantilever.hpp"
#include "support/folder.hpp"
#include "support/two_bodies.hpp"
#include "support/vtu_file.hpp"

using namespace signorini;
using signorini_test::array_of;
using signorini_test::content_of;
using signorini_test::Folder;
using signorini_test::is_balanced;

TEST_CASE("a VTU file shows friction and tells contacts apart", "[vtu][friction]") {
  Scene scene;
  scene.bodies[0].mesh = signorini_test::named_block("block", {0, 0}, {4, 2}, 8, 4);
  scene.bodies[0].material = {1000, 0.3, PlaneState::Strain, 1};
  scene.bodies[0].loads.edges = {{"top", 5, {}}, {"right", 1, {}}};
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})},
                    {{"left"}, half_plane({0, 0}, {1, 0})}};
  scene.contacts[0].friction = Friction{0.1, 0};
  const SolvedScene run = solved(scene, "block");
  const ContactState& contact = run.solution.contact;
  const Folder folder;
  write_vtu(folder.path() / "block.vtu", run.model, run.solution, {}, VtuNumbers::Ascii);
  const std::string file = content_of(folder.path() / "block.vtu");
  CHECK(is_balanced(file));
  const auto points = static_cast<std::size_t>(run.model.bodies[0].mesh.n_nodes());
  const std::vector<std::string> traction = array_of(file, "contact_traction");
  const std::vector<std::string> shear = array_of(file, "contact_shear_traction");
  const std::vector<std::string> slip = array_of(file, "contact_slip");
  const std::vector<std::string> contact_status = array_of(file, "contact_motion");
  const std::vector<std::string> number = array_of(file, "contact_number");
  REQUIRE(traction.size() == 3 * points);
  for (const auto* words : {&shear, &slip, &contact_status, &number})
    REQUIRE(words->size() == points);
  CHECK(array_of(file, "contact_slip_total").empty());
  // 9 nodes on the floor and 5 at the wall have one in common, where the floor bears more.
  CHECK(std::count(number.begin(), number.end(), "0") == 9);
  CHECK(std::count(number.begin(), number.end(), "1") == 4);
  CHECK(std::count(contact_status.begin(), contact_status.end(), "-1") ==
        static_cast<long>(points) - 9);
  CHECK(std::count(contact_status.begin(), contact_status.end(), "2") > 0);
  for (std::size_t k = 1; k < contact.frictional_pairs.size(); ++k) {  // without the corner
    const auto row = static_cast<Eigen::Index>(k);
    const Eigen::Index pair = contact.frictional_pairs[k];
    const auto node =
        static_cast<std::size_t>(run.model.pairs.node[static_cast<std::size_t>(pair)]);
    const double pressure = run.solution.pressure(pair);
    CAPTURE(node);
    CHECK(contact_status[node] == std::to_string(static_cast<int>(contact.contact_status[k])));
    CHECK(std::stod(shear[node]) ==
          Approx(contact.friction(row) / run.model.pairs.weight(pair)).epsilon(1e-8).margin(0));
    CHECK(std::stod(slip[node]) == Approx(increment(contact)(row)).epsilon(1e-8).margin(0));
    CHECK(std::stod(traction[3 * node]) == Approx(std::stod(shear[node])).epsilon(1e-8).margin(0));
    CHECK(std::stod(traction[3 * node + 1]) == Approx(pressure).epsilon(1e-8).margin(0));
  }
  CHECK(array_of(file, "contact 0: block.bottom on half plane") == std::vector<std::string>{"0"});
  CHECK(array_of(file, "contact 1: block.left on half plane") == std::vector<std::string>{"1"});
}

TEST_CASE("the contact tractions of a VTU file bear the weight of a block on any slope",
          "[vtu][friction][closed-form]") {
  const double angle = GENERATE(-0.5, 0.0, 0.4, 2.0, 3.0);  // two of them are overhead
  CAPTURE(angle);
  const Eigen::Vector2d along(std::cos(angle), std::sin(angle)), out(-along.y(), along.x());
  Scene scene;
  Body& body = scene.bodies[0];
  body.mesh = mapped(signorini_test::named_block("block", {0, 0}, {4, 1}, 8, 2),
                     [&](const auto& x) { return Eigen::Vector2d(x.x() * along + x.y() * out); });
  body.material = {1e4, 0.3, PlaneState::Strain, 1};
  const Eigen::Vector2d load = -3 * out - along;
  body.loads.body_force = [load](const Eigen::Vector2d&) { return load; };
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, out)}};
  scene.contacts[0].friction = Friction{0.8, 0};
  const SolvedScene run = solved(scene, "block");
  const Folder folder;
  write_vtu(folder.path() / "block.vtu", run.model, run.solution, {}, VtuNumbers::Ascii);
  const std::vector<std::string> traction =
      array_of(content_of(folder.path() / "block.vtu"), "contact_traction");
  Eigen::Vector2d force(0, 0);
  for (Eigen::Index pair = 0; pair < run.model.pairs.weight.size(); ++pair) {
    const auto node =
        static_cast<std::size_t>(run.model.pairs.node[static_cast<std::size_t>(pair)]);
    force += run.model.pairs.weight(pair) *
             Eigen::Vector2d(std::stod(traction[3 * node]), std::stod(traction[3 * node + 1]));
  }
  CHECK((force + 4 * load).norm() <= 1e-7 * 4 * load.norm());
}

TEST_CASE("a VTU file of a load step has the slip in total", "[vtu][steps]") {
  SolvedScene run = solved(signorini_test::cantilever("q4", 10, 2), "beam");
  const Eigen::Index pair = run.solution.contact.active().front();
  const auto node = static_cast<std::size_t>(run.model.pairs.node[static_cast<std::size_t>(pair)]);
  run.solution.contact.frictional_pairs = {pair};
  run.solution.contact.contact_status[static_cast<std::size_t>(pair)] = ContactStatus::SlipBackward;
  run.solution.contact.friction = Eigen::VectorXd::Constant(1, 3);
  run.solution.contact.slip = Eigen::VectorXd::Constant(1, -0.5);
  PathState state;
  state.slip = Eigen::VectorXd::Constant(1, -1.5);
  state.dissipation = Eigen::VectorXd::Constant(1, 4.5);
  const Folder folder;
  write_vtu(folder.path() / "step.vtu", run.model, run.solution, totals(&state), VtuNumbers::Ascii);
  const std::string file = content_of(folder.path() / "step.vtu");
  CHECK(array_of(file, "contact_slip").at(node) == "-0.5");
  CHECK(array_of(file, "contact_slip_total").at(node) == "-1.5");
  CHECK(array_of(file, "contact_motion").at(node) == "3");
  state.slip.setZero(2);
  CHECK_THROWS_AS(write_vtu(folder.path() / "other.vtu", run.model, run.solution, totals(&state),
                            VtuNumbers::Ascii),
                  std::invalid_argument);
}
