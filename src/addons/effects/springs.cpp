#include "addons/effects/springs.hpp"

#include "signorini/core/errors.hpp"
#include "signorini/fem/along_boundary.hpp"
#include "signorini/fem/places.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// Adds a spring between two nodes, or of one, in both directions; a direction without stiffness gets no entry.
void add(Index row, Index column, const Eigen::Vector2d& stiffness, Triplets& entries) {
  for (int axis = 0; axis < 2; ++axis)
    if (stiffness(axis) != 0)
      entries.emplace_back(static_cast<int>(2 * row + axis), static_cast<int>(2 * column + axis),
                           stiffness(axis));
}

void add_along(const Mesh& mesh, const Depth& depth, const Spring& spring, Triplets& entries) {
  integrate_boundary(mesh, spring.boundary, [&](const BoundaryPoint& at) {
    const double area = depth.at(at.point.position().x()) * at.weight * at.tangent.norm();
    const std::vector<Index>& nodes = at.side.nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t j = 0; j < nodes.size(); ++j)
        add(nodes[i], nodes[j],
            at.N(static_cast<Index>(i)) * at.N(static_cast<Index>(j)) * area * spring.stiffness,
            entries);
  });
}

}  // namespace

Eigen::SparseMatrix<double> spring_stiffness(const Mesh& mesh, const Depth& depth,
                                             const std::vector<Spring>& springs) {
  Triplets entries;
  for (const Spring& spring : springs) {
    require_input(spring.stiffness.allFinite() && spring.stiffness.minCoeff() >= 0, "springs at '",
                  spring.boundary, "' of '", mesh.name,
                  "': a stiffness must be a number >= 0, got (", spring.stiffness.x(), ", ",
                  spring.stiffness.y(), ')');
    const std::vector<Index> nodes = nodes_at(mesh, spring.boundary, spring.only_at, "spring");
    if (spring.only_at)
      add(nodes.front(), nodes.front(), spring.stiffness, entries);
    else
      add_along(mesh, depth, spring, entries);
  }
  Eigen::SparseMatrix<double> stiffness(2 * mesh.n_nodes(), 2 * mesh.n_nodes());
  stiffness.setFromTriplets(entries.begin(), entries.end());
  return stiffness;
}

// A spring matrix \f$ k \f$ acts on all components, held ones too. Of the row of a free
// component i, free columns go into K. A held column j with the given displacement
// \f$ \bar u_j \f$ is known, so \f$ -k_{ij}\bar u_j \f$ goes into p. With \f$ k_{ij} = 2 \f$
// and \f$ \bar u_j = 0.5 \f$ the load of i becomes smaller by 1. Rows of held components
// belong to supports.
void add_springs(const BodyModel& body, QuadraticProgramme& programme) {
  const auto number = [&body](Index component) {
    const Index own = body.unknowns.number(component / 2, component % 2);
    return own < 0 ? own : body.first_unknown + own;
  };
  for (Index k = 0; k < body.springs.outerSize(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator it(body.springs, k); it; ++it) {
      const Index row = number(it.row());
      const Index column = number(it.col());
      if (row < 0) continue;
      if (column >= 0)
        programme.stiffness.coeffRef(row, column) += it.value();
      else
        programme.load(row) -= it.value() * body.unknowns.held(it.col() / 2, it.col() % 2);
    }
}

}  // namespace signorini
