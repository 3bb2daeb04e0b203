#include "addons/files/other_kind.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

constexpr const char* mesh_it =
    "not yet a mesh: put its surfaces and curves into physical groups in Gmsh and mesh it "
    "there (gmsh FILE -2 -format msh41 -o NEW.msh)";
constexpr const char* through_gmsh =
    "Gmsh can read it: open it there, put surfaces and curves into "
    "physical groups and save it (without them: gmsh FILE -0 -format msh41 -o NEW.msh)";
constexpr const char* convert =
    "Gmsh does not read it: convert it to a Gmsh file of version 4.1 "
    "written as text, or mesh its geometry in Gmsh";

/// The beginning of a file in small letters, and where the words in it begin.
struct Head {
  explicit Head(std::string_view content) : bytes(content), text(content.substr(0, 8192)) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    text.erase(0, std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  }
  [[nodiscard]] bool begins(std::string_view word) const { return text.rfind(word, 0) == 0; }
  [[nodiscard]] bool holds(std::string_view word) const { return text.find(word) != text.npos; }
  /// Whether a line begins with a word.
  [[nodiscard]] bool has_line(std::string_view word) const {
    return begins(word) || holds('\n' + std::string(word));
  }
  /// Whether bytes are as many as a binary STL file says: 50 for each triangle after the first 84.
  [[nodiscard]] bool is_binary_stl() const {
    if (bytes.size() < 84) return false;
    std::uint64_t count = 0;
    for (std::size_t k = 4; k-- > 0;)
      count = 256 * count + static_cast<unsigned char>(bytes[80 + k]);
    return bytes.size() == 84 + 50 * count;
  }

  std::string_view bytes;
  std::string text;
};

/// One kind of file; the first row that fits is meant.
struct OtherKind {
  bool (*is)(const Head& head);
  const char* name;
  const char* way_out;
};

const OtherKind other_kinds[] = {
    {[](const Head& head) { return is_utf16(head.bytes); }, "a text in UTF-16",
     "save it as UTF-8, as iconv -f UTF-16 -t UTF-8 FILE > NEW does"},
    {[](const Head& head) { return head.begins("\x89hdf"); }, "an HDF5 file, as MED, CGNS and Exodus of today are",
     "of MED, tools/med2inp.py makes an input file with its groups, and of Exodus, meshio convert FILE NEW.inp one with "
     "its node sets, for kind = \"inp\""},
    {[](const Head& head) { return head.begins("cdf\x01") || head.begins("cdf\x02"); },
     "a netCDF file, as Exodus is",
     "meshio convert FILE NEW.inp makes an input file with its node sets, for kind = \"inp\""},
    {[](const Head& head) { return head.has_line("coor_2d") || head.has_line("titre"); },
     "a mesh of Code_Aster as text", convert},
    {[](const Head& head) {
       return head.has_line("begin nodes") || head.has_line("begin modelpart");
     },
     "a model part of Kratos", convert},
    {[](const Head& head) { return head.begins("\x1f\x8b") || head.begins("pk\x03\x04"); },
     "a compressed file", "unpack it first"},
    {[](const Head& head) { return head.begins("iso-10303-21"); }, "a STEP file", mesh_it},
    {[](const Head& head) { return head.holds("dbrep_drawableshape"); }, "a BREP file", mesh_it},
    {[](const Head& head) { return head.has_line("# vtk datafile"); }, "a VTK file", through_gmsh},
    {[](const Head& head) { return head.holds("<vtkfile"); }, "a VTK file in XML", convert},
    {[](const Head& head) { return head.begins("<?xml") || head.begins("<xdmf"); }, "an XML file",
     convert},
    {[](const Head& head) {
       return (head.begins("solid") && head.holds("facet")) || head.is_binary_stl();
     },
     "an STL file", through_gmsh},
    {[](const Head& head) { return head.has_line("meshversionformatted"); }, "an INRIA mesh file",
     through_gmsh},
    {[](const Head& head) { return head.begins("-1\n") || head.begins("-1\r"); }, "a UNV file",
     through_gmsh},
    {[](const Head& head) { return head.has_line("*keyword"); }, "an LS-DYNA file", convert},
    {[](const Head& head) {
       return head.has_line("*heading") || head.has_line("*node") || head.has_line("*part");
     },
     "an Abaqus or CalculiX input file", "in a scene take kind = \"inp\""},
    {[](const Head& head) {
       return head.has_line("begin bulk") || head.has_line("cend") || head.has_line("grid");
     },
     "a Nastran file", through_gmsh},
    {[](const Head& head) { return head.has_line("ndime="); }, "an SU2 file", convert},
    {[](const Head& head) { return head.begins("ply\n") || head.begins("off\n"); },
     "a PLY or OFF file", convert},
    {[](const Head& head) {
       return head.has_line("setfactory") || head.has_line("point(") || head.has_line("point (") ||
              head.has_line("rectangle(") || head.has_line("merge ");
     },
     "a .geo file, the input of Gmsh", mesh_it},
    {[](const Head& head) { return head.holds(std::string_view("\0", 1)); },
     "a binary file that no Gmsh wrote", "save the mesh in Gmsh, with Mesh.Binary = 0"},
};

}  // namespace

bool is_utf16(std::string_view content) {
  return content.substr(0, 2) == "\xff\xfe" || content.substr(0, 2) == "\xfe\xff";
}

std::string other_kind(std::string_view content) {
  const Head head(content);
  for (const OtherKind& kind : other_kinds)
    if (kind.is(head)) return text(kind.name, "; ", kind.way_out);
  return "";
}

}  // namespace signorini
