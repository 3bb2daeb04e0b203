#include "signorini/report/vtu.hpp"

#include <charconv>
#include <iomanip>
#include <iterator>
#include <sstream>
#include <utility>

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

/// What contact did at the nodes of all bodies.
struct NodalContact {
  Eigen::VectorXd pressure;
  Eigen::VectorXd gap;
  Eigen::VectorXd status;
};

NodalContact nodal_contact(const Model& model, const Solution& solution) {
  const Index n_nodes = model.unknowns.number.rows();
  NodalContact contact{Eigen::VectorXd::Zero(n_nodes), Eigen::VectorXd::Zero(n_nodes),
                       Eigen::VectorXd::Constant(n_nodes, -1)};
  for (Index pair = 0; pair < solution.pressure.size(); ++pair) {
    const Index node = model.pairs.node[static_cast<std::size_t>(pair)];
    if (node < 0) continue;
    contact.pressure(node) = solution.pressure(pair);
    contact.gap(node) = solution.contact.gap(pair);
    contact.status(node) = 0;
  }
  for (const Index pair : solution.contact.active)
    if (const Index node = model.pairs.node[static_cast<std::size_t>(pair)]; node >= 0)
      contact.status(node) = 1;
  return contact;
}

/// Notes as field data: VTK wants the numbers of the characters of each, with a zero behind them.
void write_notes(std::ostream& out, const std::vector<std::string>& notes) {
  if (notes.empty()) return;
  out << "    <FieldData>\n      <DataArray type=\"String\" Name=\"notes\" NumberOfTuples=\""
      << notes.size() << "\" format=\"ascii\">\n";
  for (const std::string& note : notes) {
    for (const char c : note) out << static_cast<int>(static_cast<unsigned char>(c)) << ' ';
    out << "0\n";
  }
  out << "      </DataArray>\n    </FieldData>\n";
}

void write_body(std::ostream& out, const BodyModel& body, const NodeArray& displacements,
                const NodalContact& contact) {
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
  write_array(out, "contact_pressure", contact.pressure.segment(body.first_node, n_nodes), 1);
  write_array(out, "contact_gap", contact.gap.segment(body.first_node, n_nodes), 1);
  write_array(out, "contact_status", contact.status.segment(body.first_node, n_nodes), 1);
  out << "      </PointData>\n      <CellData>\n";
  write_array(out, "cell_stress", cell_stress(mesh, body.element, body.material, displacements), 4);
  out << "      </CellData>\n      <Points>\n";
  write_array(out, "points", mesh.nodes, 3);
  out << "      </Points>\n";
  write_cells(out, mesh);
  out << "    </Piece>\n";
}

/// Characters that XML has for itself, and what stands for them.
constexpr std::pair<char, const char*> entities[] = {
    {'&', "&amp;"}, {'<', "&lt;"}, {'"', "&quot;"}};

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

void write_vtu(const std::filesystem::path& file, const Model& model, const Solution& solution) {
  require(solution.contact.report.status == Status::Solved,
          "write_vtu: the problem was not solved (", to_string(solution.contact.report.status),
          ')');
  const NodalContact contact = nodal_contact(model, solution);
  std::ostringstream out;
  out << std::setprecision(9);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
         "byte_order=\"LittleEndian\">\n  <UnstructuredGrid>\n";
  write_notes(out, solution.notes);
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    write_body(out, model.bodies[b], solution.displacements[b], contact);
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
