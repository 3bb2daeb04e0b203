#include "command_line/quoting.hpp"

#include <string_view>

namespace command_line {
namespace {

/// Three digits of base 8.
std::string octal(unsigned byte) {
  std::string digits(3, '0');
  for (std::size_t k = 3; k-- > 0; byte /= 8) digits[k] = "01234567"[byte % 8];
  return digits;
}

}  // namespace

std::string for_shell(const std::string& word) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./+,:@%-";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

// Between single quotes gnuplot takes all letters as they are, and a line ends there as everywhere. So a byte that could end one
// stands between double quotes, by its number.
std::string for_gnuplot(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\'')
      result += "''";
    else if (byte < 0x20 || byte == 0x7f)
      result += "'.\"\\" + octal(byte) + "\".'";
    else
      result += c;
  }
  return result + "'";
}

}  // namespace command_line
