// # Contact at nodes
//
// Contact happens at pairs, and a picture shows nodes. So each node of a source shows its pair: what it
// presses with, how far it is open, what it does. A node without a pair shows that nothing happens there.

#include "signorini/report/nodal_fields.hpp"

#include <cmath>

#include "signorini/report/pair_columns.hpp"

namespace signorini {
namespace {

using Eigen::Index;

// The pair that stands for each node of all bodies: of several at one node the first with the largest force; -1
// without one.
// Contact happens at pairs, a picture shows nodes. A node where several contacts meet can show only
// one of them: the one with the largest force.
std::vector<Index> pairs_at_nodes(const Model& model, const Solution& solution) {
  std::vector<Index> found(static_cast<std::size_t>(model.unknowns.number.rows()), -1);
  const Eigen::VectorXd& force = solution.contact.force;
  for (Index pair = 0; pair < force.size(); ++pair) {
    const Index node = model.pairs.node[static_cast<std::size_t>(pair)];
    if (node < 0) continue;
    Index& known = found[static_cast<std::size_t>(node)];
    if (known < 0 || force(pair) > force(known)) known = pair;
  }
  return found;
}

// A field from values of the pairs; `other` where a node has no pair, or its pair no value.
// Nodes without a pair show a number that means nothing happened: 0 for a pressure, -1 for a
// status, where 0 means open.
NodalField at_nodes(const std::string& name, const FieldRows& of_pairs, const std::vector<Index>& pairs,
                    double other, bool whole) {
  NodalField field{
      name, FieldRows::Constant(static_cast<Index>(pairs.size()), of_pairs.cols(), other), whole};
  for (std::size_t node = 0; node < pairs.size(); ++node)
    if (pairs[node] >= 0 && !std::isnan(of_pairs(pairs[node], 0)))
      field.values.row(static_cast<Index>(node)) = of_pairs.row(pairs[node]);
  return field;
}

/// Pressure along the normals, shear traction along the tangents.
// The traction on the source: pressure along the normal, which points out of the target, and shear
// along the tangent \f$ (n_y, -n_x) \f$.
// With friction \f$ \mu = 0 \f$ the shear is zero, and the arrows stand on the boundary at right
// angles.
FieldRows tractions(const Model& model, const Solution& solution) {
  const Pairs& pairs = model.pairs;
  FieldRows traction = solution.pressure.asDiagonal() * pairs.normal;
  const Eigen::VectorXd shear = shear_tractions(model, solution);
  traction.col(0) += shear.cwiseProduct(pairs.normal.col(1));
  traction.col(1) -= shear.cwiseProduct(pairs.normal.col(0));
  return traction;
}

}  // namespace

// Which fields there are is decided by the columns of pairs: every column that has a name for
// viewers becomes one.
// The traction is a vector and no column, so it is added here.
std::vector<NodalField> nodal_fields(const Model& model, const Solution& solution,
                                     const std::optional<PathTotals>& totals) {
  const std::vector<Index> pairs = pairs_at_nodes(model, solution);
  std::vector<NodalField> fields;
  for (const PairColumn& column : pair_columns(model, solution, totals)) {
    if (column.field.empty()) continue;
    const bool whole = !column.words.empty();
    fields.push_back(at_nodes(column.field, column.values, pairs, whole ? -1 : 0, whole));
  }
  if (solution.pressure.size() > 0)
    fields.push_back(at_nodes("contact_traction", tractions(model, solution), pairs, 0, false));
  return fields;
}

}  // namespace signorini
