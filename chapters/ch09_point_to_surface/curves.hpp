/// \file
/// Data of the figures.
#pragma once
#include <vector>

#include "contact_element.hpp"
#include "newton.hpp"
#include "signorini/core/table.hpp"

namespace ch09 {

/// Figure 9.1: the edge, node 3 and its projection, the forces on nodes 1 to 3, the reaction at 3'.
/// \param X   positions of the nodes
/// \param fn  normal force \param ft  friction
/// \return a line from (x, y) to (x2, y2) per row
inline signorini::Table sketch(const Nodes& X, double fn, double ft) {
  signorini::Table table({"x", "y", "x2", "y2"});
  const auto line = [&table](const Eigen::RowVector2d& from, const Eigen::RowVector2d& to) {
    table.row({from.x(), from.y(), to.x(), to.y()});
  };
  const Place at = projected(X);
  const Eigen::RowVector2d foot = at.N1 * X.row(0) + at.N2 * X.row(1);
  const Nodes forces = nodal_forces(at, fn, ft);
  line(X.row(0), X.row(1));
  line(X.row(2), foot);
  for (Eigen::Index i = 0; i < 3; ++i) line(X.row(i), X.row(i) + forces.row(i));
  line(foot, foot + forces.row(0) + forces.row(1));
  return table;
}

/// Figure 9.3: one block of rows per method.
/// \param condensed  the way of condensed_newton()
/// \param reports    of the uncondensed ones
/// \return residual after each step
inline signorini::Table histories(const Way& condensed,
                                  const std::vector<const signorini::Report*>& reports) {
  signorini::Table table({"step", "residual"});
  for (std::size_t k = 0; k < condensed.residuals.size(); ++k)
    table.row({static_cast<double>(k), condensed.residuals[k]});
  for (const signorini::Report* report : reports) {
    table.blank_line();
    table.row({0.0, 1.0});
    for (std::size_t k = 0; k < report->history.size(); ++k)
      table.row({static_cast<double>(k + 1), report->history[k].residual});
  }
  return table;
}

}  // namespace ch09
