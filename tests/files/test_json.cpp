#include <cmath>
#include <limits>

#include "addons/files/json.hpp"
#include "catch_compat.hpp"

using signorini::Json;

TEST_CASE("a JSON document nests, separates and indents", "[json]") {
  Json json;
  json.object().key("name").value("beam").key("list").array().value(1.5).object().end().end();
  json.key("yes").value(true).key("count").value(Eigen::Index{7}).key("none").array().end();
  json.key("x").value(Eigen::VectorXd(Eigen::Vector2d(0.1, -2))).end();
  CHECK(json.text() ==
        "{\n  \"name\": \"beam\",\n  \"list\": [\n    1.5,\n    {}\n  ],\n  \"yes\": true,\n"
        "  \"count\": 7,\n  \"none\": [],\n  \"x\": [0.1, -2]\n}\n");
}

TEST_CASE("what JSON has no word for is escaped or null", "[json]") {
  Json json;
  const double infinity = std::numeric_limits<double>::infinity();
  json.array().value(std::nan("")).value(infinity).value(Eigen::VectorXd::Constant(1, -infinity));
  json.value("\"\\\n\x01\xff").end();
  CHECK(json.text() == "[\n  null,\n  null,\n  [null],\n  \"\\\"\\\\\\u000a\\u0001\\u00ff\"\n]\n");
}

TEST_CASE("letters beyond ASCII stay what they are, and bytes that are no letter are escaped",
          "[json]") {
  const auto written = [](const char* text) {
    const std::string all = Json().value(text).text();
    return all.substr(1, all.size() - 3);
  };
  for (const char* letter :
       {"\xc3\xb6", "\xe2\x82\xac", "\xed\x9f\xbf", "\xf0\x9f\x98\x80", "\xf4\x8f\xbf\xbf"})
    CHECK(written(letter) == letter);
  CHECK(written("a\xc3\xb6z") == "a\xc3\xb6z");
  CHECK(written("\xc3") == "\\u00c3");                                   // the rest is missing
  CHECK(written("\xc3x") == "\\u00c3x");                                 // something else follows
  CHECK(written("\xc0\xaf") == "\\u00c0\\u00af");                        // a longer way to say '/'
  CHECK(written("\xe0\x9f\xbf") == "\\u00e0\\u009f\\u00bf");             // as above
  CHECK(written("\xed\xa0\x80") == "\\u00ed\\u00a0\\u0080");             // half a pair of UTF-16
  CHECK(written("\xf4\x90\x80\x80") == "\\u00f4\\u0090\\u0080\\u0080");  // beyond the last letter
}

TEST_CASE("texts of an array stand on one line, and missing ones are null", "[json]") {
  Json json;
  json.value(std::vector<std::string>{"a \"b\"", "", "c"});
  CHECK(json.text() == "[\"a \\\"b\\\"\", null, \"c\"]\n");
}

TEST_CASE("an unfinished JSON document is the caller's mistake", "[json]") {
  Json json;
  CHECK_THROWS_AS(json.end(), std::invalid_argument);
  json.object();
  CHECK_THROWS_AS(json.text(), std::invalid_argument);
}
