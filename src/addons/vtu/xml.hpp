// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Text in files of XML.
#pragma once
#include <string>

namespace signorini {

/// A text between quotation marks of XML.
/// \param text  any
/// \return the same with entities for `&`, `<`, `>` and quotation marks, and `?` for each byte that XML cannot hold
[[nodiscard]] std::string in_xml(const std::string& text);

/// \param text  from in_xml()
/// \return what it was made of, if XML can hold all of it
[[nodiscard]] std::string from_xml(std::string text);

/// A text in a comment of XML, which may not contain two hyphens.
/// \param text  any
/// \return the same with a blank between hyphens, and `?` for each byte that XML cannot hold
[[nodiscard]] std::string in_xml_comment(std::string text);

}  // namespace signorini
