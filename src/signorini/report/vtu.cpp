// # Files for viewers
//
// A viewer such as ParaView reads a mesh as arrays: points, the points of each cell, and numbers at
// points and at cells. A VTU file holds them as text, in digits
// that anyone can look at, so that two files can be compared line by line:
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

#include <iomanip>
#include <sstream>
#include <utility>

#include "signorini/fem/stress.hpp"
#include "signorini/report/nodal_fields.hpp"
#include "signorini/report/results.hpp"
#include "signorini/report/xml.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Rows = FieldRows;

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

// Two triangles and a quadrilateral, of the nodes 0 to 5, are
//
//     connectivity 0 1 2  0 2 3  1 4 5 2     offsets 3 6 10     types 5 5 9
//
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

// Nodes of all bodies are numbered one after the other, and so are cells here.
/// What all bodies have at their nodes and cells, one body after the other.
struct Fields {
  Rows points, displacement, stress, mises;  // of nodes
  Rows cell_stress, body;                    // of cells
};

// Stresses come twice: the mean of each cell, and smoothed at the nodes, which looks better and
// hides jumps. Where two bodies meet each has nodes of its own, so that nothing is smoothed across a
// contact.
Fields fields_of(const Model& model, const Solution& solution) {
  const Index nodes = count_nodes(model.bodies);
  Index cells = 0;
  for (const BodyModel& body : model.bodies) cells += body.mesh.n_cells();
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

// The order is that of the format: what is at points, what is in cells, then points and cells
// themselves. The attribute `Vectors` names the field that a viewer moves the points by.
void write_piece(std::ostream& out, const Model& model, const Fields& all,
                 const std::vector<NodalField>& contact) {
  out << "    <Piece NumberOfPoints=\"" << all.points.rows() << "\" NumberOfCells=\""
      << all.body.rows() << "\">\n      <PointData Vectors=\"displacement\">\n";
  write_array(out, "displacement", all.displacement, 3);
  write_array(out, "stress", all.stress, 4, reals, stress_parts);
  write_array(out, "von_mises", all.mises, 1);
  for (const NodalField& field : contact)
    write_array(out, field.name.c_str(), field.values, field.values.cols() > 1 ? 3 : 1,
                field.whole ? wholes : reals);
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
  const std::vector<NodalField> contact = nodal_fields(model, solution, totals);
  std::ostringstream out;
  out << std::setprecision(9) << "<?xml version=\"1.0\"?>\n";
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
