/// \file
/// Scenes from files: TOML texts of bodies, contacts and what is written out.
#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "addons/along/probe.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini {

/// What a scene file asks to be written; an empty name asks for nothing.
struct Output {
  std::string vtu;     ///< meshes and fields, for ParaView
  std::string csv;     ///< the pressure table
  std::string plot;    ///< a picture of pressure and deformed meshes
  std::string state;   ///< of the last load step
  std::string probes;  ///< the table of what probes read
  bool ascii = false;  ///< whether numbers of VTU files are text, see VtuNumbers
};

/// A scene as a file tells it.
struct SceneFile {
  Scene scene;                             ///< what is to be solved
  Output output;                           ///< what is to be written
  std::vector<Probe> probes;               ///< where the solution is to be read, none by default
  std::string title;                       ///< one line for people, or empty
  std::string name;                        ///< of the file, for messages
  std::vector<std::size_t> body_lines;     ///< where each body begins, from 1
  std::vector<std::size_t> contact_lines;  ///< where each contact begins, from 1
  std::vector<std::size_t> tie_lines = {};  ///< where each tie of the bonds begins, from 1
  /// What a user should know of how the file was understood, each with its line: for the notes of a plan.
  std::vector<std::string> notes = {};
  std::vector<std::filesystem::path> files = {};  ///< that the text names and that were read
};

/// What the name of a picture may end with.
inline constexpr std::array picture_endings = {".svg", ".png", ".pdf"};

/// Makes a scene of a TOML text. examples/README.md lists the keys, see key_reference().
/// \param content  the text
/// \param name     of the file, for messages
/// \param folder   in which the files of meshes are looked for
/// \return the scene; plan() finds what is wrong with bodies and contacts as a whole
/// \throws ProblemError `NAME:LINE: ...` if the text is no TOML; has a key that is unknown, without meaning where
///   it stands, missing or of a wrong type; names a boundary, body, element, operator or solver that does not
///   exist; or describes a mesh that cannot be made
[[nodiscard]] SceneFile parse_scene(std::string_view content, const std::string& name,
                                    const std::filesystem::path& folder);

/// Makes a scene of a file. Meshes are looked for in its folder.
/// \param file  of at most `largest_scene_file` bytes
/// \return as parse_scene()
/// \throws ProblemError as parse_scene(), or if there is no such file or it cannot be read
[[nodiscard]] SceneFile read_scene(const std::filesystem::path& file);

/// Most bytes of a scene file that is read.
constexpr std::size_t largest_scene_file = std::size_t{1} << 20;

/// Says of an error where in the file its cause stands: at the body that it begins with, or that fails alike by itself; at
/// the contact that fails alike without the others, or without which the others do not; else at a contact that it calls
/// as tables do, at a body that it names, or at the first.
/// \param file     whose scene failed
/// \param message  of the error
/// \return `NAME:LINE: message`, or the message if it begins like this already
[[nodiscard]] std::string located(const SceneFile& file, const std::string& message);

/// Runs a step with the scene of a file, such as plan() or condense().
/// \param file  whose scene it takes
/// \param step  function without arguments
/// \return what the step returns
/// \throws ProblemError with its message as located(), if the step throws one; what else it throws as it is
template <typename Step>
auto at_file(const SceneFile& file, const Step& step) -> decltype(step()) {
  try {
    return step();
  } catch (const ProblemError& error) {
    throw ProblemError(located(file, error.what()));
  }
}

/// All keys of scene files in Markdown, from the tables that read them.
/// \return headings, tables and nothing else
[[nodiscard]] std::string key_reference();

}  // namespace signorini
