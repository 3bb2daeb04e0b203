// # How far pairs have slid
//
// Where there is friction, the problem has a row for the slip of each pair. Where there is none,
// bodies slide as well, and a reader may want to know how far: a small displacement is assumed, and
// a slip of more than a cell says that it is not. A point that has moved by (0.2, -0.1) on a floor
// with the normal (0, 1) has the tangent (1, 0), and has slid by 0.2.

#include <utility>

#include "signorini/contact/gaps.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/readings.hpp"

namespace signorini {

// Every entry \f$ n_x \f$ moves to the y column as \f$ -n_x \f$, every \f$ n_y \f$ to the x
// column. The normal (0, 1) becomes the tangent (1, 0). So slips can be read also where no
// friction asked for the rows S.
NodalRows turned(const NodalRows& opening) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index row = 0; row < opening.rows(); ++row)
    for (NodalRows::InnerIterator it(opening, row); it; ++it) {
      const bool along_x = it.col() % 2 == 0;
      entries.emplace_back(static_cast<int>(row),
                           static_cast<int>(along_x ? it.col() + 1 : it.col() - 1),
                           along_x ? -it.value() : it.value());
    }
  return rows_of(std::move(entries), opening.rows(), opening.cols());
}

// Bodies have arrays of their own, rows of N have columns for all nodes.
Eigen::VectorXd all_displacements(const Model& model, const std::vector<NodeArray>& displacements) {
  Eigen::VectorXd all(2 * count_nodes(model.bodies));
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    all.segment(2 * model.bodies[b].first_node, displacements[b].size()) =
        Eigen::Map<const Eigen::VectorXd>(displacements[b].data(), displacements[b].size());
  return all;
}

// Displacements of held nodes are given, not zero. They are among all displacements, so
// nothing is added for supports.
Eigen::VectorXd slips(const Model& model, const std::vector<NodeArray>& displacements) {
  return turned(model.pairs.opening) * all_displacements(model, displacements);
}

}  // namespace signorini
