// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What a file is that is no mesh file of Gmsh.
#pragma once
#include <string>
#include <string_view>

namespace signorini {

/// Recognises files that people have instead of a mesh file of Gmsh: geometries, and meshes of other programs.
/// \param content  of the file, without `$MeshFormat`
/// \return what it is, and how to save what is read, in words that follow "this is"; empty if nothing is known
[[nodiscard]] std::string other_kind(std::string_view content);

/// \param content  of a file \return whether it begins as a text in UTF-16 does
[[nodiscard]] bool is_utf16(std::string_view content);

}  // namespace signorini
