#include <algorithm>
#include <string>
#include <vector>

#include "addons/files/pvd.hpp"
#include "addons/vtu/vtu.hpp"
#include "catch_compat.hpp"
#include "meshes/split.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/fem/von_mises.hpp"
#include "signorini/scene/readings.hpp"
#include "support/cantilever.hpp"
#include "support/folder.hpp"
#include "support/message.hpp"
#include "support/two_bodies.hpp"
#include "support/vtu_file.hpp"

using namespace signorini;
using signorini_test::array_of;
using signorini_test::content_of;
using signorini_test::Folder;
using signorini_test::is_balanced;

namespace {

struct Solved {
  Model model;
  Solution solution;
};

Solved solved(const std::string& element) {
  const Scene scene = signorini_test::cantilever(element, 10, 2);
  Ledger ledger;
  Model model = build(scene, ledger);
  const Condensed condensed = condense(model, ledger);
  Solution solution = solve(model, condensed, scene.solver, ledger);
  return {std::move(model), std::move(solution)};
}

}  // namespace

TEST_CASE("a VTU file is well formed and its arrays have the sizes it names", "[vtu]") {
  const Folder folder;
  for (const char* element : {"q4_incompatible", "q8"}) {
    CAPTURE(element);
    const Solved run = solved(element);
    const std::filesystem::path path = folder.path() / "beam.vtu";
    write_vtu(path, run.model, run.solution, {}, VtuNumbers::Ascii);
    const std::string file = content_of(path);
    const auto points = static_cast<std::size_t>(run.model.bodies[0].mesh.n_nodes());
    const auto cells = static_cast<std::size_t>(run.model.bodies[0].mesh.n_cells());
    const auto nodes = static_cast<std::size_t>(run.model.bodies[0].mesh.cells.cols());
    CHECK(is_balanced(file));
    CHECK_THAT(file, ContainsSubstring("type=\"UnstructuredGrid\"") &&
                         ContainsSubstring("NumberOfPoints=\"" + std::to_string(points) + '"') &&
                         ContainsSubstring("NumberOfCells=\"" + std::to_string(cells) + '"'));
    CHECK(array_of(file, "displacement").size() == 3 * points);
    CHECK(array_of(file, "stress").size() == 4 * points);
    CHECK(array_of(file, "von_mises").size() == points);
    CHECK(array_of(file, "contact_pressure").size() == points);
    CHECK(array_of(file, "contact_gap").size() == points);
    CHECK(array_of(file, "contact_traction").size() == 3 * points);
    CHECK(array_of(file, "contact_slip").size() == points);
    for (const char* absent : {"contact_shear_traction", "contact_slip_total", "contact_motion",
                               "contact_number", "body"})
      CHECK(array_of(file, absent).empty());
    CHECK(array_of(file, "cell_stress").size() == 4 * cells);
    CHECK(array_of(file, "points").size() == 3 * points);
    CHECK(array_of(file, "connectivity").size() == nodes * cells);
    const std::vector<std::string> offsets = array_of(file, "offsets");
    REQUIRE(offsets.size() == cells);
    CHECK(offsets.back() == std::to_string(nodes * cells));
    const std::vector<std::string> types = array_of(file, "types");
    CHECK(types == std::vector<std::string>(cells, nodes == 4 ? "9" : "23"));
  }
}

TEST_CASE("triangles and quadrilaterals stand in a VTU file as what they are", "[vtu]") {
  const Folder folder;
  for (const char* element : {"q4_incompatible", "q8"}) {
    Scene scene = signorini_test::cantilever(element, 2, 1);
    scene.bodies[0].mesh = split(scene.bodies[0].mesh, {1});
    const SolvedScene run = signorini::solved(scene, "beam");
    write_vtu(folder.path() / "beam.vtu", run.model, run.solution, {}, VtuNumbers::Ascii);
    const std::string file = content_of(folder.path() / "beam.vtu");
    using Words = std::vector<std::string>;
    const bool linear = run.model.bodies[0].mesh.order() == MeshOrder::Linear;
    CHECK(array_of(file, "types") == (linear ? Words{"9", "5", "5"} : Words{"23", "22", "22"}));
    CHECK(array_of(file, "offsets") == (linear ? Words{"4", "7", "10"} : Words{"8", "14", "20"}));
    Words nodes;
    for (const Eigen::Index node : run.model.bodies[0].mesh.cells.reshaped<Eigen::RowMajor>())
      if (node >= 0) nodes.push_back(std::to_string(node));
    CHECK(array_of(file, "connectivity") == nodes);
  }
}

TEST_CASE("a VTU file holds the solution at the right nodes", "[vtu]") {
  const Folder folder;
  const Solved run = solved("q4_incompatible");
  write_vtu(folder.path() / "beam.vtu", run.model, run.solution, {}, VtuNumbers::Ascii);
  const std::string file = content_of(folder.path() / "beam.vtu");
  const std::vector<std::string> u = array_of(file, "displacement");
  const std::vector<std::string> pressure = array_of(file, "contact_pressure");
  const std::vector<std::string> gap = array_of(file, "contact_gap");
  const std::vector<std::string> status = array_of(file, "contact_status");
  REQUIRE(status.size() == gap.size());
  const std::vector<Eigen::Index>& active = run.solution.contact.active();
  CHECK_FALSE(active.empty());
  CHECK(std::count(status.begin(), status.end(), "1") == static_cast<long>(active.size()));
  const std::vector<std::string> points = array_of(file, "points");
  const std::vector<std::string> stress = array_of(file, "stress");
  const std::vector<std::string> mises = array_of(file, "von_mises");
  const std::vector<Eigen::Index>& pair_nodes = run.model.pairs.node;
  for (std::size_t node = 0; node < gap.size(); ++node) {
    const auto row = static_cast<Eigen::Index>(node);
    CAPTURE(node);
    CHECK(std::stod(u[3 * node + 1]) == run.solution.displacements[0](row, 1));
    for (std::size_t k = 0; k < 2; ++k)  // where the body was without loads
      CHECK(std::stod(points[3 * node + k]) ==
            run.model.bodies[0].mesh.nodes(row, static_cast<Eigen::Index>(k)));
    Eigen::Vector4d s;
    for (Eigen::Index k = 0; k < 4; ++k)
      s(k) = std::stod(stress[4 * node + static_cast<std::size_t>(k)]);
    CHECK(std::stod(mises[node]) == Approx(von_mises(s)).epsilon(1e-7));
    const auto pair = std::find(pair_nodes.begin(), pair_nodes.end(), row);
    if (pair == pair_nodes.end()) {
      CHECK(gap[node] == "0");
      CHECK(pressure[node] == "0");
      CHECK(status[node] == "-1");
    } else {
      const bool closed =
          std::binary_search(active.begin(), active.end(), pair - pair_nodes.begin());
      CHECK(status[node] == (closed ? "1" : "0"));
      CHECK(std::stod(pressure[node]) ==
            Approx(run.solution.pressure(pair - pair_nodes.begin())).epsilon(1e-8).margin(1e-12));
    }
  }
}

TEST_CASE("a VTU file of a body of revolution has its hoop stress", "[vtu][axial]") {
  Scene scene =
      signorini_test::two_blocks(signorini_test::named_block("lower", {0, 0}, {2, 1}, 2, 1),
                                 signorini_test::named_block("upper", {0, 1}, {2, 1}, 2, 1));
  for (signorini::Body& body : scene.bodies) {
    body.material = {1000, 0.3, signorini::PlaneState::Axial, 1};
    body.loads.edges = {{"right", 2, {}}};
  }
  scene.bodies[0].supports = {symmetric("bottom")};
  scene.bodies[1].loads.edges.push_back({"top", 5, {}});
  const SolvedScene run = signorini::solved(scene, "cylinders");
  const Folder folder;
  write_vtu(folder.path() / "cylinders.vtu", run.model, run.solution, {}, VtuNumbers::Ascii);
  const std::vector<std::string> stress =
      array_of(content_of(folder.path() / "cylinders.vtu"), "cell_stress");
  const std::string file = content_of(folder.path() / "cylinders.vtu");
  CHECK(array_of(file, "body") == std::vector<std::string>{"0", "0", "1", "1"});
  CHECK(array_of(file, "body 1: " + run.model.bodies[1].mesh.name) == std::vector<std::string>{"1"});
  CHECK_THAT(file, ContainsSubstring("ComponentName2=\"xy\" ComponentName3=\"zz\""));
  // The upper one is the source: it has the pairs, at its lower three nodes.
  using Words = std::vector<std::string>;
  CHECK(array_of(file, "contact_status") ==
        Words{"-1", "-1", "-1", "-1", "-1", "-1", "1", "1", "1", "-1", "-1", "-1"});
  const Words corners = array_of(file, "connectivity");
  REQUIRE(corners.size() == 16);
  CHECK(std::all_of(corners.begin() + 8, corners.end(), [](const std::string& c) { return std::stoi(c) >= 6; }));
  CHECK(array_of(file, "offsets") == Words{"4", "8", "12", "16"});
  REQUIRE(stress.size() == 4 * 4);
  const double exact[] = {-2, -5, 0, -2};
  for (std::size_t k = 0; k < stress.size(); ++k)
    CHECK(std::stod(stress[k]) == Approx(exact[k % 4]).epsilon(1e-8).margin(1e-8));
}

TEST_CASE("pairs at Gauss points belong to no node, and no node of a VTU file says that it touches",
          "[vtu][gauss_points]") {
  Scene scene =
      signorini_test::two_blocks(signorini_test::named_block("lower", {0, 0}, {2, 1}, 2, 1),
                                 signorini_test::named_block("upper", {0, 1}, {2, 1}, 2, 1));
  scene.bodies[1].supports = {symmetric("left")};
  scene.bodies[1].loads.edges = {{"top", 1, {}}};
  scene.contacts[0].gap_operator = "gauss_points";
  const SolvedScene run = signorini::solved(scene, "blocks");
  CHECK_FALSE(run.solution.contact.active().empty());
  const Folder folder;
  write_vtu(folder.path() / "blocks.vtu", run.model, run.solution, {}, VtuNumbers::Ascii);
  const std::string file = content_of(folder.path() / "blocks.vtu");
  CHECK(array_of(file, "contact_pressure") == std::vector<std::string>(12, "0"));
  CHECK(array_of(file, "contact_gap") == std::vector<std::string>(12, "0"));
  CHECK(array_of(file, "contact_status") == std::vector<std::string>(12, "-1"));
}

TEST_CASE("a binary VTU file holds the bits of the text, in fewer bytes", "[vtu]") {
  const Folder folder;
  Scene scene =
      signorini_test::two_blocks(signorini_test::named_block("lower", {0, 0}, {2, 1}, 3, 2),
                                 signorini_test::named_block("upper", {0, 1}, {2, 1}, 2, 1));
  scene.bodies[1].supports = {symmetric("left")};
  scene.bodies[1].loads.edges = {{"top", 1, {}}};
  const SolvedScene run = signorini::solved(scene, "blocks");
  write_vtu(folder.path() / "text.vtu", run.model, run.solution, {}, VtuNumbers::Ascii);
  write_vtu(folder.path() / "bytes.vtu", run.model, run.solution);
  const std::string text = content_of(folder.path() / "text.vtu");
  const std::string bytes = content_of(folder.path() / "bytes.vtu");
  for (const char* name : {"displacement", "stress", "von_mises", "contact_pressure",
                           "contact_traction", "cell_stress", "points"}) {
    CAPTURE(name);
    std::vector<double> numbers;
    for (const std::string& word : array_of(text, name)) numbers.push_back(std::stod(word));
    CHECK_FALSE(numbers.empty());
    CHECK(signorini_test::appended_array_of<double>(bytes, name) == numbers);
  }
  for (const char* name : {"contact_status", "body", "connectivity", "offsets"}) {
    CAPTURE(name);
    std::vector<std::int64_t> numbers;
    for (const std::string& word : array_of(text, name)) numbers.push_back(std::stol(word));
    CHECK_FALSE(numbers.empty());
    CHECK(signorini_test::appended_array_of<std::int64_t>(bytes, name) == numbers);
  }
  const auto types = signorini_test::appended_array_of<std::uint8_t>(bytes, "types");
  CHECK(types.size() == array_of(text, "types").size());
  CHECK(std::to_string(types.front()) == array_of(text, "types").front());
}

TEST_CASE("the notes of a solution are comments of its VTU file", "[vtu]") {
  const Folder folder;
  Solved run = solved("q4");
  write_vtu(folder.path() / "none.vtu", run.model, run.solution, {}, VtuNumbers::Ascii);
  CHECK(content_of(folder.path() / "none.vtu").find("<!--") == std::string::npos);
  run.solution.notes = {"a < b & c", "two -- three---four"};
  write_vtu(folder.path() / "notes.vtu", run.model, run.solution, {}, VtuNumbers::Ascii);
  const std::string file = content_of(folder.path() / "notes.vtu");
  CHECK(is_balanced(file));
  CHECK_THAT(file, ContainsSubstring("<!-- note: a < b & c -->\n") &&
                       ContainsSubstring("<!-- note: two - - three- - -four -->\n"));
  CHECK(file.find("FieldData") == std::string::npos);
}

TEST_CASE("what XML cannot hold is a question mark in a VTU file, and no name in a collection", "[vtu]") {
  const Folder folder;
  Solved run = solved("q4");
  run.model.contacts = {"a\x01 \xff\xc3\xa4 \xef\xbf\xbf\x1b", "b"};
  run.solution.notes = {"b\x01\xff"};
  write_vtu(folder.path() / "odd.vtu", run.model, run.solution, {}, VtuNumbers::Ascii);
  const std::string file = content_of(folder.path() / "odd.vtu");
  CHECK(is_balanced(file));
  CHECK_THAT(file, ContainsSubstring("a? ?\xc3\xa4 ????") && ContainsSubstring("note: b?? -->"));
  CHECK(file.find('\x01') == std::string::npos);
  // There is no file of that name, so that a collection is not written.
  CHECK_THAT(signorini_test::problem_message([&] { write_pvd(folder.path() / "odd.pvd", {{1, "a\xff.vtu"}}); }),
             ContainsSubstring("no file of XML can hold this name"));
  CHECK_FALSE(std::filesystem::exists(folder.path() / "odd.pvd"));
}

TEST_CASE("nothing is written of a problem that is not solved, or where nobody can write",
          "[vtu]") {
  const Folder folder;
  Solved run = solved("q4");
  CHECK_THAT(signorini_test::problem_message([&] {
               write_vtu(folder.path() / "missing" / "beam.vtu", run.model, run.solution, {},
                         VtuNumbers::Ascii);
             }),
             ContainsSubstring("beam.vtu"));
  run.solution.contact.report.status = SolveStatus::Infeasible;
  CHECK_THROWS_AS(write_vtu(folder.path() / "beam.vtu", run.model, run.solution),
                  std::invalid_argument);
  CHECK(folder.entries() == 0);
}

TEST_CASE("a collection names the file of every time, and is read back", "[vtu]") {
  const Folder folder;
  const std::filesystem::path file = folder.path() / "all.pvd";
  const std::vector<TimedFile> files = {{1.0 / 3, "a_0001.vtu"}, {2, "<\"R&D\" &lt;>_0002.vtu"}};
  write_pvd(file, files);
  const std::string content = content_of(file);
  CHECK(is_balanced(content));
  CHECK_THAT(content, ContainsSubstring("timestep=\"0.3333333333333333"));
  CHECK_THAT(content, ContainsSubstring("file=\"a_0001.vtu\"/>"));
  const std::vector<TimedFile> back = read_pvd(content);
  REQUIRE(back.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(back[k].time == files[k].time);
    CHECK(back[k].file == files[k].file);
  }
  CHECK(read_pvd("<DataSet timestep=\"one\" file=\"a\"/>\n<DataSet timestep=\"1\"/>\n").empty());
  CHECK_THROWS_AS(write_pvd(folder.path() / "nowhere" / "a.pvd", files), ProblemError);
}
