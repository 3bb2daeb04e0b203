#include "catch_compat.hpp"
#include "signorini/core/wording.hpp"

using namespace signorini;

TEST_CASE("the nearest word is suggested, or none if none is near", "[wording]") {
  CHECK(suggestion("lemk", {"newton", "lemke"}) ==
        "; did you mean 'lemke'? There are: newton, lemke");
  CHECK(suggestion("magic", {"newton", "lemke"}) == "; there are: newton, lemke");
  CHECK(suggestion("axial", {"plane strain", "axial symmetry"}) ==
        "; did you mean 'axial symmetry'? There are: plane strain, axial symmetry");
  CHECK(suggestion("", {"ant"}) == "; there are: ant");
  CHECK(suggestion("ant", {}) == "; there are: none");
}

TEST_CASE("words are shown short and printable", "[wording]") {
  CHECK(in_quotes("a\nb\x7f") == "'a?b?'");
  CHECK(in_quotes(std::string(41, 'x')) == "'" + std::string(40, 'x') + "...'");
  CHECK(in_quotes(std::string(40, 'x')) == "'" + std::string(40, 'x') + "'");
}
