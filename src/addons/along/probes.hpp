// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Probes: what a solution says at points, along lines and of boundaries.
///
/// A probe reads what files for viewers have: displacements between the nodes by the shape functions, stresses from nodal_stress()
/// and between the nodes by the same functions, contact at the nodes of the sources.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "addons/along/probe.hpp"
#include "signorini/report/pair_columns.hpp"

namespace signorini {

/// \param from  first point [length] \param to  last point [length] \param count  of points, at least 2
/// \return `count x 2` points at equal distances [length]
[[nodiscard]] NodeArray points_between(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                       Eigen::Index count);

/// What probes read.
///
/// At points and along a boundary: `distance` from the first point, along a boundary its length up to there; `x`, `y` before loading;
/// `displacement_x`, `displacement_y` [length]; `stress_xx`, `stress_yy`, `stress_xy`, `stress_zz`, `von_mises` [force/length^2], tension
/// positive; with contact `contact_gap`, `contact_pressure` and, with friction, `contact_shear_traction`, as PairColumn has them, where
/// all nodes that share the place are nodes of a source. Points of a line that this mesh does not have, and points far outside, have but
/// `distance`, `x` and `y`. Along a boundary also the forces on its nodes, of contact on either side,
/// and of supports and springs if the body has any.
///
/// Of a boundary: `displacement_x`, `displacement_y`, the mean along it; force and moment about the origin of contact, supports and
/// springs on its nodes. With bodies that move arms are those of where nodes have moved to. In axial symmetry sums along x and
/// moments are none.
/// \param model     that was solved
/// \param solution  of it
/// \param probes    of bodies of the model
/// \param totals    after this step of a path; nothing: the solution is no step
/// \return the columns of each probe, a value for each of its places; what means nothing at a place is not a number
/// \throws ProblemError if a body or a boundary is not there; std::invalid_argument as pair_columns()
[[nodiscard]] std::vector<std::vector<PairColumn>> probed(
    const Model& model, const Solution& solution, const std::vector<Probe>& probes,
    const std::optional<PathTotals>& totals = {});

/// All probes in one table: a first column `probe`, then every column that one of them has.
/// \param probes   in order
/// \param columns  of each, from probed()
/// \return the columns; not a number where a probe has none of that name
[[nodiscard]] std::vector<PairColumn> table_of(const std::vector<Probe>& probes,
                                               const std::vector<std::vector<PairColumn>>& columns);

}  // namespace signorini
