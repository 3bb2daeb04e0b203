#include "signorini/report/vtu.hpp"

#include <iomanip>
#include <sstream>

#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/elasticity/stress.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// One data array, a line per row of `values`, filled up with zeros to `components` numbers.
void write_array(std::ostream& out, const char* name, const Rows& values, Index components) {
  out << "        <DataArray type=\"Float64\" Name=\"" << name << "\" NumberOfComponents=\""
      << components << "\" format=\"ascii\">\n";
  for (Index row = 0; row < values.rows(); ++row) {
    for (Index k = 0; k < components; ++k)
      out << (k == 0 ? "" : " ") << (k < values.cols() ? values(row, k) : 0.0);
    out << '\n';
  }
  out << "        </DataArray>\n";
}

void write_cells(std::ostream& out, const Mesh& mesh) {
  constexpr int vtk_quad = 9;
  constexpr int vtk_quadratic_quad = 23;
  out << "      <Cells>\n        <DataArray type=\"Int64\" Name=\"connectivity\" "
         "format=\"ascii\">\n"
      << mesh.cells
      << "\n        </DataArray>\n        <DataArray type=\"Int64\" Name=\"offsets\" "
         "format=\"ascii\">\n";
  for (Index cell = 1; cell <= mesh.n_cells(); ++cell) out << cell * mesh.cells.cols() << '\n';
  out << "        </DataArray>\n        <DataArray type=\"UInt8\" Name=\"types\" "
         "format=\"ascii\">\n";
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    out << (mesh.cells.cols() == 4 ? vtk_quad : vtk_quadratic_quad) << '\n';
  out << "        </DataArray>\n      </Cells>\n";
}

}  // namespace

void write_vtu(const std::filesystem::path& file, const Model& model, const Solution& solution) {
  require(solution.contact.report.status == Status::Solved,
          "write_vtu: the problem was not solved (", to_string(solution.contact.report.status),
          ')');
  const Mesh& mesh = model.mesh;
  const StressArray stress =
      nodal_stress(mesh, model.element, model.material, solution.displacements);
  Eigen::VectorXd mises(mesh.n_nodes());
  for (Index node = 0; node < mesh.n_nodes(); ++node)
    mises(node) = von_mises(model.material, stress.row(node).transpose());
  Eigen::VectorXd pressure = Eigen::VectorXd::Zero(mesh.n_nodes());
  Eigen::VectorXd gap = Eigen::VectorXd::Zero(mesh.n_nodes());
  Eigen::VectorXd status = Eigen::VectorXd::Constant(mesh.n_nodes(), -1);
  for (Index pair = 0; pair < solution.pressure.size(); ++pair) {
    const Index node = model.gaps.node[static_cast<std::size_t>(pair)];
    pressure(node) = solution.pressure(pair);
    gap(node) = solution.contact.gap(pair);
    status(node) = 0;
  }
  for (const Index pair : solution.contact.active)
    status(model.gaps.node[static_cast<std::size_t>(pair)]) = 1;
  std::ostringstream out;
  out << std::setprecision(9);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
         "byte_order=\"LittleEndian\">\n"
      << "  <UnstructuredGrid>\n    <Piece NumberOfPoints=\"" << mesh.n_nodes()
      << "\" NumberOfCells=\"" << mesh.n_cells()
      << "\">\n      <PointData Vectors=\"displacement\">\n";
  write_array(out, "displacement", solution.displacements, 3);
  write_array(out, "stress", stress, 3);
  write_array(out, "von_mises", mises, 1);
  write_array(out, "contact_pressure", pressure, 1);
  write_array(out, "contact_gap", gap, 1);
  write_array(out, "contact_status", status, 1);
  out << "      </PointData>\n      <CellData>\n";
  write_array(out, "cell_stress",
              cell_stress(mesh, model.element, model.material, solution.displacements), 3);
  out << "      </CellData>\n      <Points>\n";
  write_array(out, "points", mesh.nodes, 3);
  out << "      </Points>\n";
  write_cells(out, mesh);
  out << "    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n";
  write_file(file, out.str());
}

}  // namespace signorini
