// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Which words of an input file of CalculiX or Abaqus are read as elements, and which are refused.
#pragma once
#include <cstddef>
#include <map>
#include <string>

namespace signorini {

/// What a type of elements is.
struct InpElementType {
  std::size_t corners = 0;  ///< 2 of a line; 0: it is not read
  std::size_t nodes = 0;    ///< of a line 0: two or three, as many as stand on the line of the file
  int first_side = 1;       ///< number behind S of its first side; 3 of a shell, whose two faces come first
};

/// \param name  of a type in capital letters, such as CPS4R
/// \return what it is
[[nodiscard]] InpElementType inp_element_type(const std::string& name);

/// \return keywords that would change the mesh and are not read, each with the way out
[[nodiscard]] const std::map<std::string, const char*>& inp_refused();

}  // namespace signorini
