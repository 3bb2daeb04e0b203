// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What contact did, at the nodes of all bodies: for viewers.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "signorini/scene/readings.hpp"

namespace signorini {

/// A row for each node, or each cell.
using FieldRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Numbers or vectors of the plane at nodes.
struct NodalField {
  std::string name;   ///< as viewers show it
  FieldRows values;   ///< `n_nodes x 1` or `n_nodes x 2`
  bool whole = false; ///< whether they are whole numbers: a viewer then makes no colours between open and closed
};

/// \param model     that was solved
/// \param solution  of it
/// \param totals    after this step of a path; nothing: the solution is no step
/// \return a field for each of pair_columns() that has a name for viewers, and `contact_traction`
/// \throws std::invalid_argument as pair_columns()
[[nodiscard]] std::vector<NodalField> nodal_fields(const Model& model, const Solution& solution,
                                                   const std::optional<PathTotals>& totals);

}  // namespace signorini
