// # Text in XML
//
// A name may hold a quotation mark or an ampersand, and a note the sign `<`. In XML these begin or end something else. By hand:
// `a < b` is written as `a &lt; b`, and `1--2` in a comment, which two hyphens would end, as `1- -2`.
//
// Some characters no file of XML can hold, whatever stands for them: those that control a terminal, and bytes that are no UTF-8. A
// question mark stands in their place.
//
// Names come back from lists of files that this program wrote, so there is a way back for them. Notes are only read by people,
// and there is none.

#include "addons/vtu/xml.hpp"

#include <iterator>
#include <utility>

#include "addons/text/letters.hpp"

namespace signorini {
namespace {

/// Characters that XML has for itself, and what stands for them.
constexpr std::pair<char, const char*> entities[] = {
    {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};

// The bytes of a text in order; `?` for what XML cannot hold. It holds all letters but the last two of the first 65536, U+FFFE and
// U+FFFF.
std::string without_others(std::string text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    const std::size_t length = length_of_letter(text, at);
    const bool last_two = length == 3 && text.compare(at, 3, "\xef\xbf\xbd") > 0;
    if (length > 0 && !last_two)
      at += length - 1;
    else if ((c < ' ' || c > '~') && c != '\n' && c != '\t')
      text[at] = '?';
  }
  return text;
}

}  // namespace

// Letter by letter, so that what an entity brings in is not looked at again.
std::string in_xml(const std::string& text) {
  std::string result;
  for (const char c : without_others(text)) {
    std::string word(1, c);
    for (const auto& [letter, entity] : entities)
      if (c == letter) word = entity;
    result += word;
  }
  return result;
}

// The other way round, entity by entity. The ampersand has to come last: otherwise one that is followed by `lt;` would end as a bracket.
std::string from_xml(std::string text) {
  for (std::size_t k = std::size(entities); k-- > 0;)
    for (std::size_t from = 0; (from = text.find(entities[k].second, from)) != std::string::npos;
         ++from)
      text.replace(from, std::char_traits<char>::length(entities[k].second), 1, entities[k].first);
  return text;
}

// A blank is put before every hyphen that follows one. Of four there are four left, each apart. What a reader of the file
// sees is not what was written, but a note is read by people.
std::string in_xml_comment(std::string text) {
  text = without_others(std::move(text));
  for (std::size_t at = 0; (at = text.find("--", at)) != std::string::npos; ++at)
    text.insert(at + 1, 1, ' ');
  return text;
}

}  // namespace signorini
