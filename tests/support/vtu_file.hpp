// What stands in a VTU file.
#pragma once
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace signorini_test {

/// The words between the array called `name` and its end tag; empty if there is none.
inline std::vector<std::string> array_of(const std::string& file, const std::string& name) {
  const std::size_t tag = file.find("Name=\"" + name + "\"");
  if (tag == std::string::npos) return {};
  const std::size_t begin = file.find('>', tag) + 1;
  std::istringstream in(file.substr(begin, file.find("</DataArray>", begin) - begin));
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

/// The numbers of an appended array called `name`; empty if there is none.
template <typename Number>
std::vector<Number> appended_array_of(const std::string& file, const std::string& name) {
  const std::size_t tag = file.find("Name=\"" + name + "\"");
  const std::size_t data = file.find("<AppendedData encoding=\"raw\">\n_");
  if (tag == std::string::npos || data == std::string::npos) return {};
  const std::string offset = "format=\"appended\" offset=\"";
  const std::size_t at = file.find(offset, tag);
  if (at > file.find('>', tag)) return {};
  const std::size_t begin = file.find('_', data) + 1 + std::stoul(file.substr(at + offset.size()));
  std::uint64_t size = 0;
  if (begin + sizeof size > file.size()) return {};
  std::memcpy(&size, file.data() + begin, sizeof size);
  if (size > file.size() - begin - sizeof size) return {};
  std::vector<Number> numbers(size / sizeof(Number));
  std::memcpy(numbers.data(), file.data() + begin + sizeof size, size);
  return numbers;
}

/// Whether every tag that is opened is closed in the right order.
inline bool is_balanced(const std::string& file) {
  std::vector<std::string> open;
  for (std::size_t at = file.find('<'); at != std::string::npos; at = file.find('<', at + 1)) {
    const std::size_t end = file.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = file.substr(at + 1, end - at - 1);
    if (tag[0] == '?') continue;
    if (tag.rfind("!--", 0) == 0) {
      at = file.find("-->", at);
      if (at == std::string::npos) return false;
      continue;
    }
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(tag.substr(0, tag.find(' ')));
    }
  }
  return open.empty();
}

}  // namespace signorini_test
