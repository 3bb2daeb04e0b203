// What must hold for any text that is read as an input file of CalculiX or Abaqus, however odd.
#pragma once
#include <set>
#include <string>
#include <string_view>

#include "addons/files/inp.hpp"
#include "fuzz/check_gmsh.hpp"

namespace signorini_test {

/// Reads a text as an input file.
/// \param content  any bytes
/// \return what is wrong, or empty; a crash or an exception of another kind is wrong as well
inline std::string check_inp(std::string_view content) {
  using namespace signorini;
  try {
    std::set<std::string> names;
    for (const Mesh& mesh : parse_inp(content, "name").meshes) {
      const std::string wrong = check_read(mesh);
      if (!wrong.empty()) return mesh.name + ": " + wrong;
      if (!names.insert(mesh.name).second) return mesh.name + ": two meshes of one name";
    }
    return names.empty() ? "no mesh" : "";
  } catch (const ProblemError& error) {
    const std::string message = error.what();
    return names_line(message) && message.size() < 500 ? "" : "message: " + message;
  }
}

}  // namespace signorini_test
