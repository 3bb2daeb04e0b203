#include "support/two_blocks.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "addons/programme/floating_programme.hpp"
#include "meshes/split.hpp"
#include "papers/solver_table.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/fem/assembly.hpp"
#include "meshes/block.hpp"
#include "signorini/fem/elements.hpp"
#include "support/meshes.hpp"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using namespace signorini;

namespace signorini_test {
namespace {

constexpr double width = 2;
constexpr double uniform = 3;  ///< the pressure
constexpr double poisson_ratio = 0.3;

struct Block {
  Mesh mesh;
  Material material;
  Unknowns unknowns;
  LinearSystem system;
};

/// Height of the interface above the lower edge of the lower block.
double interface_at(double x, double inclination) {
  return 1 + std::tan(inclination * pi / 180) * (x - 0.5 * width);
}

/// A block of three layers of cells between the curve below and the curve above it.
template <typename Below, typename Above>
Mesh layered(const char* name, Index edges, const Element& element, bool mixed, Below&& below,
             Above&& above) {
  BlockSpec spec;
  spec.name = name;
  spec.size = {width, 1};
  spec.cells_x = edges;
  spec.cells_y = 3;
  spec.order = order_of(element);
  const Mesh mesh = mapped(make_block(spec), [&](const Vector2d& x) -> Vector2d {
    return {x.x(), (1 - x.y()) * below(x.x()) + x.y() * above(x.x())};
  });
  std::vector<Index> cut;
  const Index step = element.corners() == 3 ? 1 : 2;
  for (Index cell = 0; cell < mesh.n_cells() && (step == 1 || mixed); cell += step)
    cut.push_back(cell);
  return split(mesh, cut);
}

Block make(Mesh mesh, const Element& element, double youngs_modulus,
           const std::vector<Support>& supports, const std::vector<std::string>& pressed) {
  Block block{std::move(mesh), {}, {}, {}};
  block.material.youngs_modulus = youngs_modulus;
  block.material.poisson_ratio = poisson_ratio;
  block.unknowns = number_unknowns(block.mesh, supports);
  Loads loads;
  for (const std::string& side : pressed) loads.edges.push_back({side, uniform, {}});
  block.system = assemble(block.mesh, element, block.material, block.unknowns, loads);
  return block;
}

/// K block diagonal, the loads one after the other, and A = -N in the columns of the unknowns.
DenseProgramme programme_of(const Block& target, const Block& source, const Pairs& pairs) {
  const Index n_target = target.unknowns.count;
  const Index n = n_target + source.unknowns.count;
  DenseProgramme programme;
  programme.stiffness = MatrixXd::Zero(n, n);
  programme.stiffness.topLeftCorner(n_target, n_target) = target.system.stiffness;
  programme.stiffness.bottomRightCorner(n - n_target, n - n_target) = source.system.stiffness;
  programme.load.resize(n);
  programme.load << target.system.load, source.system.load;
  programme.initial_gap = pairs.initial_gap;
  programme.A = MatrixXd::Zero(pairs.opening.rows(), n);
  const MatrixXd opening(pairs.opening);
  Index first_node = 0;
  Index first_unknown = 0;
  for (const Block* block : {&target, &source}) {
    for (Index node = 0; node < block->mesh.n_nodes(); ++node)
      for (Index axis = 0; axis < 2; ++axis)
        if (block->unknowns.number(node, axis) >= 0)
          programme.A.col(first_unknown + block->unknowns.number(node, axis)) =
              -opening.col(2 * (first_node + node) + axis);
    first_node += block->mesh.n_nodes();
    first_unknown += block->unknowns.count;
  }
  return programme;
}

/// The source moves up, and turns about the node that is held sideways.
MatrixXd rigid_motions(const Block& target, const Block& source, const Vector2d& pivot) {
  MatrixXd motions = MatrixXd::Zero(target.unknowns.count + source.unknowns.count, 2);
  for (Index node = 0; node < source.mesh.n_nodes(); ++node) {
    const Vector2d arm = source.mesh.nodes.row(node).transpose() - pivot;
    const Vector2d turn(-arm.y(), arm.x());
    for (Index axis = 0; axis < 2; ++axis) {
      const Index unknown = source.unknowns.number(node, axis);
      if (unknown < 0) continue;
      motions(target.unknowns.count + unknown, 0) = axis == 1 ? 1 : 0;
      motions(target.unknowns.count + unknown, 1) = turn(axis);
    }
  }
  return motions;
}

}  // namespace

PatchResult press_blocks(const GapOperator& gap_operator, const GapOptions& options,
                         const TwoBlocks& blocks) {
  const Element& own = find_element(blocks.element);
  const Element& other = blocks.target_element.empty() ? own : find_element(blocks.target_element);
  const auto level = [](double y) { return [y](double) { return y; }; };
  const auto sloped = [&](double x) { return interface_at(x, blocks.inclination); };
  // In-plane strain of the target: held about a place of the interface, this does not move.
  const double strain = -uniform * (1 + poisson_ratio) * (1 - 2 * poisson_ratio);
  const Block target =
      make(layered("lower", blocks.target_edges, other, blocks.mixed, level(0), sloped), other, 1,
           {prescribed("bottom", Axis::Y, -strain),
            prescribed_at("bottom", {0, 0}, Axis::X, -0.5 * width * strain)},
           {"left", "right"});
  const Vector2d pivot(0, 2);
  const Block source = make(
      layered("upper", blocks.source_edges, own, blocks.mixed, sloped, level(2)), own,
      blocks.stiffness_ratio, {prescribed_at("top", pivot, Axis::X)}, {"left", "right", "top"});
  GapOptions complete = options;
  complete.n_nodes = target.mesh.n_nodes() + source.mesh.n_nodes();
  PatchResult result;
  result.pairs = gap_operator.pair({source.mesh, "bottom", target.mesh.n_nodes()},
                                   {target.mesh, "top", 0}, complete);
  const FloatingSolution solution =
      solve(programme_of(target, source, result.pairs), rigid_motions(target, source, pivot),
            find_solver("quasi_active_set"));
  if (solution.dense.report.status != SolveStatus::Solved)
    throw std::runtime_error(std::string("two blocks: ") + to_string(solution.dense.report.status));
  result.exact = uniform;
  result.pressure = solution.dense.refined.force.cwiseQuotient(result.pairs.weight);
  result.deviation = (result.pressure.array() / uniform - 1).abs().maxCoeff();
  return result;
}

double patch_test(const GapOperator& gap_operator, const GapOptions& options, Index source_edges,
                  Index target_edges, double inclination, double stiffness_ratio,
                  const std::string& element) {
  return press_blocks(gap_operator, options,
                      {source_edges, target_edges, inclination, stiffness_ratio, element})
      .deviation;
}

}  // namespace signorini_test
