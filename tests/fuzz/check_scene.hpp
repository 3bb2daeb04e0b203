// What must hold for any text that is read as a scene file, however odd.
#pragma once
#include <string>
#include <string_view>

#include "addons/files/scene_file.hpp"
#include "signorini/core/errors.hpp"

namespace signorini_test {

/// Whether a text may ask for a large mesh: three digits in a row, or a number with an exponent or a base.
inline bool may_be_large(std::string_view content) {
  std::size_t digits = 0;
  for (const char c : content) {
    const bool digit = (c >= '0' && c <= '9') || c == '_';
    if (digits > 0 && std::string_view("eExob").find(c) != std::string_view::npos) return true;
    digits = digit ? digits + 1 : 0;
    if (digits > 2) return true;
  }
  return false;
}

/// Reads a text as a scene file and plans it.
/// \param content  any bytes
/// \return what is wrong, or empty; a crash or an exception of another kind is wrong as well
inline std::string check_scene(std::string_view content) {
  using namespace signorini;
  try {
    const SceneFile file = parse_scene(content, "name", "/nowhere");
    if (file.scene.bodies.empty()) return "a scene without bodies";
    if (file.scene.bodies.size() != file.body_lines.size()) return "lines of bodies";
    if (file.scene.contacts.size() != file.contact_lines.size()) return "lines of contacts";
    at_file(file, [&] { static_cast<void>(plan(file.scene)); });
    return "";
  } catch (const ProblemError& error) {
    const std::string message = error.what();
    const bool names_line = message.rfind("name:", 0) == 0 && message.find(": ", 5) != message.npos;
    return names_line && message.find('\n') == message.npos && message.size() < 2000
               ? ""
               : "message: " + message;
  }
}

}  // namespace signorini_test
