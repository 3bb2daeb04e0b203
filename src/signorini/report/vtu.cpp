// # Files for viewers
//
// A viewer such as ParaView reads a mesh as arrays: points, the points of each cell, and numbers at
// points and at cells. A VTU file holds them as text:
//
//     <!-- note: ... -->
//     <VTKFile type="UnstructuredGrid" ...>
//       <UnstructuredGrid>
//         <FieldData> names of contacts and bodies </FieldData>
//         <Piece NumberOfPoints="9" NumberOfCells="4">
//           <PointData> displacement, stress, contact_pressure, ... </PointData>
//           <CellData> cell_stress </CellData>
//           <Points> ... </Points>
//           <Cells> connectivity, offsets, types </Cells>
//         </Piece>
//
// Not every reader knows arrays of text. So notes are comments, and a name is that of an array.
//
// All bodies are one piece, as some readers keep the last piece only. The points are those of the
// mesh as it was: a viewer adds the displacements, enlarged as much as one likes.

#include "signorini/report/vtu.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

#include "signorini/fem/stress.hpp"
#include "signorini/report/pair_columns.hpp"
#include "signorini/report/results.hpp"
#include "signorini/report/xml.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// What an array holds, in the words of VTK.
const char* const reals = "Float64";
const char* const wholes = "Int64";
const std::vector<const char*> stress_parts = {"xx", "yy", "xy", "zz"};

// One data array, a line per row of `values`, filled up with zeros to `components` numbers.
// A row of numbers is a line, so that a file can be compared with another.
// VTK knows vectors of three numbers only, so those of the plane get a zero.
void write_array(std::ostream& out, const char* name, const Rows& values, Index components,
                 const char* type = reals, const std::vector<const char*>& parts = {}) {
  out << "        <DataArray type=\"" << type << "\" Name=\"" << name
      << "\" NumberOfComponents=\"" << components << '"';
  for (std::size_t k = 0; k < parts.size(); ++k)
    out << " ComponentName" << k << "=\"" << parts[k] << '"';
  out << " format=\"ascii\">\n";
  for (Index row = 0; row < values.rows(); ++row) {
    for (Index k = 0; k < components; ++k)
      out << (k == 0 ? "" : " ") << (k < values.cols() ? values(row, k) : 0.0);
    out << '\n';
  }
  out << "        </DataArray>\n";
}

// Cells of different sizes stand in one list. Offsets say where each ends, types what it is.
// A triangle is of type 5, a quadrilateral of type 9; with nodes on their sides they are 22 and 23.
void write_cells(std::ostream& out, const std::vector<BodyModel>& bodies) {
  // VTK's numbers for triangles and quadrilaterals.
  constexpr int linear[] = {5, 9};
  constexpr int quadratic[] = {22, 23};
  std::ostringstream nodes, offsets, types;
  Index end = 0;
  for (const BodyModel& body : bodies)
    for (Index cell = 0; cell < body.mesh.n_cells(); ++cell) {
      const Index size = body.mesh.cell_size(cell);
      const bool is_linear = body.mesh.order() == MeshOrder::Linear;
      nodes << (body.mesh.cells.row(cell).head(size).array() + body.first_node) << '\n';
      offsets << (end += size) << '\n';
      types << (is_linear ? linear : quadratic)[body.mesh.corners(cell) - 3] << '\n';
    }
  const auto write = [&out](const char* type, const char* name, const std::ostringstream& lines) {
    out << "        <DataArray type=\"" << type << "\" Name=\"" << name
        << "\" format=\"ascii\">\n" << lines.str() << "        </DataArray>\n";
  };
  out << "      <Cells>\n";
  write("Int64", "connectivity", nodes);
  write("Int64", "offsets", offsets);
  write("UInt8", "types", types);
  out << "      </Cells>\n";
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
  const char* type = reals;
};

// A field from values of the pairs; `other` where a node has no pair, or its pair no value.
// Nodes without a pair show a number that means nothing happened: 0 for a pressure, -1 for a
// status, where 0 means open.
NodalField at_nodes(const std::string& name, const Rows& of_pairs, const std::vector<Index>& pairs,
                    double other, const char* type = reals) {
  NodalField field{
      name, Rows::Constant(static_cast<Index>(pairs.size()), of_pairs.cols(), other), type};
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
      fields.push_back(column.words.empty()
                           ? at_nodes(column.field, column.values, pairs, 0)
                           : at_nodes(column.field, column.values, pairs, -1, wholes));
  if (solution.pressure.size() > 0)
    fields.push_back(at_nodes("contact_traction", tractions(model, solution), pairs, 0));
  return fields;
}

/// \param what  of which they are the names, "body" or "contact"
// Arrays at points and cells hold numbers. So contacts and bodies are numbered in the fields, and
// `body 0: lower` is the name of an array in front of the pieces, whose one entry is the number.
void write_names(std::ostream& out, const char* what, const std::vector<std::string>& names) {
  if (names.size() < 2) return;
  for (std::size_t k = 0; k < names.size(); ++k)
    out << "      <DataArray type=\"Int64\" Name=\"" << what << ' ' << k << ": " << in_xml(names[k])
        << "\" NumberOfTuples=\"1\" format=\"ascii\">" << k << "</DataArray>\n";
}

// One body needs no number, and neither does one contact. A file of such a scene has no field data.
void write_field_data(std::ostream& out, const Model& model) {
  std::vector<std::string> bodies;
  for (const BodyModel& body : model.bodies) bodies.push_back(body.mesh.name);
  if (model.contacts.size() < 2 && bodies.size() < 2) return;
  out << "    <FieldData>\n";
  write_names(out, "contact", model.contacts);
  write_names(out, "body", bodies);
  out << "    </FieldData>\n";
}

/// What all bodies have at their nodes and cells, one body after the other.
struct Fields {
  Rows points, displacement, stress, mises;  // of nodes
  Rows cell_stress, body;                    // of cells
};

// Stresses come twice: the mean of each cell, and smoothed at the nodes, which looks better and
// hides jumps.
Fields fields_of(const Model& model, const Solution& solution) {
  Index nodes = 0, cells = 0;
  for (const BodyModel& body : model.bodies) {
    nodes += body.mesh.n_nodes();
    cells += body.mesh.n_cells();
  }
  Fields all{Rows(nodes, 2), Rows(nodes, 2), Rows(nodes, 4), Rows(nodes, 1),
             Rows(cells, 4), Rows(cells, 1)};
  Index first_cell = 0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    const Mesh& mesh = body.mesh;
    const NodeArray& u = solution.displacements[b];
    const auto own = [&](Rows& of) { return of.middleRows(body.first_node, mesh.n_nodes()); };
    own(all.points) = mesh.nodes;
    own(all.displacement) = u;
    own(all.stress) = nodal_stress(mesh, body.element, body.material, u);
    all.cell_stress.middleRows(first_cell, mesh.n_cells()) =
        cell_stress(mesh, body.element, body.material, u);
    all.body.middleRows(first_cell, mesh.n_cells()).setConstant(static_cast<double>(b));
    first_cell += mesh.n_cells();
  }
  for (Index node = 0; node < nodes; ++node)
    all.mises(node) = von_mises(all.stress.row(node).transpose());
  return all;
}

void write_piece(std::ostream& out, const Model& model, const Fields& all,
                 const std::vector<NodalField>& contact) {
  out << "    <Piece NumberOfPoints=\"" << all.points.rows() << "\" NumberOfCells=\""
      << all.body.rows() << "\">\n      <PointData Vectors=\"displacement\">\n";
  write_array(out, "displacement", all.displacement, 3);
  write_array(out, "stress", all.stress, 4, reals, stress_parts);
  write_array(out, "von_mises", all.mises, 1);
  for (const NodalField& field : contact)
    write_array(out, field.name.c_str(), field.values, field.values.cols() > 1 ? 3 : 1, field.type);
  out << "      </PointData>\n      <CellData>\n";
  write_array(out, "cell_stress", all.cell_stress, 4, reals, stress_parts);
  if (model.bodies.size() > 1) write_array(out, "body", all.body, 1, wholes);
  out << "      </CellData>\n      <Points>\n";
  write_array(out, "points", all.points, 3);
  out << "      </Points>\n";
  write_cells(out, model.bodies);
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
  out << "<?xml version=\"1.0\"?>\n";
  for (const std::string& note : solution.notes)
    out << "<!-- note: " << in_xml_comment(note) << " -->\n";
  out << "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
         "byte_order=\"LittleEndian\">\n  <UnstructuredGrid>\n";
  write_field_data(out, model);
  write_piece(out, model, fields_of(model, solution), contact);
  out << "  </UnstructuredGrid>\n</VTKFile>\n";
  write_file(file, out.str());
}

}  // namespace signorini
