// What scene files say arrives in the scene, key by key.
#include "addons/files/gmsh.hpp"
#include "addons/files/scene_file.hpp"
#include "catch_compat.hpp"
#include "signorini/core/family.hpp"
#include "signorini/fem/elements.hpp"
#include "support/message.hpp"

using namespace signorini;
using Eigen::Vector2d;
using signorini_test::problem_message;

namespace {

const std::string material = "material = { youngs_modulus = 10, poisson_ratio = 0.25 }\n";
const std::string block = "mesh = { kind = \"block\", size = [4, 2], cells = [4, 2] }\n";

SceneFile parsed(const std::string& content) {
  return parse_scene(content, "name", std::string(SIGNORINI_TEST_DATA) + "/gmsh");
}

Body body_of(const std::string& lines) {
  return parsed(material + "[body]\n" + block + lines).scene.bodies.at(0);
}

Mesh mesh_of(const std::string& keys) {
  return parsed(material + "[body]\nmesh = { " + keys + " }\n").scene.bodies.at(0).mesh;
}

ContactSpec contact_of(const std::string& lines) {
  return parsed(material + "[body]\n" + block + "[contact]\nsource = \"bottom\"\n" + lines)
      .scene.contacts.at(0);
}

std::string complaint(const std::string& content) {
  return problem_message([&] { static_cast<void>(parsed(content)); });
}

const std::string floor_below =
    "target = { kind = \"half_plane\", point = [0, -1], normal = [0, 1] }\n";

}  // namespace

TEST_CASE("title, solver and output of a scene file", "[scene_file]") {
  const SceneFile file = parsed(
      "title = \"A beam\"\nsolver = \"lemke\"\n" + material +
      "output = { vtu = \"a\", csv = \"b\", plot = \"c.svg\", state = \"d\" }\n[[body]]\n" + block);
  CHECK(file.title == "A beam");
  CHECK(file.scene.solver.name == std::string("lemke"));
  CHECK(file.output.vtu == "a");
  CHECK(file.output.csv == "b");
  CHECK(file.output.plot == "c.svg");
  CHECK(file.output.state == "d");
  CHECK(file.name == "name");
  CHECK(file.body_lines == std::vector<std::size_t>{5});
  CHECK(file.contact_lines.empty());
}

TEST_CASE("what is left out has the value of the library", "[scene_file]") {
  const Scene usual;
  const Body body = body_of("");
  CHECK(body.element == usual.bodies[0].element);
  CHECK(body.mesh.name == "body");
  CHECK(body.supports.empty());
  CHECK(body.layers.empty());
  CHECK(body.springs.empty());
  CHECK_FALSE(body.temperature);
  CHECK_FALSE(body.loads.body_force);
  CHECK(body.loads.edges.empty());
  CHECK(body.loads.points.empty());
  CHECK(body.material.state == Material().state);
  CHECK(body.material.thickness == Material().thickness);
  CHECK(body.material.expansion == Material().expansion);
  const ContactSpec contact = contact_of(floor_below), plain;
  CHECK(contact.gap_operator == plain.gap_operator);
  CHECK(contact.quadrature == plain.quadrature);
  CHECK(contact.points == plain.points);
  CHECK_FALSE(contact.friction);
  CHECK_FALSE(contact.interference);
  CHECK_FALSE(contact.adjust);
}

TEST_CASE("materials of the scene and of a body", "[scene_file]") {
  const SceneFile file =
      parsed(material + "[[body]]\nname = \"a\"\n" + block + "[[body]]\nname = \"b\"\n" + block +
             "material = { youngs_modulus = 3, poisson_ratio = 0.1, state = \"plane stress\", "
             "thickness = 2, expansion = 1e-5 }\n");
  CHECK(file.scene.bodies[0].material.youngs_modulus == 10);
  CHECK(file.scene.bodies[0].material.poisson_ratio == 0.25);
  CHECK(file.scene.bodies[1].material.youngs_modulus == 3);
  CHECK(file.scene.bodies[1].material.poisson_ratio == 0.1);
  CHECK(file.scene.bodies[1].material.state == PlaneState::Stress);
  CHECK(file.scene.bodies[1].material.thickness == 2);
  CHECK(file.scene.bodies[1].material.expansion == 1e-5);
}

TEST_CASE("supports of a scene file", "[scene_file]") {
  const Body body = body_of(
      "fixed = \"left\"\nsymmetric = [\"bottom\", \"top\"]\nprescribed = { right = { x = 0.5, y = "
      "0.25 } }\n"
      "point = [{ at = [2, 0], x = 0.125 }, { at = [2, 2], y = 1 }]\n");
  REQUIRE(body.supports.size() == 7);
  CHECK(body.supports[0].boundary == "left");
  CHECK(body.supports[0].holds_x);
  CHECK(body.supports[0].holds_y);
  CHECK(body.supports[1].boundary == "bottom");
  CHECK(body.supports[2].boundary == "top");
  CHECK(body.supports[2].normal_only);
  const Vector2d origin(0, 0);
  CHECK(body.supports[3].holds_x);
  CHECK(body.supports[3].displacement(origin).x() == 0.5);
  CHECK(body.supports[4].holds_y);
  CHECK(body.supports[4].displacement(origin).y() == 0.25);
  CHECK(body.supports[5].boundary == "bottom");
  CHECK(body.supports[5].only_at == Vector2d(2, 0));
  CHECK(body.supports[5].holds_x);
  CHECK_FALSE(body.supports[5].holds_y);
  CHECK(body.supports[5].displacement(origin).x() == 0.125);
  CHECK(body.supports[6].boundary == "top");
  CHECK(body.supports[6].holds_y);
}

TEST_CASE("loads, springs and temperature of a scene file", "[scene_file]") {
  const Body body = body_of(
      "pressure = { top = 3, right = -2 }\ntraction.left = [1, -1]\nbody_force = [0, "
      "-7]\nspring.bottom = [0, 50]\n"
      "point = { at = [4, 2], force = [5, 6], spring = [7, 8] }\ntemperature = { uniform = 20, "
      "gradient = [1, 2] }\n");
  const Vector2d origin(0, 0);
  REQUIRE(body.loads.edges.size() == 3);
  CHECK(body.loads.edges[0].boundary == "top");  // in the order of the file
  CHECK(body.loads.edges[0].pressure == 3);
  CHECK(body.loads.edges[1].boundary == "right");
  CHECK(body.loads.edges[1].pressure == -2);
  CHECK(body.loads.edges[2].boundary == "left");
  CHECK(body.loads.edges[2].traction(origin) == Vector2d(1, -1));
  CHECK(body.loads.body_force(origin) == Vector2d(0, -7));
  REQUIRE(body.loads.points.size() == 1);
  CHECK(body.loads.points[0].point == Vector2d(4, 2));
  CHECK(body.loads.points[0].force == Vector2d(5, 6));
  REQUIRE(body.springs.size() == 2);
  CHECK(body.springs[0].boundary == "bottom");
  CHECK(body.springs[0].stiffness == Vector2d(0, 50));
  CHECK_FALSE(body.springs[0].only_at);
  CHECK(body.springs[1].only_at == Vector2d(4, 2));
  CHECK(body.springs[1].stiffness == Vector2d(7, 8));
  REQUIRE(body.temperature);
  CHECK(body.temperature->uniform == 20);
  CHECK(body.temperature->gradient == Vector2d(1, 2));
  CHECK(body_of("temperature = 5\n").temperature->uniform == 5);
}

TEST_CASE("layers have the material of their body but for what they say", "[scene_file]") {
  const Body body = body_of("layer = { box = [0, 1, 4, 2], youngs_modulus = 99 }\n");
  REQUIRE(body.layers.size() == 1);
  CHECK(body.layers[0].material.youngs_modulus == 99);
  CHECK(body.layers[0].material.poisson_ratio == 0.25);
  CHECK(body.mesh.regions.at(body.layers[0].region) == std::vector<Eigen::Index>{4, 5, 6, 7});
}

// The cells of the block are squares of 1.
TEST_CASE("a box of a layer that cuts cells is noted, with what its layer takes", "[scene_file]") {
  const auto notes = [](const std::string& box) {
    return parsed(material + "[body]\n" + block + "layer = { box = [" + box +
                  "], youngs_modulus = 99 }\n")
        .notes;
  };
  for (const char* whole : {"0, 1, 4, 2", "-9, 1, 9, 9", "1, 0, 3, 1", "0, 0.9999999999, 4, 2"})
    CHECK(notes(whole).empty());
  const std::vector<std::string> cut = notes("0, 1, 4, 1.75");
  REQUIRE(cut.size() == 1);
  CHECK(cut[0] ==
        "name:4: the edges of the box [0, 1, 4, 1.75] of a layer of 'body' cut 4 cells. A cell is "
        "in a "
        "layer whole or not at all, by its middle: the layer takes the cells of [0, 1, 4, 2]. Let "
        "cells end at the edges of the box if that is not meant");
  REQUIRE(notes("0.3, 0.3, 0.6, 0.6").size() == 1);  // no corner is inside
  CHECK(notes("0.3, 0.3, 0.6, 0.6")[0].find("cut 1 cell. ") != std::string::npos);
  CHECK(notes("0, 1.001, 3, 2")[0].find("cut 3 cells. ") != std::string::npos);  // those it covers
}

TEST_CASE("contacts of a scene file", "[scene_file]") {
  const ContactSpec rigid =
      contact_of(floor_below + "friction = 0.5\ninterference = 0.125\nadjust = 0.25\n");
  CHECK(rigid.source.boundary == "bottom");
  CHECK(rigid.source.body == "body");
  CHECK(rigid.friction->coefficient == 0.5);
  CHECK(rigid.friction->cohesion == 0);
  CHECK(rigid.interference == 0.125);
  CHECK(rigid.adjust == 0.25);
  CHECK(std::get<Obstacle>(rigid.target).look({3, 2}).gap == 3);
  CHECK(contact_of(floor_below + "friction = { coefficient = 0.5, cohesion = 2 }\n")
            .friction->cohesion == 2);
  const ContactSpec soft =
      contact_of("target = \"body.top\"\noperator = \"gauss_points\"\npoints = 3\n");
  CHECK(std::get<Side>(soft.target).boundary == "top");
  CHECK(soft.gap_operator == "gauss_points");
  CHECK(soft.points == 3);
  CHECK(contact_of("target = \"top\"\nquadrature = \"source edges\"\n").quadrature ==
        Quadrature::SourceEdges);
}

TEST_CASE("a list of boundaries is one side of a contact", "[scene_file]") {
  const std::string blocks =
      "material = { youngs_modulus = 1, poisson_ratio = 0.3 }\n"
      "[[body]]\nname = \"a\"\nmesh = { kind = \"block\", size = [4, 2], cells = [4, 2] }\n"
      "[[body]]\nname = \"b\"\nmesh = { kind = \"block\", corner = [0, 2], size = [4, 2], cells = [4, 2] }\n";
  const auto with = [&](const std::string& source) {
    return parse_scene(blocks + "[[contact]]\nsource = " + source + "\ntarget = \"a.top\"\n", "name", ".").scene;
  };
  const Scene scene = with("[\"b.left\", \"b.bottom\"]");
  CHECK(scene.contacts[0].source.body == "b");
  CHECK(scene.contacts[0].source.boundary == "left+bottom");
  CHECK(scene.bodies[1].mesh.boundaries.at("left+bottom").size() == 2 + 4);
  CHECK(with("[\"b.left\"]").contacts[0].source.boundary == "left");
  CHECK_THAT(problem_message([&] { static_cast<void>(with("[\"b.left\", \"a.left\"]")); }),
             ContainsSubstring("one of 'a', and the first one of 'b'"));
  CHECK_THAT(problem_message([&] { static_cast<void>(with("[\"b.left\", \"b.left\"]")); }),
             ContainsSubstring("'left' stands in the list twice"));
  CHECK_THAT(problem_message([&] { static_cast<void>(with("[]")); }),
             ContainsSubstring("a boundary or a list of them"));
}

TEST_CASE("rigid obstacles of a scene file are where it says", "[scene_file]") {
  const auto gap = [](const std::string& keys) {
    const ContactSpec contact = contact_of("target = { " + keys + " }\n");
    return std::get<Obstacle>(contact.target).look({3, 4}).gap;
  };
  CHECK(gap("kind = \"disc\", radius = 2") == 3);
  CHECK(gap("kind = \"disc\", radius = 2, centre = [3, 0]") == 2);
  CHECK(gap("kind = \"hole\", radius = 7") == 2);
  CHECK(gap("kind = \"pin_in_hole\", clearance = 0.5, shift = [0, 0.25], centre = [3, 0]") == 0.25);
  CHECK(gap("kind = \"parabola\", point = [3, 1], radius = 2") == 3);
}

TEST_CASE("meshes of every kind", "[scene_file]") {
  CHECK(
      mesh_of("kind = \"block\", size = [4, 2], cells = [4, 2], corner = [1, 1], grading = [2, 3]")
          .nodes.row(0) == Eigen::RowVector2d(1, 1));
  CHECK(mesh_of("kind = \"block\", size = [4, 2], cells = [4, 2], quadratic = true").cells.cols() ==
        8);
  const Mesh graded = mesh_of(
      "kind = \"graded_block\", x = { at = [0, 1, 4], cells = [2, 3], grading = [1, 2] }, y = { at "
      "= [0, 2], cells = [1] }");
  CHECK(graded.n_cells() == 5);
  CHECK(graded.nodes(2, 0) == 1);
  CHECK(mesh_of("kind = \"half_space\", width = 9, depth = 8, core = [1, 2], core_cells = [3, 4], "
                "layers = 5, layer_grading = 2")
            .n_cells() == 3 * 4 + (3 + 4) * 5);
  CHECK(mesh_of(
            "kind = \"edge_block\", edge = 1, width = 9, depth = 8, cells_under = 3, cells_beside "
            "= 4, cells_deep = 5, grading_under = 2, grading_beside = 3, grading_deep = 2")
            .n_cells() == 7 * 5);
  CHECK(mesh_of("kind = \"disc\", radius = 2, centre = [1, 1], part = \"lower right\", core = 0.4, "
                "core_roundness = 0.3, core_cells = 2, layers = 3, layer_grading = 2")
            .n_cells() == 4 + 3 * 4);
  CHECK(mesh_of("kind = \"pressed_disc\", radius = 50, pole = [0, 1], part = \"full\", core = [1, "
                "2], core_cells = [3, 4], layers = 5, layer_grading = 2")
            .boundaries.count("rim") == 1);
  const Mesh ring = mesh_of(
      "kind = \"ring\", inner_radius = 1, outer_radius = 2, centre = [1, 0], cells = [3, 2], "
      "grading = 2, sector = \"quarter\", rays = [0, 30, 60, 90]");
  CHECK(ring.n_cells() == 6);
  CHECK(ring.boundaries.count("symmetry_y") == 1);
  CHECK(mesh_of("kind = \"plate_with_hole\", hole_radius = 1, size = [6, 4], centre = [1, 1], "
                "cells = [7, 2], grading = 2, sector = \"half\", quadrants = [3, 4]")
            .n_cells() == 14);
  const Mesh filed =
      mesh_of("kind = \"gmsh\", file = \"two_bodies_q8_v41.msh\", surface = \"upper\"");
  CHECK(filed.name == "body");
  CHECK(filed.cells.cols() == 8);
  const Mesh both = mesh_of(
      "kind = \"gmsh\", file = \"two_bodies_q4_v41.msh\", surface = [\"lower plate\", \"upper\"]");
  CHECK(both.regions.count("upper") == 1);
  CHECK(both.n_cells() > filed.n_cells());
}

TEST_CASE("a file of several bodies gives each its own, in any order and twice", "[scene_file]") {
  const std::string name = "two_bodies_q4_v41.msh";
  const std::vector<Mesh> meshes = read_gmsh(std::string(SIGNORINI_TEST_DATA) + "/gmsh/" + name);
  const std::vector<std::string> surfaces = {"upper", "lower plate", "upper"};
  std::string content = material;
  for (std::size_t k = 0; k < surfaces.size(); ++k)
    content += text("[[body]]\nname = \"", k, "\"\nmesh = { kind = \"gmsh\", file = \"", name,
                    "\", surface = \"", surfaces[k], "\" }\n");
  const Scene scene = parsed(content).scene;
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    CAPTURE(k);
    const Mesh& expected = mesh_named(meshes, surfaces[k]);
    const Mesh& mesh = scene.bodies[k].mesh;
    REQUIRE(mesh.n_nodes() == expected.n_nodes());
    REQUIRE(mesh.n_cells() == expected.n_cells());
    CHECK(mesh.nodes == expected.nodes);
    CHECK(mesh.cells == expected.cells);
    CHECK(mesh.boundaries.size() == expected.boundaries.size());
  }
}

TEST_CASE("meshes are cut, mirrored, turned and moved in this order", "[scene_file]") {
  const Mesh mesh = mesh_of(
      "kind = \"block\", size = [4, 2], cells = [1, 1], triangles = true, mirror = \"level\", turn "
      "= 90, move = [10, 20]");
  CHECK(mesh.n_cells() == 2);
  CHECK(mesh.cells.cols() == 3);
  // (4, 2) -> (4, -2) -> (2, 4) -> (12, 24)
  CHECK(mesh.nodes.col(0).minCoeff() == 10);
  CHECK(mesh.nodes.col(0).maxCoeff() == 12);
  CHECK(mesh.nodes.col(1).minCoeff() == 20);
  CHECK(mesh.nodes.col(1).maxCoeff() == 24);
  check_mesh(mesh);
}

TEST_CASE("every member of a family can be named", "[scene_file]") {
  for (const GapOperator& gap_operator : gap_operators())
    CHECK(contact_of("target = \"top\"\noperator = \"" + std::string(gap_operator.name) + "\"\n")
              .gap_operator == gap_operator.name);
  for (const Element& element : elements())
    CHECK(key_reference().find(element.name) != std::string::npos);
}

TEST_CASE("a single body may leave out its name, a list stands for several things",
          "[scene_file]") {
  const SceneFile file =
      parsed(material + "body = [{ name = \"a\", " + block.substr(0, block.size() - 1) +
             " }, { name = \"b\", " + block.substr(0, block.size() - 1) +
             " }]\ncontact = [{ source = \"a.top\", target = \"b.bottom\" },\n { source = "
             "\"a.bottom\", target = \"b.top\" }]\n");
  CHECK(file.scene.bodies[1].mesh.name == "b");
  CHECK(file.contact_lines == std::vector<std::size_t>{3, 4});
  CHECK(std::get<Side>(file.scene.contacts[1].target).body == "b");
}

TEST_CASE("messages are short and show nothing that is not printed", "[scene_file]") {
  CHECK(complaint("title = 1\nbody = {}") == "name:1: title: expected a text, got the number 1");
  CHECK(complaint("\"\\u0007\" = 1") ==
        "name:1: ?: unknown key; there are: title, solver, material, body, contact, tie, "
        "relation, rigid, history, steps, halvings, moves, probe, output");
  const std::string longest(500, 'x');
  CHECK(complaint(longest + " = 1") ==
        "name:1: " + std::string(40, 'x') +
            "...: unknown key; there are: title, solver, material, "
            "body, contact, tie, relation, rigid, history, steps, halvings, moves, probe, output");
  CHECK(complaint("solver = \"" + longest + "\"\nbody = {}")
            .find(std::string(40, 'x') + "...'; there are:") != std::string::npos);
}

TEST_CASE("errors of later steps name the body or the contact", "[scene_file]") {
  const SceneFile file = parsed(material + "[[body]]\nname = \"a\"\n" + block +
                                "fixed = \"left\"\n[[body]]\nname = \"b\"\n" + block);
  CHECK(located(file, "name:3: known") == "name:3: known");
  CHECK(located(file, "something with 'b'") == "name:6: something with 'b'");
  CHECK(located(file, "something") == "name:2: something");
  CHECK(at_file(file, [] { return 3; }) == 3);
  CHECK(problem_message([&] {
          at_file(file, [&] { static_cast<void>(plan(file.scene)); });
        }).rfind("name:6: body 'b' ", 0) == 0);
  const SceneFile held = parsed(
      material + "[body]\n" + block + "fixed = \"left\"\n[[contact]]\nsource = \"bottom\"\n" +
      floor_below + "[[contact]]\nsource = \"left\"\n" +
      "target = { kind = \"half_plane\", point = [-1, 0], normal = [1, 0] }\n");
  CHECK(problem_message([&] {
          at_file(held, [&] { static_cast<void>(plan(held.scene)); });
        }).rfind("name:8: contact boundary 'left' ", 0) == 0);
}
