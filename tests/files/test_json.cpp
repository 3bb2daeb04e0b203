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
