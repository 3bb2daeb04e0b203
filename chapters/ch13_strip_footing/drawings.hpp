// Mesh, stress and displacements of chapter 13, for figures 13.1 and 13.3.
#pragma once
#include "footing.hpp"
#include "signorini/core/results.hpp"
#include "signorini/elasticity/stress.hpp"
#include "signorini/report/field_csv.hpp"

namespace ch13 {

inline std::string undeformed(const Mesh& mesh) {
  return deformed_cells_csv(mesh, NodeArray::Zero(mesh.n_nodes(), 2),
                            VectorXd::Zero(mesh.n_cells()));
}

// The cells of a mesh with their middles at x < 6.5 and y > -8.5.
inline Mesh near_the_footing(const Mesh& mesh) {
  std::vector<Index> cells;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const Eigen::RowVector2d middle = cell_nodes(mesh, cell).colwise().mean();
    if (middle(0) < 6.5 && middle(1) > -8.5) cells.push_back(cell);
  }
  Mesh part = mesh;
  part.cells = mesh.cells(cells, Eigen::all).eval();
  return part;
}

// 10. A file per body: the mesh of 142 nodes; and per field, on a finer one.
inline void draw(const std::filesystem::path& folder, const SolvedScene& run,
                 const SolvedScene& finer) {
  const double times = 200;                                                        // displacements
  const std::vector<double> stresses = {-24, -18, -15, -12, -10, -8, -6, -4, -2};  // [kPa]
  const std::vector<double> across = {-3e-4, -2e-4, -1e-4, -5e-5, -1e-5, 1e-5, 5e-5, 1e-4};  // [m]
  const std::vector<double> down = {-3e-3, -2.5e-3, -2e-3, -1.5e-3, -1e-3, -5e-4};
  const char* parts[] = {"_footing.csv", ".csv"};
  for (std::size_t k = 0; k < 2; ++k) {
    const BodyModel& body = finer.model.bodies[k];
    const NodeArray& u = finer.solution.displacements[k];
    const StressArray stress = nodal_stress(body.mesh, body.element, body.material, u);
    const Mesh part = near_the_footing(body.mesh);
    const auto write = [&](const char* name, const std::string& csv) {
      write_file(folder / text("fig_13_", name, parts[k]), csv);
    };
    write("1", undeformed(run.model.bodies[k].mesh));
    write("3_mesh", undeformed(part));
    write("3", deformed_bands_csv(part, u, stress.col(1), stresses, times));
    write("3_x", deformed_bands_csv(part, u, u.col(0), across, times));
    write("3_y", deformed_bands_csv(part, u, u.col(1), down, times));
  }
}

// What one solution shows as stress at the edge: of nodes and of cells, in both bodies.
inline void edge_stress(const SolvedScene& run, Results& results) {
  const char* names[] = {"footing", "soil"};
  for (std::size_t k = 0; k < 2; ++k) {
    const BodyModel& body = run.model.bodies[k];
    const NodeArray& u = run.solution.displacements[k];
    Index corner = 0;
    (body.mesh.nodes.rowwise() - Eigen::RowVector2d(a, 0)).rowwise().norm().minCoeff(&corner);
    const double node = nodal_stress(body.mesh, body.element, body.material, u)(corner, 1);
    const double cell = cell_stress(body.mesh, body.element, body.material, u).col(1).minCoeff();
    results.add(text("edge_node_", names[k]), -node / q, "q");
    results.add(text("edge_cell_", names[k]), -cell / q, "q");
  }
}

}  // namespace ch13
