#include "signorini/report/vtu.hpp"

#include <charconv>
#include <cmath>
#include <iomanip>
#include <iterator>
#include <sstream>
#include <utility>

#include "signorini/fem/stress.hpp"
#include "signorini/report/pair_columns.hpp"
#include "signorini/report/results.hpp"

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

/// The pair that stands for each node of all bodies: of several at one node the first with the largest force; -1
/// without one.
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

/// A field from values of the pairs; `other` where a node has no pair, or its pair no value.
NodalField at_nodes(const std::string& name, const Rows& of_pairs, const std::vector<Index>& pairs,
                    double other) {
  NodalField field{name, Rows::Constant(static_cast<Index>(pairs.size()), of_pairs.cols(), other)};
  for (std::size_t node = 0; node < pairs.size(); ++node)
    if (pairs[node] >= 0 && !std::isnan(of_pairs(pairs[node], 0)))
      field.values.row(static_cast<Index>(node)) = of_pairs.row(pairs[node]);
  return field;
}

/// Pressure along the normals, shear traction along the tangents.
Rows tractions(const Model& model, const Solution& solution) {
  const Pairs& pairs = model.pairs;
  Rows traction = solution.pressure.asDiagonal() * pairs.normal;
  const Eigen::VectorXd shear = shear_tractions(model, solution);
  traction.col(0) += shear.cwiseProduct(pairs.normal.col(1));
  traction.col(1) -= shear.cwiseProduct(pairs.normal.col(0));
  return traction;
}

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

/// Notes, and the names behind `contact_number` and `body`.
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

/// Characters that XML has for itself, and what stands for them.
constexpr std::pair<char, const char*> entities[] = {
    {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};

/// A text between quotation marks of XML.
std::string in_xml(const std::string& text) {
  std::string result;
  for (const char c : text) {
    std::string word(1, c);
    for (const auto& [letter, entity] : entities)
      if (c == letter) word = entity;
    result += word;
  }
  return result;
}

/// The value of an attribute of a tag, back from XML; empty without it.
std::string attribute(const std::string& tag, const std::string& name) {
  const std::size_t at = tag.find(' ' + name + "=\"");
  if (at == std::string::npos) return {};
  const std::size_t begin = at + name.size() + 3;
  std::string value = tag.substr(begin, tag.find('"', begin) - begin);
  for (std::size_t k = std::size(entities); k-- > 0;)
    for (std::size_t from = 0; (from = value.find(entities[k].second, from)) != std::string::npos;
         ++from)
      value.replace(from, std::char_traits<char>::length(entities[k].second), 1, entities[k].first);
  return value;
}

}  // namespace

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

void write_pvd(const std::filesystem::path& file, const std::vector<TimedFile>& files) {
  std::ostringstream out;
  out << std::setprecision(17)
      << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
         "byte_order=\"LittleEndian\">\n  <Collection>\n";
  for (const TimedFile& one : files)
    out << "    <DataSet timestep=\"" << one.time << "\" part=\"0\" file=\"" << in_xml(one.file)
        << "\"/>\n";
  out << "  </Collection>\n</VTKFile>\n";
  write_file(file, out.str());
}

std::vector<TimedFile> read_pvd(const std::string& content) {
  std::vector<TimedFile> files;
  std::istringstream lines(content);
  for (std::string tag; std::getline(lines, tag);) {
    const std::string time = attribute(tag, "timestep");
    TimedFile file{0, attribute(tag, "file")};
    const char* const end = time.data() + time.size();
    const auto [rest, failed] = std::from_chars(time.data(), end, file.time);
    if (failed == std::errc() && rest == end && !file.file.empty()) files.push_back(file);
  }
  return files;
}

}  // namespace signorini
