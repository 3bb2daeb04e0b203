#include "catch_compat.hpp"
#include "signorini/core/table.hpp"
#include "support/message.hpp"

using signorini::number;
using signorini::shortest;
using signorini::Table;
using signorini_test::argument_message;

TEST_CASE("a table for a figure has a tolerance, column names, rows and blocks", "[table]") {
  Table table({"x", "pressure"});
  table.row({0.5, 1.25});
  table.blank_line();
  table.row({1.0, -2.0});
  CHECK(table.csv("rel 1e-3 abs 0") ==
        "# tolerance rel 1e-3 abs 0\nx,pressure\n0.5,1.25\n\n1,-2\n");
}

TEST_CASE("a table for a text is Markdown with numbers flush right", "[table]") {
  Table table({"mesh", "force"});
  table.row({std::string("50 x 5"), number(71.53025, "%.3f")});
  CHECK(table.markdown() == "| mesh | force |\n|---:|---:|\n| 50 x 5 | 71.530 |\n");
}

TEST_CASE("a row with a cell too few or too many names the columns", "[table]") {
  Table table({"x", "y"});
  CHECK_THAT(argument_message([&] { table.row(std::vector<double>{1.0}); }),
             ContainsSubstring("need 2 cells (x, y), got 1"));
  CHECK_THAT(argument_message([&] { table.row({1.0, 2.0, 3.0}); }), ContainsSubstring("got 3"));
}

TEST_CASE("a number is printed with the format it is given", "[table]") {
  CHECK(number(2.0 / 3.0, "%.2f") == "0.67");
  CHECK(number(-1e-20, "%.1e") == "-1.0e-20");
  CHECK_THAT(argument_message([] { static_cast<void>(number(1, "%200.3f")); }),
             ContainsSubstring("%200.3f"));
}

TEST_CASE("a table of columns has their numbers in rows, each in its format", "[table]") {
  const signorini::Table table = signorini::table_of(
      {{"x", Eigen::Vector2d(0.5, 1), "%.1f"}, {"pressure", Eigen::Vector2d(1.25, -2)}});
  CHECK(table.csv("rel 0") == "# tolerance rel 0\nx,pressure\n0.5,1.25\n1.0,-2\n");
  CHECK_THAT(argument_message([] {
               static_cast<void>(signorini::table_of(
                   {{"x", Eigen::Vector2d(0, 1)}, {"y", Eigen::Vector3d(0, 1, 2)}}));
             }),
             ContainsSubstring("'y' has 3 rows, 'x' has 2"));
  CHECK_THROWS_AS(signorini::table_of({}), std::invalid_argument);
}

TEST_CASE("the shortest form of a number gives it back exactly", "[table]") {
  CHECK(shortest(0.1) == "0.1");
  CHECK(shortest(-99.96) == "-99.96");
  CHECK(shortest(1e-12) == "1e-12");
  for (const double value : {1.0 / 3, -2.2250738585072014e-308, 1.7976931348623157e308})
    CHECK(std::stod(shortest(value)) == value);
}
