#include "catch_compat.hpp"
#include "signorini/core/errors.hpp"
#include "support/message.hpp"

using signorini_test::argument_message;
using signorini_test::problem_message;

TEST_CASE("a caller's mistake and a wrong problem are different errors", "[errors]") {
  CHECK(argument_message([] {
          signorini::require_argument(false, "need ", 2, " rows, got ", 1.5);
        }) == "need 2 rows, got 1.5");
  CHECK(problem_message([] { signorini::require_input(false, "cell ", 7, " is inverted"); }) ==
        "cell 7 is inverted");
}

TEST_CASE("nothing is thrown when all is well", "[errors]") {
  CHECK_NOTHROW(signorini::require_argument(true, "not seen"));
  CHECK_NOTHROW(signorini::require_input(true, "not seen"));
}
