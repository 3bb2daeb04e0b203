// Texts between quotes of a shell and of gnuplot.
#include <array>
#include <cstdio>
#include <string>

#include "catch_compat.hpp"
#include "command_line/quoting.hpp"

using command_line::for_gnuplot;
using command_line::for_shell;

namespace {

/// What a shell makes of a word.
std::string as_read(const std::string& word) {
  std::FILE* const pipe = popen(("printf %s " + for_shell(word)).c_str(), "r");
  std::array<char, 200> content{};
  const std::size_t size = std::fread(content.data(), 1, content.size(), pipe);
  pclose(pipe);
  return {content.data(), size};
}

}  // namespace

TEST_CASE("a word that means something to a shell is put between quotes", "[command_line]") {
  for (const std::string plain : {"a.toml", "../out/p_1.state", "-"})
    CHECK(for_shell(plain) == plain);
  CHECK(for_shell("my run.toml") == "'my run.toml'");
  for (const std::string odd :
       {"a b", "it's", "$(touch x)", "a;b", "`c`", "two\nlines", "*", "\xc3\xa4"})
    CHECK(as_read(odd) == odd);
  CHECK(for_shell("") == "''");
}

TEST_CASE("no text ends a line of a script of gnuplot", "[command_line]") {
  CHECK(for_gnuplot("it's a `b` \"c\" \\") == "'it''s a `b` \"c\" \\'");
  CHECK(for_gnuplot("b\n!touch x\n#") == R"('b'."\012".'!touch x'."\012".'#')");
  CHECK(for_gnuplot("\x1b\x7f") == R"(''."\033".''."\177".'')");
  CHECK(for_gnuplot("\xc3\xa4") == "'\xc3\xa4'");
}
