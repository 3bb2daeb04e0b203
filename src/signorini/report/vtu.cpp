// # Files for viewers
//
// A viewer such as ParaView reads a mesh as arrays: points, the points of each cell, and numbers at
// points and at cells. A VTU file holds them as text:
//
//     <VTKFile type="UnstructuredGrid" ...>
//       <UnstructuredGrid>
//         <FieldData> notes, names of contacts and bodies </FieldData>
//         <Piece NumberOfPoints="9" NumberOfCells="4">
//           <PointData> displacement, stress, contact_pressure, ... </PointData>
//           <CellData> cell_stress </CellData>
//           <Points> ... </Points>
//           <Cells> connectivity, offsets, types </Cells>
//         </Piece>
//
// Each body is a piece. The points are those of the mesh as it was: a viewer adds the
// displacements, enlarged as much as one likes.

#include "signorini/report/vtu.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

#include "signorini/fem/stress.hpp"
#include "signorini/report/pair_columns.hpp"
#include "signorini/report/results.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// One data array, a line per row of `values`, filled up with zeros to `components` numbers.
// A row of numbers is a line, so that a file can be compared with another.
// VTK knows vectors of three numbers only, so those of the plane get a zero.
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

// Cells of different sizes stand in one list. Offsets say where each ends, types what it is.
// A triangle is of type 5, a quadrilateral of type 9; with nodes on their sides they are 22 and 23.
void write_cells(std::ostream& out, const Mesh& mesh) {
  // VTK's numbers for triangles and quadrilaterals.
  constexpr int linear[] = {5, 9};
  constexpr int quadratic[] = {22, 23};
  const bool is_linear = mesh.order() == MeshOrder::Linear;
  out << "      <Cells>\n        <DataArray type=\"Int64\" Name=\"connectivity\" "
         "format=\"ascii\">\n";
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    out << mesh.cells.row(cell).head(mesh.cell_size(cell)) << '\n';
  out << "        </DataArray>\n        <DataArray type=\"Int64\" Name=\"offsets\" "
         "format=\"ascii\">\n";
  Index end = 0;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) out << (end += mesh.cell_size(cell)) << '\n';
  out << "        </DataArray>\n        <DataArray type=\"UInt8\" Name=\"types\" "
         "format=\"ascii\">\n";
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    out << (is_linear ? linear : quadratic)[mesh.corners(cell) - 3] << '\n';
  out << "        </DataArray>\n      </Cells>\n";
}

// The pair that stands for each node of all bodies: of several at one node the first with the largest force; -1
// without one.
// Contact happens at pairs, a picture shows nodes. A node where several contacts meet can show only
// one of them: the one with the largest force.
std::vector<Index> pairs_at_nodes(const Model& model, const Solution& solution) {
  std::vector<Index> found(static_cast<std::size_t>(model.unknowns.number.rows()), -1);
  const Eigen::VectorXd& force = solution.contact.force;
  for (Index pair = 0; pair < force.size(); ++pair) {
    const Index node = model.pairs.node[static_cast<std::size_t>(pair)];
    if (node < 0) continue;
    Index& known = found[static_cast<std::size_t>(node)];
    if (known < 0 || force(pair) > force(known)) known = pair;
  }
  return found;
}

/// What contact did at the nodes of all bodies.
struct NodalField {
  std::string name;
  Rows values;
};

// A field from values of the pairs; `other` where a node has no pair, or its pair no value.
// Nodes without a pair show a number that means nothing happened: 0 for a pressure, -1 for a
// status, where 0 means open.
NodalField at_nodes(const std::string& name, const Rows& of_pairs, const std::vector<Index>& pairs,
                    double other) {
  NodalField field{name, Rows::Constant(static_cast<Index>(pairs.size()), of_pairs.cols(), other)};
  for (std::size_t node = 0; node < pairs.size(); ++node)
    if (pairs[node] >= 0 && !std::isnan(of_pairs(pairs[node], 0)))
      field.values.row(static_cast<Index>(node)) = of_pairs.row(pairs[node]);
  return field;
}

/// Pressure along the normals, shear traction along the tangents.
// The traction on the source: pressure along the normal, which points out of the target, and shear
// along the tangent \f$ (n_y, -n_x) \f$.
// With friction \f$ \mu = 0 \f$ the shear is zero, and the arrows stand on the boundary at right
// angles.
Rows tractions(const Model& model, const Solution& solution) {
  const Pairs& pairs = model.pairs;
  Rows traction = solution.pressure.asDiagonal() * pairs.normal;
  const Eigen::VectorXd shear = shear_tractions(model, solution);
  traction.col(0) += shear.cwiseProduct(pairs.normal.col(1));
  traction.col(1) -= shear.cwiseProduct(pairs.normal.col(0));
  return traction;
}

// Which fields there are is decided by the columns of pairs: every column that has a name for
// viewers becomes one.
// The traction is a vector and no column, so it is added here.
std::vector<NodalField> nodal_fields(const Model& model, const Solution& solution,
                                     const std::vector<PairColumn>& columns) {
  const std::vector<Index> pairs = pairs_at_nodes(model, solution);
  std::vector<NodalField> fields;
  for (const PairColumn& column : columns)
    if (!column.field.empty())
      fields.push_back(at_nodes(column.field, column.values, pairs, column.words.empty() ? 0 : -1));
  if (solution.pressure.size() > 0)
    fields.push_back(at_nodes("contact_traction", tractions(model, solution), pairs, 0));
  return fields;
}

/// Lines of text: VTK wants the numbers of the characters of each, with a zero behind them.
void write_lines(std::ostream& out, const char* name, const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  out << "      <DataArray type=\"String\" Name=\"" << name << "\" NumberOfTuples=\""
      << lines.size() << "\" format=\"ascii\">\n";
  for (const std::string& line : lines) {
    for (const char c : line) out << static_cast<int>(static_cast<unsigned char>(c)) << ' ';
    out << "0\n";
  }
  out << "      </DataArray>\n";
}

// Notes, and the names behind `contact_number` and `body`.
// Arrays at points and cells hold numbers. So contacts and bodies are numbered in the fields, and
// their names stand once, in front of the pieces.
void write_field_data(std::ostream& out, const Model& model, const Solution& solution) {
  const bool several = model.contacts.size() > 1;
  std::vector<std::string> bodies;
  if (model.bodies.size() > 1)
    for (const BodyModel& body : model.bodies) bodies.push_back(body.mesh.name);
  if (solution.notes.empty() && !several && bodies.empty()) return;
  out << "    <FieldData>\n";
  write_lines(out, "notes", solution.notes);
  if (several) write_lines(out, "contacts", model.contacts);
  write_lines(out, "bodies", bodies);
  out << "    </FieldData>\n";
}

/// \param number  of the body; < 0 where there is only one
// Stresses come twice: the mean of each cell, and smoothed at the nodes, which looks better and
// hides jumps.
// The nodes of all bodies are numbered one after the other, and each body takes its part of the
// fields of contact.
void write_body(std::ostream& out, const BodyModel& body, Index number,
                const NodeArray& displacements, const std::vector<NodalField>& contact) {
  const Mesh& mesh = body.mesh;
  const Index n_nodes = mesh.n_nodes();
  const StressArray stress = nodal_stress(mesh, body.element, body.material, displacements);
  Eigen::VectorXd mises(n_nodes);
  for (Index node = 0; node < n_nodes; ++node)
    mises(node) = von_mises(stress.row(node).transpose());
  out << "    <Piece NumberOfPoints=\"" << n_nodes << "\" NumberOfCells=\"" << mesh.n_cells()
      << "\">\n      <PointData Vectors=\"displacement\">\n";
  write_array(out, "displacement", displacements, 3);
  write_array(out, "stress", stress, 4);
  write_array(out, "von_mises", mises, 1);
  for (const NodalField& field : contact)
    write_array(out, field.name.c_str(), field.values.middleRows(body.first_node, n_nodes),
                field.values.cols() > 1 ? 3 : 1);
  out << "      </PointData>\n      <CellData>\n";
  write_array(out, "cell_stress", cell_stress(mesh, body.element, body.material, displacements), 4);
  if (number >= 0)
    write_array(out, "body", Rows::Constant(mesh.n_cells(), 1, static_cast<double>(number)), 1);
  out << "      </CellData>\n      <Points>\n";
  write_array(out, "points", mesh.nodes, 3);
  out << "      </Points>\n";
  write_cells(out, mesh);
  out << "    </Piece>\n";
}

}  // namespace

// Nine digits are more than a viewer shows, and keep the files small.
void write_vtu(const std::filesystem::path& file, const Model& model, const Solution& solution,
               const std::optional<PathTotals>& totals) {
  const std::vector<NodalField> contact =
      nodal_fields(model, solution, pair_columns(model, solution, totals));
  std::ostringstream out;
  out << std::setprecision(9);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
         "byte_order=\"LittleEndian\">\n  <UnstructuredGrid>\n";
  write_field_data(out, model, solution);
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    write_body(out, model.bodies[b], model.bodies.size() > 1 ? static_cast<Index>(b) : -1,
               solution.displacements[b], contact);
  out << "  </UnstructuredGrid>\n</VTKFile>\n";
  write_file(file, out.str());
}

}  // namespace signorini
