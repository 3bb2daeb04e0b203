// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What equations of relations and of rigid sides are made of.
#pragma once
#include <Eigen/Core>
#include <map>
#include <optional>
#include <vector>

#include "addons/equations/equations.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini {

/// Coefficients by components, 2 * node + axis with the nodes of all bodies one after another [-].
using Terms = std::map<Eigen::Index, double>;

/// \param draft  knows bodies \param node  among those of all \return where it lies [length]
[[nodiscard]] Eigen::Vector2d place_of(const Plan& draft, Eigen::Index node);

/// \param side  of a body \param only_at  the node there alone [length] \param draft  knows bodies
/// \return its nodes among those of all bodies
/// \throws ProblemError if there is no such body, boundary or node
[[nodiscard]] std::vector<Eigen::Index> nodes_of(const Side& side, const std::optional<Eigen::Vector2d>& only_at,
                                                 const Plan& draft);

/// Adds the displacement of a node in a direction. \param terms  get it \param node  among those of all bodies \param along  direction [-]
void add_to(Terms& terms, Eigen::Index node, const Eigen::Vector2d& along);

/// \param terms  of it \param right  what they are in sum [length] \return their equation
[[nodiscard]] Equation equation_of(const Terms& terms, double right);

}  // namespace signorini
