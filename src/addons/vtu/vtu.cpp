// # Files for viewers
//
// A viewer such as ParaView reads a mesh as arrays: points, the points of each cell, and numbers at
// points and at cells. A VTU file names them in text, and has the numbers themselves behind it:
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
//       </UnstructuredGrid>
//       <AppendedData encoding="raw"> _ numbers, byte by byte </AppendedData>
//
// Not every reader knows arrays of text. So notes are comments, and a name is that of an array.
//
// All bodies are one piece, as some readers keep the last piece only. The points are those of the
// mesh as it was: a viewer adds the displacements, enlarged as much as one likes.

#include "addons/vtu/vtu.hpp"

#include <cstdint>
#include <utility>

#include "addons/vtu/vtu_arrays.hpp"
#include "addons/vtu/xml.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/fem/von_mises.hpp"
#include "signorini/report/nodal_fields.hpp"
#include "signorini/report/results.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index;
using Rows = FieldRows;

const std::vector<const char*> stress_parts = {"xx", "yy", "xy", "zz"};

// Two triangles and a quadrilateral, of the nodes 0 to 5, are
//
//     connectivity 0 1 2  0 2 3  1 4 5 2     offsets 3 6 10     types 5 5 9
//
// Cells of different sizes stand in one list. Offsets say where each ends, types what it is.
// A triangle is of type 5, a quadrilateral of type 9; with nodes on their sides they are 22 and 23.
void write_cells(VtuArrays& out, const std::vector<BodyModel>& bodies) {
  // VTK's numbers for triangles and quadrilaterals.
  constexpr std::uint8_t linear[] = {5, 9};
  constexpr std::uint8_t quadratic[] = {22, 23};
  std::vector<std::int64_t> nodes, offsets;
  std::vector<std::uint8_t> types;
  for (const BodyModel& body : bodies)
    for (Index cell = 0; cell < body.mesh.n_cells(); ++cell) {
      const bool is_linear = body.mesh.order() == MeshOrder::Linear;
      for (Index k = 0; k < body.mesh.cell_size(cell); ++k)
        nodes.push_back(body.mesh.cells(cell, k) + body.first_node);
      offsets.push_back(static_cast<std::int64_t>(nodes.size()));
      types.push_back((is_linear ? linear : quadratic)[body.mesh.corners(cell) - 3]);
    }
  out.text() << "      <Cells>\n";
  out.list("connectivity", nodes);
  out.list("offsets", offsets);
  out.list("types", types);
  out.text() << "      </Cells>\n";
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
void write_piece(VtuArrays& out, const Model& model, const Fields& all,
                 const std::vector<NodalField>& contact) {
  out.text() << "    <Piece NumberOfPoints=\"" << all.points.rows() << "\" NumberOfCells=\""
             << all.body.rows() << "\">\n      <PointData Vectors=\"displacement\">\n";
  out.reals("displacement", all.displacement, 3);
  out.reals("stress", all.stress, 4, stress_parts);
  out.reals("von_mises", all.mises, 1);
  for (const NodalField& field : contact)
    if (field.whole)
      out.wholes(field.name.c_str(), field.values);
    else
      out.reals(field.name.c_str(), field.values, field.values.cols() > 1 ? 3 : 1);
  out.text() << "      </PointData>\n      <CellData>\n";
  out.reals("cell_stress", all.cell_stress, 4, stress_parts);
  if (model.bodies.size() > 1) out.wholes("body", all.body);
  out.text() << "      </CellData>\n      <Points>\n";
  out.reals("points", all.points, 3);
  out.text() << "      </Points>\n";
  write_cells(out, model.bodies);
  out.text() << "    </Piece>\n";
}

}  // namespace

void write_vtu(const std::filesystem::path& file, const Model& model, const Solution& solution,
               const std::optional<PathTotals>& totals, VtuNumbers numbers) {
  const std::vector<NodalField> contact = nodal_fields(model, solution, totals);
  VtuArrays out(numbers);
  out.text() << "<?xml version=\"1.0\"?>\n";
  for (const std::string& note : solution.notes)
    out.text() << "<!-- note: " << in_xml_comment(note) << " -->\n";
  out.text() << "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"" << byte_order()
             << "\" header_type=\"UInt64\">\n  <UnstructuredGrid>\n";
  write_field_data(out.text(), model);
  write_piece(out, model, fields_of(model, solution), contact);
  out.text() << "  </UnstructuredGrid>\n";
  write_file(file, out.content());
}

}  // namespace signorini
