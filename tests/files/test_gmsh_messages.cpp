// What is said about Gmsh files that are cut off, of another kind, or contradict themselves.
#include <filesystem>

#include "addons/files/gmsh.hpp"
#include "catch_compat.hpp"
#include "fuzz/check_gmsh.hpp"
#include "support/folder.hpp"
#include "support/message.hpp"

using namespace signorini;
using signorini_test::content_of;
using signorini_test::problem_message;

namespace {

const std::string format = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string nodes =
    "$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 2 1 0\n5 1 1 0\n6 0 1 0\n$EndNodes\n";

std::string complaint(const std::string& content) {
  return problem_message([&] { static_cast<void>(parse_gmsh(content, "file")); });
}

/// What is said about two cells side by side and these elements, from line 14 on.
std::string about_elements(const std::string& count, const std::string& elements) {
  return complaint(format + nodes + "$Elements\n" + count + "\n" + elements + "$EndElements\n");
}

std::string with(std::string content, const std::string& what, const std::string& by) {
  REQUIRE(content.find(what) != content.npos);
  return content.replace(content.find(what), what.size(), by);
}

std::string v41() { return content_of(SIGNORINI_TEST_DATA "/gmsh/by_hand_q8_v41.msh"); }

const std::string cells = "1 3 2 1 1 1 2 5 6\n2 3 2 1 1 2 3 4 5\n";
const std::string again = "; the file is cut off or was changed: let Gmsh write it again";

}  // namespace

TEST_CASE("files of another kind are refused", "[mesh][gmsh]") {
  CHECK(complaint("") ==
        "file:1: expected a section '$MeshFormat', got the end of the file; save "
        "the mesh, with Mesh.SaveParametric = 0");
  CHECK(complaint("$NOD\n4\n") == "file:1: version 1 is not read; set Mesh.MshFileVersion = 4.1");
  CHECK(complaint("$MeshFormat\n4 0 8\n") ==
        "file:2: expected version 2.2 or 4.1, got 4; set Mesh.MshFileVersion = 4.1");
  CHECK(complaint("$MeshFormat\n4.1 1 8\n\1\0\0\0") ==
        "file:2: expected a file written as text, got a binary one; set Mesh.Binary = 0");
  CHECK(complaint(nodes) == "file:1: expected '$MeshFormat' as the first section, got '$Nodes'");
  CHECK(complaint(format + nodes) ==
        "file:12: expected a section '$Elements', got the end of the file; save the mesh, with "
        "Mesh.SaveParametric = 0");
  CHECK(complaint("$PartitionedEntities\n") ==
        "file:1: the mesh is divided for parallel computers; save it without partitions");
}

TEST_CASE("files of other programs are called by their names, with what to do", "[mesh][gmsh]") {
  std::string stl(84 + 50, ' ');
  stl.replace(80, 4, std::string("\1\0\0\0", 4));
  const std::string to_convert = "Gmsh does not read it: convert it";
  const std::string to_mesh = "not yet a mesh: put its surfaces and curves into physical groups";
  const std::string to_open = "Gmsh can read it: open it there";
  struct Given {
    std::string content, name, way_out;
  };
  const Given files[] = {
      {"solid a\nfacet normal 0 0 1\nouter loop\n", "an STL file", to_open},
      {stl, "an STL file", to_open},
      {"# vtk DataFile Version 2.0\nplate\nASCII\n", "a VTK file", to_open},
      {"<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\">\n", "a VTK file in XML",
       to_convert},
      {"<?xml version=\"1.0\"?>\n<mesh>\n", "an XML file", to_convert},
      {"** made by a program\n*Heading\n*NODE\n1, 0, 0\n", "an Abaqus or CalculiX input file",
       "take kind = \"inp\""},
      {"*KEYWORD\n*NODE\n", "an LS-DYNA file", to_convert},
      {"$ a remark\nGRID    1       0       0.0     0.0     0.0\n", "a Nastran file", to_open},
      {"SOL 101\nCEND\nBEGIN BULK\n", "a Nastran file", to_open},
      {"\x89HDF\r\n\x1a\n and more", "an HDF5 file, as MED, CGNS and Exodus of today are",
       "tools/med2inp.py makes an input file with its groups, and of Exodus, meshio convert FILE NEW.inp"},
      {"CDF\x01 and more", "a netCDF file, as Exodus is", "meshio convert FILE NEW.inp"},
      {"TITRE\nplate\nFINSF\nCOOR_2D\n", "a mesh of Code_Aster as text", to_convert},
      {"Begin Properties 0\nEnd Properties\nBegin Nodes\n", "a model part of Kratos", to_convert},
      {"ISO-10303-21;\nHEADER;\n", "a STEP file", to_mesh},
      {"DBRep_DrawableShape\n\nCASCADE Topology V3\n", "a BREP file", to_mesh},
      {" MeshVersionFormatted 2\n Dimension\n 3\n", "an INRIA mesh file", to_open},
      {"    -1\n  2411\n", "a UNV file", to_open},
      {"NDIME= 2\nNELEM= 1\n", "an SU2 file", to_convert},
      {"// a plate\nSetFactory(\"OpenCASCADE\");\n", "a .geo file, the input of Gmsh", to_mesh},
      {"lc = 0.1;\nPoint(1) = {0, 0, 0, lc};\n", "a .geo file, the input of Gmsh", to_mesh},
      {"\x1f\x8b\x08", "a compressed file", "unpack it first"},
      {std::string("\1\0\2", 3), "a binary file that no Gmsh wrote", "Mesh.Binary = 0"}};
  for (const Given& file : files) {
    CAPTURE(file.content);
    CHECK_THAT(complaint(file.content), StartsWith("file:1: this is " + file.name + "; ") &&
                                            ContainsSubstring(file.way_out));
  }
}

TEST_CASE("elements that are not read say what to set in Gmsh", "[mesh][gmsh]") {
  CHECK_THAT(about_elements("1", "1 10 2 1 1 1 2 3 4 5 6 7 8 9\n"),
             StartsWith("file:15: quadrilaterals of 9 nodes") &&
                 ContainsSubstring("Mesh.SecondOrderIncomplete = 1"));
  CHECK_THAT(about_elements("1", "1 21 2 1 1 1 2 3 4 5 6 1 2 3 4\n"),  // triangles of 10 nodes
             StartsWith("file:15: expected points, lines, triangles and quadrilaterals") &&
                 ContainsSubstring("type 21; set Mesh.ElementOrder to 1 or 2"));
  CHECK_THAT(about_elements("1", "1 5 0 1 2 3 4 5 6 7 8\n"),
             StartsWith("file:15: solids (type 5)") && ContainsSubstring("gmsh -2"));
  CHECK_THAT(about_elements("1", "1 26 0 1 2 3 4\n"),
             StartsWith("file:15: expected points, lines, triangles and quadrilaterals") &&
                 ContainsSubstring("type 26; set Mesh.ElementOrder to 1 or 2"));
  CHECK_THAT(about_elements("1", "1 1 2 1 1 1 2\n"),
             ContainsSubstring("no triangles or quadrilaterals"));
}

TEST_CASE("counts that do not fit are refused, and nothing is allocated for them", "[mesh][gmsh]") {
  CHECK(about_elements("3", cells) == "file:17: expected 3 elements, got 2" + again);
  CHECK(about_elements("1", cells) ==
        "file:16: expected '$EndElements' after what was announced, got '2'");
  CHECK(about_elements("9000000000000000000", cells) ==
        "file:17: expected 9000000000000000000 elements, got 2" + again);
  CHECK_THAT(about_elements("-1", cells), StartsWith("file:14: number of elements: expected a "));
  CHECK_THAT(about_elements("99999999999999999999", cells), ContainsSubstring("whole number"));
  CHECK(about_elements("1", "1 3 2 1 1 1 2 5\n") ==
        "file:15: node tag: expected a whole number from 1 to 9223372036854775807, got the end of "
        "the line");
  CHECK(about_elements("1", "1 3 2 1 1 1 2 5 6 7\n") ==
        "file:15: expected the end of the line after the nodes of the element, got '7'");
  CHECK(about_elements("1", "1 3 9000000000000000000 1 1 1 2 5 6\n") ==
        "file:15: tag: expected a whole number from -2147483647 to 2147483647, got the end of the "
        "line");
  CHECK(complaint(with(v41(), "1 9 11 20", "1 10 11 20")) ==
        "file:30: expected 10 nodes in all blocks, got 9" + again);
  CHECK(complaint(with(v41(), "2 1 1 9", "2 1 1 8")) ==
        "file:21: y: expected a finite number, got the end of the line");
  CHECK(complaint(with(v41(), "2 1 1 9", "2 1 0 9")) ==
        "file:22: expected the end of the line after the position of a node, got '0'");
  std::string many = "1 0 0 0 1 0 0 100";
  for (int group = 1; group <= 100; ++group) many += text(' ', group);
  CHECK(complaint(with(v41(), "1 0 0 0 1 0 0 1 -4", many)) ==
        "file:6: expected an entity in at most 16 physical groups");
  CHECK(complaint(with(v41(), "0 2 1 0", "0 2 2 0")) ==
        "file:9: expected 2 surfaces, got 1" + again);
}

TEST_CASE("the message about a file that is cut off names its last line", "[mesh][gmsh]") {
  const std::string whole =
      GENERATE(std::string(SIGNORINI_TEST_DATA "/gmsh/two_bodies_q4_v41.msh"),
               std::string(SIGNORINI_TEST_DATA "/gmsh/mixed_quadratic_v22.msh"),
               std::string(SIGNORINI_TEST_DATA "/gmsh/by_hand_v22.msh"));
  const std::string content = content_of(whole);
  const std::size_t needed = content.rfind("$EndElements") + 12;
  for (std::size_t length = 0; length < needed; ++length) {
    const std::string said = complaint(content.substr(0, length));
    CAPTURE(length, said);
    REQUIRE(said.rfind("file:", 0) == 0);
  }
}

TEST_CASE("nodes and entities that contradict themselves are named", "[mesh][gmsh]") {
  CHECK(about_elements("1", "1 3 2 1 1 1 2 5 7\n") ==
        "file:15: the element refers to node 7, which '$Nodes' does not have" + again);
  CHECK(
      complaint(with(format + nodes, "\n6 0 1 0", "\n5 0 1 0") + "$Elements\n0\n$EndElements\n") ==
      "file:11: node 5 stands here and in line 10; give each its own tag");
  CHECK_THAT(complaint(with(v41(), "1 2 8 2", "1 7 8 2")),
             ContainsSubstring("entity 7 of dimension 1 is not in '$Entities'"));
  CHECK_THAT(complaint(with(v41(), "1 2 8 2", "2 1 8 2")),
             ContainsSubstring("elements of type 8 cannot be of dimension 2"));
  CHECK_THAT(complaint(format + nodes + nodes), ContainsSubstring("'$Nodes' comes twice"));
  CHECK_THAT(complaint(format + "$Unknown\n$EndOther\n"), ContainsSubstring("'$EndUnknown'"));
}

TEST_CASE("a mesh out of the plane is refused", "[mesh][gmsh]") {
  const std::string elements = "$Elements\n2\n" + cells + "$EndElements\n";
  CHECK(complaint(with(format + nodes, "4 2 1 0", "4 2 1 0.1") + elements) ==
        "file:9: expected z = 0 as of other nodes, got z = 0.1; turn the body into the plane of x "
        "and y");
  // What Gmsh rounds away is a billionth of the extent at most, here 2e-9.
  CHECK(complaint(with(format + nodes, "4 2 1 0", "4 2 1 1.9e-9") + elements).empty());
  CHECK_FALSE(complaint(with(format + nodes, "4 2 1 0", "4 2 1 2.1e-9") + elements).empty());
}

TEST_CASE("cells and lines of no body, or of two, are refused", "[mesh][gmsh]") {
  CHECK_THAT(about_elements("2", "1 3 2 1 1 1 2 5 6\n2 3 2 0 1 2 3 4 5\n"),
             StartsWith("file:16: this cell is in no physical surface"));
  CHECK_THAT(about_elements("2", "1 3 2 1 1 1 2 5 6\n2 3 2 9 1 1 2 5 6\n"),
             StartsWith("file:16: this cell and that of line 15 lie on the same side"));
  CHECK_THAT(about_elements("3", cells + "3 1 2 4 1 1 5\n"),
             StartsWith("file:17: this line of 'curve 4' is no side of a cell"));
  CHECK_THAT(about_elements("3", cells + "3 1 2 4 1 2 5\n"),
             StartsWith("file:17: this line of 'curve 4' lies within a body"));
  CHECK_THAT(about_elements("3", cells + "3 8 2 4 1 1 2 3\n"),
             ContainsSubstring("has 3 nodes, and the side of the cell there has 2"));
  CHECK(about_elements("3", cells + "3 1 2 0 1 2 5\n").empty());                 // in no group
  CHECK(about_elements("4", cells + "3 1 2 4 1 1 2\n4 1 2 4 1 2 1\n").empty());  // twice
}

TEST_CASE("cells of 8 nodes fit to their neighbours, and are not mixed with those of 4",
          "[mesh][gmsh]") {
  const std::string more = with(with(format + nodes, "$Nodes\n6", "$Nodes\n14"), "$EndNodes",
                                "7 .5 0 0\n8 1 .5 0\n9 .5 1 0\n10 0 .5 0\n11 1.5 0 0\n12 2 .5 0\n"
                                "13 1.5 1 0\n14 1 .5 0\n$EndNodes");
  const auto second = [&](const std::string& cell) {
    return complaint(more + "$Elements\n2\n1 16 2 1 1 1 2 5 6 7 8 9 10\n" + cell +
                     "\n$EndElements\n");
  };
  CHECK(second("2 16 2 1 1 2 3 4 5 11 12 13 8").empty());
  CHECK(second("2 16 2 7 1 2 3 4 5 11 12 13 14").empty());  // another body
  CHECK_THAT(second("2 16 2 1 1 2 3 4 5 11 12 13 14"),
             StartsWith("file:24: this cell and that of line 23 share the ends of a side but not"));
  CHECK_THAT(second("2 3 2 1 1 2 3 4 5"),
             StartsWith("file:24: expected a cell of 3 nodes per side as in line 23, got 2"));
}

TEST_CASE("names that two bear are refused, and names of nothing if no element is in a group",
          "[mesh][gmsh]") {
  const auto named = [&](const std::string& names, const std::string& elements) {
    return complaint(format + "$PhysicalNames\n2\n" + names + "$EndPhysicalNames\n" + nodes +
                     "$Elements\n2\n" + elements + "$EndElements\n");
  };
  const std::string two = "1 3 2 1 1 1 2 5 6\n2 3 2 2 1 2 3 4 5\n";
  CHECK(named("2 1 \"a\"\n2 2 \"b\"\n", two).empty());
  CHECK_THAT(named("2 1 \"a\"\n2 2 \"a\"\n", two), ContainsSubstring("two physical surfaces are"));
  CHECK(named("2 1 \"a\"\n1 3 \"rim\"\n", two).empty());
  CHECK_THAT(
      named("2 1 \"a\"\n1 3 \"rim\"\n", "1 3 2 0 1 1 2 5 6\n2 3 2 0 1 2 3 4 5\n"),
      StartsWith("file:1: nothing in the file is in a physical group, not in the curve 'rim'"));
  CHECK_THAT(named("2 1 \"a\"\n2 1 \"b\"\n", two), StartsWith("file:7: physical group 1"));
  CHECK_THAT(named("2 1 a\n", two), StartsWith("file:6: expected a name in quotation marks"));
}

TEST_CASE("texts of the fuzzer are read or refused", "[mesh][gmsh]") {
  std::size_t count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(SIGNORINI_TEST_DATA "/fuzz_corpus_gmsh")) {
    CAPTURE(entry.path().filename().string());
    CHECK(signorini_test::check_gmsh(content_of(entry.path())).empty());
    ++count;
  }
  CHECK(count > 0);
}
