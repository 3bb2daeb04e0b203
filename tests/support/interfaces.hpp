// Two blocks that may touch, for the tests of the gap operators.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "signorini/contact/gap_operators.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"
#include "support/random.hpp"

namespace signorini_test {

/// The source lies on the target: its `bottom` faces the other's `top`.
struct TwoBodies {
  signorini::Mesh source;
  signorini::Mesh target;
  std::string source_boundary = "bottom";
  std::string target_boundary = "top";
};

struct Extent {
  double from;
  double to;
  Eigen::Index cells;
};

enum class Form { Flat, Inclined, Curved };

inline Eigen::Vector2d turned(const Eigen::Vector2d& x, double angle) {
  return {std::cos(angle) * x.x() - std::sin(angle) * x.y(),
          std::sin(angle) * x.x() + std::cos(angle) * x.y()};
}

/// Two blocks one above the other, `gap` apart; then turned, or bent into waves. Quadratic cells of
/// a curved interface are curved.
inline TwoBodies two_blocks(const Extent& source, const Extent& target, double gap, Form form,
                            signorini::MeshOrder order) {
  signorini::BlockSpec spec;
  spec.order = order;
  spec.cells_y = 2;
  const auto make = [&](const char* name, const Extent& x, double low) {
    spec.name = name;
    spec.corner = {x.from, low};
    spec.size = {x.to - x.from, 1};
    spec.cells_x = x.cells;
    return signorini::mapped(signorini::make_block(spec), [form](const Eigen::Vector2d& at) {
      if (form == Form::Inclined) return turned(at, 0.7);
      if (form == Form::Curved)
        return Eigen::Vector2d(at.x(), at.y() + 0.2 * std::sin(1.3 * at.x()));
      return at;
    });
  };
  return {make("upper", source, gap), make("lower", target, -1)};
}

inline signorini::GapOptions options_for(const TwoBodies& bodies, bool sliding = true) {
  signorini::GapOptions options;
  options.n_nodes = bodies.source.n_nodes() + bodies.target.n_nodes();
  options.depth.factor = 0.5;
  options.sliding = sliding;
  return options;
}

/// The source's nodes come first.
inline signorini::Pairs pairs_of(const signorini::GapOperator& member, const TwoBodies& bodies,
                                 const signorini::GapOptions& options) {
  return member.pair({bodies.source, bodies.source_boundary, 0},
                     {bodies.target, bodies.target_boundary, bodies.source.n_nodes()}, options);
}

inline signorini::Pairs pairs_of(const signorini::GapOperator& member, const TwoBodies& bodies) {
  return pairs_of(member, bodies, options_for(bodies));
}

/// Positions of the nodes of both.
inline signorini::NodeArray all_nodes(const TwoBodies& bodies) {
  signorini::NodeArray nodes(bodies.source.n_nodes() + bodies.target.n_nodes(), 2);
  nodes << bodies.source.nodes, bodies.target.nodes;
  return nodes;
}

/// A vector per node as one column, as the matrices take it.
inline Eigen::VectorXd flat(const signorini::NodeArray& u) {
  return Eigen::Map<const Eigen::VectorXd>(u.data(), u.size());
}

inline std::vector<Eigen::Index> shuffled(Eigen::Index n, Random& random) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  for (std::size_t k = order.size(); k > 1; --k)
    std::swap(order[k - 1],
              order[static_cast<std::size_t>(random.uniform(0, static_cast<double>(k)))]);
  return order;
}

/// The same body with nodes and cells in another order; `nodes[k]` is the new number of node k.
inline signorini::Mesh renumbered(const signorini::Mesh& mesh,
                                  const std::vector<Eigen::Index>& nodes,
                                  const std::vector<Eigen::Index>& cells) {
  signorini::Mesh other = mesh;
  for (Eigen::Index k = 0; k < mesh.n_nodes(); ++k)
    other.nodes.row(nodes[static_cast<std::size_t>(k)]) = mesh.nodes.row(k);
  other.cells.setConstant(-1);
  for (Eigen::Index c = 0; c < mesh.n_cells(); ++c)
    for (Eigen::Index k = 0; k < mesh.cell_size(c); ++k)
      other.cells(cells[static_cast<std::size_t>(c)], k) =
          nodes[static_cast<std::size_t>(mesh.cells(c, k))];
  for (auto& [name, sides] : other.boundaries)
    for (signorini::CellSide& side : sides) side.cell = cells[static_cast<std::size_t>(side.cell)];
  for (auto& [name, numbers] : other.regions)
    for (Eigen::Index& number : numbers) number = cells[static_cast<std::size_t>(number)];
  return other;
}

}  // namespace signorini_test
