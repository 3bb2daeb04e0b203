// Input files of CalculiX and Abaqus: the same mesh written and read back, sets, surfaces, and what is refused or named.
#include <sstream>

#include "addons/files/gmsh.hpp"
#include "addons/files/inp.hpp"
#include "addons/files/scene_file.hpp"
#include "catch_compat.hpp"
#include "fuzz/check_inp.hpp"
#include "meshes/split.hpp"
#include "meshes/block.hpp"
#include "support/folder.hpp"
#include "support/message.hpp"

using namespace signorini;
using Eigen::Index;
using signorini_test::check_inp;
using signorini_test::content_of;
using signorini_test::problem_message;

namespace {

using Names = std::vector<std::string>;

std::string file(const std::string& name) {
  return std::string(SIGNORINI_TEST_DATA "/inp/") + name + ".inp";
}

/// How a boundary of a mesh is written.
enum class As { Surface, Lines, Nodes };

/// Nodes of a side between commas, ends first.
std::string numbers(const Mesh& mesh, const CellSide& side) {
  const std::vector<Index> nodes = mesh.side_nodes(side);
  std::string all = text(nodes.front() + 1, ", ", nodes.back() + 1);
  if (nodes.size() == 3) all += text(", ", nodes[1] + 1);
  return all;
}

/// A mesh as an input file.
std::string written(const Mesh& mesh, As boundaries) {
  std::ostringstream out;
  out.precision(17);
  out << "*NODE\n";
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    out << node + 1 << ", " << mesh.nodes(node, 0) << ", " << mesh.nodes(node, 1) << '\n';
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    out << "*ELEMENT, TYPE=CPE" << mesh.cell_size(cell) << ", ELSET=" << mesh.name << '\n'
        << cell + 1;
    for (Index k = 0; k < mesh.cell_size(cell); ++k) out << ", " << mesh.cells(cell, k) + 1;
    out << '\n';
  }
  Index line = mesh.n_cells();
  for (const auto& [name, sides] : mesh.boundaries) {
    if (boundaries == As::Surface) out << "*SURFACE, TYPE=ELEMENT, NAME=" << name << '\n';
    if (boundaries == As::Lines)
      out << "*ELEMENT, TYPE=" << (mesh.order() == MeshOrder::Linear ? "T3D2" : "T3D3")
          << ", ELSET=" << name << '\n';
    if (boundaries == As::Nodes) out << "*NSET, NSET=" << name << '\n';
    for (const CellSide& side : sides) {
      if (boundaries == As::Surface) out << side.cell + 1 << ", S" << side.side + 1 << '\n';
      if (boundaries == As::Lines) out << ++line << ", " << numbers(mesh, side) << '\n';
      if (boundaries == As::Nodes) out << numbers(mesh, side) << '\n';
    }
  }
  return out.str();
}

void check_same(const Mesh& read, const Mesh& wanted) {
  CHECK(read.name == wanted.name);
  CHECK(read.nodes == wanted.nodes);
  CHECK(read.cells == wanted.cells);
  REQUIRE(read.boundaries.size() == wanted.boundaries.size());
  for (const auto& [name, sides] : wanted.boundaries) {
    CAPTURE(name);
    CHECK(boundary_nodes(read, name) == boundary_nodes(wanted, name));
  }
}

std::string complaint(const std::string& content, const Names& sets = {}) {
  return problem_message([&] { static_cast<void>(parse_inp(content, "file", sets)); });
}

const std::string square =
    "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n5,2,0\n6,2,1\n*ELEMENT,TYPE=CPS4,ELSET=a\n1,1,2,3,4\n";

}  // namespace

TEST_CASE("a mesh that is written as an input file is read as it was", "[mesh][inp]") {
  const As boundaries = GENERATE(As::Surface, As::Lines, As::Nodes);
  const MeshOrder order = GENERATE(MeshOrder::Linear, MeshOrder::Quadratic);
  const std::string cut = GENERATE("nothing", "some", "all");
  CAPTURE(boundaries, order, cut);
  BlockSpec spec;
  spec.size = {3, 2};
  spec.cells_x = 4;
  spec.cells_y = 3;
  spec.order = order;
  Mesh mesh = make_block(spec);
  if (cut == "some") mesh = split(mesh, {1, 6, 7});
  if (cut == "all") mesh = split(mesh);
  const InpMeshes read = parse_inp(written(mesh, boundaries), "file");
  REQUIRE(read.meshes.size() == 1);
  check_same(read.meshes.front(), mesh);
  CHECK(read.unread.empty());
  CHECK(read.further_sets.empty());
}

TEST_CASE("bodies of Gmsh are the same bodies as input files", "[mesh][inp]") {
  const std::string name =
      GENERATE("two_bodies_q4_v41", "two_bodies_q8_v22", "mixed_quadratic_v41");
  for (const Mesh& mesh : read_gmsh(std::string(SIGNORINI_TEST_DATA "/gmsh/") + name + ".msh")) {
    CAPTURE(name, mesh.name);
    check_same(parse_inp(written(mesh, As::Surface), "file").meshes.at(0), mesh);
    check_same(parse_inp(written(mesh, As::Lines), "file").meshes.at(0), mesh);
  }
}

TEST_CASE(
    "sets with sections are bodies, small and capital letters are the same, and what is not read "
    "is named",
    "[mesh][inp]") {
  const InpMeshes read = read_inp(file("two_blocks"));
  REQUIRE(read.meshes.size() == 2);
  const Mesh& lower = mesh_named(read.meshes, "Lower");
  const Mesh& upper = mesh_named(read.meshes, "Upper");
  CHECK(lower.n_cells() == 2);
  CHECK(upper.n_cells() == 4);
  for (const Mesh* mesh : {&lower, &upper}) CHECK_NOTHROW(check_mesh(*mesh));
  CHECK(boundary_nodes(lower, "foot").size() == 3);
  CHECK(lower.boundaries.count("top") == 0);
  CHECK(boundary(upper, "top").size() == 2);
  // Both bodies have their own nodes where they meet, and the surface of one is a boundary of both.
  CHECK(boundary(lower, "inner").size() == 2);
  CHECK(boundary(upper, "inner").size() == 2);
  CHECK(boundary(lower, "ALL").size() == 6);
  CHECK(read.further_sets == Names{"both (6 cells)"});
  CHECK(read.unread == Names{"*BOUNDARY (line 37)", "*CLOAD (line 41)", "*ELASTIC (line 33)",
                             "*END STEP (line 43)", "*MATERIAL (line 32)", "*STATIC (line 40)",
                             "*STEP (line 39)"});
}

TEST_CASE("one set is one body, several are one with regions", "[mesh][inp]") {
  const InpMeshes one = read_inp(file("two_blocks"), {"UPPER"});
  REQUIRE(one.meshes.size() == 1);
  CHECK(one.meshes[0].n_cells() == 4);
  const Mesh whole = read_inp(file("two_blocks"), {"both"}).meshes.at(0);
  CHECK(whole.n_cells() == 6);
  CHECK(whole.n_nodes() == 9);
  CHECK(whole.regions.empty());
  CHECK(whole.boundaries.count("inner") == 0);
  const InpMeshes parts = read_inp(file("two_blocks"), {"Lower", "Upper"});
  REQUIRE(parts.meshes.size() == 1);
  CHECK(parts.meshes[0].n_nodes() == 9);
  CHECK(parts.meshes[0].regions.at("Lower").size() == 2);
  CHECK(parts.meshes[0].regions.at("Upper").size() == 4);
  CHECK(parts.unread.back() == "sides within a body of surface 'inner' (line 30)");
}

TEST_CASE("elements of three nodes per side, lines that go on, and middle nodes in either place",
          "[mesh][inp]") {
  const InpMeshes read = read_inp(file("by_hand_cpe8"));
  const Mesh& plate = read.meshes.at(0);
  CHECK_NOTHROW(check_mesh(plate));
  CHECK(plate.n_cells() == 3);
  CHECK(plate.n_nodes() == 14);
  CHECK(plate.corners(0) == 4);
  CHECK(plate.corners(1) == 3);
  const auto xs = [&](const char* name) {
    std::vector<double> all;
    for (const Index node : boundary_nodes(plate, name)) all.push_back(plate.nodes(node, 0));
    return all;
  };
  CHECK(xs("foot") == std::vector<double>{0, 1, 2, 3, 4});
  CHECK(xs("Top side") == std::vector<double>{4, 3, 2, 1, 0});
  CHECK(plate.boundaries.count("corners") == 0);  // no side has all its nodes there
  CHECK(read.further_sets == Names{"triangles (2 cells)"});
}

TEST_CASE("a surface that names a set alone has the sides of it on the border", "[mesh][inp]") {
  const Mesh mesh =
      parse_inp(square + "2,2,5,6,3\n*ELSET,ELSET=right\n2\n*SURFACE,NAME=rim\nright,\n", "file")
          .meshes.at(0);
  CHECK(boundary(mesh, "rim").size() == 3);
}

TEST_CASE("the faces of a shell come before its sides, and edges are counted alone", "[mesh][inp]") {
  const auto nodes = [](const std::string& type, const std::string& label) {
    const std::string content = "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n*ELEMENT,TYPE=" + type +
                                "\n1,1,2,3,4\n*SURFACE,NAME=s\n1," + label + "\n";
    return boundary_nodes(parse_inp(content, "file").meshes.at(0), "s");
  };
  for (int side = 1; side <= 4; ++side) {
    const std::vector<Index> wanted = {side - 1, side % 4};
    for (const char* type : {"S4R", "M3D4", "CPS4"})
      CHECK(nodes(type, text('E', side)) == wanted);
    CHECK(nodes("S4", text('S', side + 2)) == wanted);
    CHECK(nodes("M3D4", text('S', side + 2)) == wanted);
    CHECK(nodes("CPE4R", text('s', side)) == wanted);
  }
  CHECK(problem_message([&] { static_cast<void>(nodes("S4", "S2")); }) ==
        "file:8: surface 's': the element of line 7 has no side S2; of a shell, S1 and S2 are its "
        "faces");
}

TEST_CASE("a surface of nodes may say how large they are", "[mesh][inp]") {
  const auto foot = [](const std::string& lines) {
    return boundary_nodes(
        parse_inp(square + "*NSET,NSET=low\n1,2\n*SURFACE,TYPE=NODE,NAME=foot\n" + lines, "file")
            .meshes.at(0),
        "foot");
  };
  CHECK(foot("low,1.\n") == std::vector<Index>{0, 1});
  CHECK(foot("1,0.5\n2,0.5\n") == std::vector<Index>{0, 1});
}

TEST_CASE("a long head of comments does not hide what a file is", "[mesh][inp]") {
  std::string head;
  for (int line = 0; line < 5000; ++line) head += "** a line of some length\n";
  CHECK(is_inp(head + square));
  CHECK_FALSE(is_inp(head));
}

TEST_CASE("a part and the assembly have sets of one name, as CAE makes them", "[mesh][inp]") {
  // Both call their first set Set-1: all nodes and elements of the part, and the lower side of the assembly.
  const std::string cae =
      "*PART, NAME=Part-1\n*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n*ELEMENT,TYPE=CPS4\n1,1,2,3,4\n"
      "*NSET, NSET=Set-1, GENERATE\n1,4,1\n*NSET,NSET=both\nSet-1\n*ELSET, ELSET=Set-1\n1\n"
      "*SOLID SECTION, ELSET=Set-1\n,\n*END PART\n*ASSEMBLY, NAME=Assembly\n"
      "*INSTANCE, NAME=Part-1-1, PART=Part-1\n*END INSTANCE\n"
      "*NSET, NSET=Set-1, INSTANCE=Part-1-1\n1, 2\n*NSET,NSET=low\nSet-1\n"
      "*ELSET, ELSET=set-1, INSTANCE=Part-1-1\n1\n*SURFACE, NAME=Surf-1\nset-1, S1\n*END "
      "ASSEMBLY\n";
  const InpMeshes read = parse_inp(cae, "file");
  REQUIRE(read.meshes.size() == 1);
  const Mesh& mesh = read.meshes[0];
  CHECK(mesh.name == "Set-1");
  CHECK(boundary_nodes(mesh, "Set-1") == std::vector<Index>{0, 1});
  CHECK(boundary_nodes(mesh, "low") == std::vector<Index>{0, 1});
  CHECK(boundary(mesh, "Part-1.Set-1").size() == 4);
  CHECK(boundary(mesh, "both").size() == 4);
  CHECK(boundary_nodes(mesh, "Surf-1") == std::vector<Index>{0, 1});
  CHECK(read.further_sets == Names{"Assembly.set-1 (1 cell)", "block 1 (1 cell)"});
  CHECK(
      read.notes ==
      Names{"two node sets are called 'Set-1', one of the part and one of the assembly (lines 9 "
            "and 21): here 'Set-1' is that of the assembly, and the other one is 'Part-1.Set-1'",
            "two element sets are called 'set-1', one of the part and one of the assembly (lines "
            "13 and 25): here 'set-1' is that of the part, and the other one is 'Assembly.set-1'"});
  // What has named the set that gives its name away goes on naming it.
  const InpMeshes later = parse_inp(
      "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n5,2,0\n6,2,1\n*ELEMENT,TYPE=CPS4\n1,1,2,3,4\n"
      "2,2,5,6,3\n*ELSET,ELSET=s\n1\n*SURFACE,NAME=foot\ns,S1\n"
      "*ELSET,ELSET=more\ns\n*SOLID SECTION,ELSET=s\n0.5,\n*PART,NAME=P\n"
      "*ELSET,ELSET=s\n2\n*END PART\n",
      "file");
  CHECK(boundary_nodes(later.meshes.at(0), "foot") == std::vector<Index>{0, 1});
  CHECK(later.meshes.at(0).n_cells() == 1);  // the section is that of the first element
  CHECK_THAT(later.notes.back(), ContainsSubstring("section of 'Assembly.s' has the thickness 0.5"));
  // Where a set goes on at its place, it is one.
  const InpMeshes on = parse_inp(square + "*NSET,NSET=a\n1\n*NSET,NSET=A\n2\n", "file");
  CHECK(boundary_nodes(on.meshes[0], "a") == std::vector<Index>{0, 1});
  CHECK(on.notes.empty());
}

TEST_CASE("a surface of nodes and a node set of one name are two", "[mesh][inp]") {
  const InpMeshes read = parse_inp(
      square + "*NSET,NSET=foo\n1,2\n*NSET,NSET=up\n3,4\n*SURFACE,TYPE=NODE,NAME=foo\nup,1.\n",
      "file");
  CHECK(boundary_nodes(read.meshes[0], "foo") == std::vector<Index>{2, 3});
  CHECK(read.notes ==
        Names{"the node set 'foo' (line 10) is no boundary, as the surface of line 14 "
              "has this name: rename one of them"});
}

TEST_CASE("a thickness of a section is not taken, and a note says what to write", "[mesh][inp]") {
  const auto notes = [](const std::string& section) {
    return parse_inp(square + section, "file").notes;
  };
  const Names wanted = {
      "the section of 'a' has the thickness 0.5 (line 11), which is not taken: give "
      "the material of the body thickness = 0.5"};
  CHECK(notes("*SOLID SECTION, ELSET=a, MATERIAL=m\n0.5,\n") == wanted);
  CHECK(notes("*SHELL SECTION, ELSET=A\n0.5, 5\n") == wanted);
  CHECK(notes("*SOLID SECTION, ELSET=a\n1.,\n").empty());
  CHECK(notes("*SOLID SECTION, ELSET=a\n,\n").empty());
  CHECK(notes("*SOLID SECTION, ELSET=a\n").empty());
  CHECK(notes("*ELSET,ELSET=none\n*SOLID SECTION, ELSET=a\n*SOLID SECTION, ELSET=none\n0.5,\n")
            .empty());
}

TEST_CASE(
    "names of an input file end no line and control no terminal, and a comment ends no keyword",
    "[mesh][inp]") {
  CHECK(complaint(square + "*NSET, NSET=a\x1b[2J\n1\n") ==
        "file:10: expected a name without control characters, got 'a?[2J'");
  CHECK_THAT(complaint(square + "*ODD\x1b[2J\n1\n"),
             StartsWith("file:10: expected a keyword behind '*', got '*ODD?[2J'"));
  const Mesh mesh =
      parse_inp("*NODE,\n** of all\nNSET=all\n1,0,0\n2,1,0\n3,0,1\n*ELEMENT, TYPE=CPS3\n1,1,2,3\n",
                "file")
          .meshes.at(0);
  CHECK(boundary(mesh, "all").size() == 3);
}

TEST_CASE("an input file in UTF-16 is called by its name", "[mesh][inp]") {
  for (const std::string mark : {"\xff\xfe", "\xfe\xff"})
    CHECK(complaint(mark + std::string("*\0N\0", 4)) ==
          "file:1: this is a text in UTF-16; save it as UTF-8, as iconv -f UTF-16 -t UTF-8 FILE > "
          "NEW "
          "does");
}

TEST_CASE("what would change the mesh and is not read is refused by name", "[mesh][inp]") {
  CHECK(complaint("*INCLUDE, INPUT=a.inp\n") ==
        "file:1: *INCLUDE is not read: put that file in the place of this line");
  CHECK_THAT(complaint(square + "*NGEN\n1, 2\n"),
             StartsWith("file:10: *NGEN is not read: write all"));
  CHECK_THAT(complaint("*NODE, INPUT=nodes.txt\n"), StartsWith("file:1: INPUT= is not read"));
  CHECK_THAT(complaint("*NODE, SYSTEM=C\n"), StartsWith("file:1: SYSTEM= is not read"));
  CHECK(complaint("*NODE, SYSTEM=R\n" + square).find("SYSTEM") == std::string::npos);
  CHECK_THAT(complaint("*PART, NAME=a\n*END PART\n*PART, NAME=b\n"),
             StartsWith("file:3: several parts are not read"));
  CHECK_THAT(complaint("*INSTANCE, NAME=a, PART=b\n1, 0, 0\n"),
             StartsWith("file:2: instances that are moved"));
  CHECK(complaint("*NODE\n1,0,0\n*ELEMENT,TYPE=C3D8\n1,1,1,1,1,1,1,1,1\n") ==
        "file:1: the file has no plane elements, such as CPS4, CPE8 or CAX6; not read is, for "
        "example, "
        "elements of type C3D8 (line 4)");
}

TEST_CASE("lines that are wrong are named", "[mesh][inp]") {
  CHECK(complaint("*NODE\n1, 2\n") == "file:2: expected number, x and y of a node");
  CHECK(complaint("*NODE\n1, 2, x\n") == "file:2: coordinate: expected a finite number, got 'x'");
  CHECK_THAT(complaint("*NODE\n0, 2, 1\n"), StartsWith("file:2: node number: expected a whole"));
  CHECK(complaint("*ELEMENT\n") == "file:1: *ELEMENT: expected a parameter TYPE=NAME");
  CHECK(complaint("*ELEMENT, TYPE=CPS4\n1,1,2,3\n*NODE\n") ==
        "file:3: the element of line 2 has 3 nodes, and CPS4 has 4");
  CHECK(complaint("*ELEMENT, TYPE=CPS4\n1,1,2,3,4,5\n") ==
        "file:2: expected 4 nodes of an element CPS4, got 5");
  CHECK(complaint(square + "1,1,2,3,4\n") ==
        "file:10: element 1 stands here and in line 9; give each its own number");
  CHECK(complaint("*NODE\n1,9,9\n" + square) ==
        "file:4: node 1 stands here and in line 2; give each its own number");
  CHECK(complaint(square + "2,2,5,7,3\n") ==
        "file:10: the element refers to node 7, which no *NODE has");
  CHECK(complaint(square + "*SURFACE,NAME=s\n1,S5\n") ==
        "file:10: surface 's': the element of line 9 has no side S5");
  CHECK(complaint(square + "*SURFACE,NAME=s\n1,S7\n") ==
        "file:11: expected a side S1 to S6 or an edge E1 to E4, got 'S7'");
  CHECK(complaint(square + "*ELEMENT,TYPE=CPS3,ELSET=b\n2,2,5,3\n*SURFACE,NAME=s\n2,S4\n") ==
        "file:12: surface 's': the element of line 11 has no side S4");
  CHECK(complaint(square + "*ELSET,ELSET=b\nnone\n") ==
        "file:11: expected a set of elements that is defined above, got 'none'");
  CHECK(complaint(square + "*ELSET,ELSET=b,GENERATE\n1\n") ==
        "file:11: expected first, last and step of GENERATE");
  CHECK(complaint(square, {"c"}) == "file:1: there is no element set 'c'; there are: a");
  CHECK_THAT(
      complaint(square + "*SOLID SECTION,ELSET=a\n*ELSET,ELSET=b\na\n*SOLID SECTION,ELSET=b\n"),
      StartsWith("file:9: this element is in two bodies"));
}

TEST_CASE("a scene takes a body of an input file, and notes what of it is not read",
          "[scene_file][inp]") {
  const std::string body =
      "[[body]]\nname = \"b\"\nmaterial = { youngs_modulus = 1, poisson_ratio = 0.3 }\n"
      "fixed = \"foot\"\nmesh = { kind = \"inp\", file = \"two_blocks.inp\"";
  const auto read = [&](const std::string& rest) {
    return parse_scene(body + rest, "scene", std::string(SIGNORINI_TEST_DATA "/inp"));
  };
  const SceneFile scene = read(", set = \"Lower\" }\n");
  CHECK(scene.scene.bodies[0].mesh.name == "b");
  CHECK(scene.scene.bodies[0].mesh.n_cells() == 2);
  REQUIRE(scene.notes.size() == 1);
  CHECK_THAT(scene.notes[0],
             StartsWith("two_blocks.inp: read are nodes, plane elements, sets and "
                        "surfaces, and not: *BOUNDARY (line 37), *CLOAD (line 41)"));
  CHECK_THAT(
      problem_message([&] { static_cast<void>(read(" }\n")); }),
      ContainsSubstring("the file has 2 bodies: say which one with set = \"NAME\"; there are: "
                        "Lower, Upper"));
  CHECK_THAT(problem_message([&] { static_cast<void>(read(", set = [] }\n")); }),
             ContainsSubstring("expected the name of an element set, got none"));
}

TEST_CASE("any part of an input file is read or refused with its line", "[mesh][inp]") {
  const std::string name = GENERATE("two_blocks", "by_hand_cpe8");
  const std::string content = content_of(file(name));
  for (std::size_t end = 0; end < content.size(); end += 3) {
    CAPTURE(name, end);
    CHECK(check_inp(content.substr(0, end)).empty());
    CHECK(check_inp(content.substr(end)).empty());
    std::string changed = content;
    changed[end] = changed[end] == ',' ? '\n' : ',';
    CHECK(check_inp(changed).empty());
  }
}
