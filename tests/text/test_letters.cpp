// Letters of UTF-8, and characters that control a terminal.
#include <string>

#include "addons/text/letters.hpp"
#include "catch_compat.hpp"

using namespace signorini;

TEST_CASE("a letter of UTF-8 has as many bytes as its first one says", "[text]") {
  CHECK(length_of_letter("a", 0) == 0);
  CHECK(length_of_letter("\xc3\xa4", 0) == 2);
  CHECK(length_of_letter("a\xe2\x82\xac", 1) == 3);
  CHECK(length_of_letter("\xf0\x9f\x98\x80", 0) == 4);
  for (const std::string none : {"\xa4", "\xc3", "\xc0\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80"})
    CHECK(length_of_letter(none, 0) == 0);
}

TEST_CASE("control characters are those below a blank, delete, and the second lot of UTF-8",
          "[text]") {
  for (const std::string bad : {"a\nb", "\t", "\x1b[2J", "a\x7f", "\xc2\x9b", "a\xc2\x80"})
    CHECK(has_control_characters(bad));
  for (const std::string good : {"", "a b~", "\xc2\xa0", "\xc3\xa4", "\xe2\x82\xac"})
    CHECK_FALSE(has_control_characters(good));
}
