#include <cmath>
#include <memory>
#include <utility>

#include "addons/files/scene_keys.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"

namespace signorini {

template <>
const std::vector<Word<Over>> words_of<Over> = {
    {"x", Over::X}, {"y", Over::Y}, {"length", Over::Length}};

namespace {

/// The lists of numbers that a table or a polynomial consists of.
Eigen::MatrixXd rows_of(const Value& value, std::size_t columns, const std::string& each) {
  if (value.kind != Value::Kind::List || value.items.empty())
    value.fail("expected a list of rows ", each, ", got ", value.shown());
  Eigen::MatrixXd rows(value.items.size(), columns);
  for (std::size_t k = 0; k < value.items.size(); ++k) {
    const Value& row = value.items[k];
    if (row.kind != Value::Kind::List || row.items.size() != columns)
      row.fail("expected a row ", each, ", got ", row.shown());
    for (std::size_t i = 0; i < columns; ++i)
      take(row.items[i], rows(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)));
  }
  return rows;
}

void read_table(const Value& value, Eigen::Index components, Variation& into) {
  const Eigen::MatrixXd rows =
      rows_of(value, at(components + 1),
              components == 1 ? "[place, value]" : "[place, value along x, value along y]");
  into.values = rows.rightCols(components);
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    const double place = rows(k, 0);
    const Value& row = value.items[at(k)];
    if (k > 0 && place < into.places.back())
      row.fail("places must increase, but ", place, " follows ", into.places.back());
    if (k > 1 && place == into.places[at(k - 2)])
      row.fail("the place ", place, " stands there three times: once is a value, twice a jump");
    into.places.push_back(place);
  }
}

/// Beyond its rows a table is constant. One that has no row within what it is for is another number than was meant.
void check_meets(const Variation& variation, const Mesh& mesh, const std::string& boundary) {
  const NodeArray nodes =
      boundary.empty() ? mesh.nodes : NodeArray(mesh.nodes(boundary_nodes(mesh, boundary), Eigen::all));
  const auto along = nodes.col(variation.over == Over::Y ? 1 : 0);
  const double first = variation.length ? 0 : along.minCoeff();
  const double last = variation.length ? variation.length->whole() : along.maxCoeff();
  const double low = variation.places.front();
  const double high = variation.places.back();
  require_input(low == high || first == last || (low < last && high > first), "its rows go from ", low,
                " to ", high, ", but '", boundary.empty() ? mesh.name : boundary, "' goes from ", first,
                " to ", last, ": it would be one number there");
}

void read_polynomial(const Value& value, Eigen::Index components, Variation& into) {
  const Eigen::MatrixXd rows = rows_of(
      value, at(components + 2),
      components == 1 ? "[c, i, j], for c x^i y^j" : "[c along x, c along y, i, j], for c x^i y^j");
  into.values = rows.leftCols(components);
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    const double i = rows(k, components);
    const double j = rows(k, components + 1);
    if (i < 0 || j < 0 || i != std::floor(i) || j != std::floor(j) || i + j > largest_degree)
      value.items[at(k)].fail("powers must be whole numbers >= 0 with a sum of at most ",
                              largest_degree, ", got ", i, " and ", j);
    into.powers.push_back({static_cast<int>(i), static_cast<int>(j)});
  }
}

}  // namespace

const std::vector<KeyInfo>& varying_keys() {
  static const std::vector<KeyInfo> keys = {
      {"over", type_name<Over>(), "", "",
       "what the table is over: a coordinate, or the length of the boundary from its begin on"},
      {"table", "list of [place, value]", "", "",
       "of vectors [place, x, y]; straight between, constant beyond, the same place twice is a "
       "jump"},
      {"polynomial", "list of [c, i, j]", "", "",
       "in place of over and table: the sum of c x^i y^j, of vectors [c_x, c_y, i, j]"}};
  return keys;
}

bool varies(const Value& value) {
  if (value.kind != Value::Kind::Table) return false;
  for (const KeyInfo& key : varying_keys())
    if (value.find(key.name) != nullptr) return true;
  return false;
}

Variation read_variation(const Value& value, Eigen::Index components, const Mesh& mesh,
                         const std::string& boundary) {
  check_members(value, varying_keys());
  const Value* const over = value.find("over");
  const Value* const table = value.find("table");
  const Value* const polynomial = value.find("polynomial");
  if ((polynomial != nullptr) == (table != nullptr) || (over != nullptr) != (table != nullptr))
    value.fail("expected either over and table, or polynomial");
  Variation variation;
  if (polynomial != nullptr) {
    read_polynomial(*polynomial, components, variation);
    return variation;
  }
  take(*over, variation.over);
  if (variation.over == Over::Length) {
    if (boundary.empty())
      over->fail("a body has no length, only a boundary has: give \"x\" or \"y\"");
    variation.length =
        over->explain([&] { return std::make_shared<const ArcLength>(mesh, boundary); });
  }
  read_table(*table, components, variation);
  table->explain([&] { check_meets(variation, mesh, boundary); });
  return variation;
}

const Value& without_history(const Value& value, std::string& history) {
  if (value.kind != Value::Kind::Table || varies(value)) return value;
  check_members(value, growing_keys());
  take(*value.find("history"), history);
  return *value.find("value");
}

}  // namespace signorini
