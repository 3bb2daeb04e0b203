#include "addons/files/gmsh_records.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "addons/files/other_kind.hpp"
#include "signorini/core/errors.hpp"

namespace signorini {
namespace {

using Whole = std::int64_t;
constexpr Whole any = GmshText::largest_tag;

/// What to change so that Gmsh writes no elements of this type.
std::string way_out(Whole type) {
  static const std::set<Whole> solids = {4,  5,  6,  7,  11, 12, 13, 14,
                                         17, 18, 19, 29, 30, 31, 92, 93};
  if (type == 10)
    return "quadrilaterals of 9 nodes (type 10) are not read; set Mesh.SecondOrderIncomplete = 1 "
           "to get those of 8";
  if (solids.count(type) != 0)
    return text("solids (type ", type,
                ") are not read; mesh in the plane only (gmsh -2) and put surfaces, not volumes, "
                "into physical groups");
  return text("expected points, lines, triangles and quadrilaterals of 2 or 3 nodes per side, got ",
              "element type ", type, "; set Mesh.ElementOrder to 1 or 2");
}

/// What an element of a type is.
struct ElementKind {
  int dimension;
  std::size_t corners, nodes;
};

class SectionReader {
 public:
  SectionReader(std::string_view content, const std::string& name) : in_(content, name) {
    out_.name = name;
  }

  GmshRecords read() {
    while (in_.next_line()) {
      const std::string section(in_.word());
      if (section.front() != '$') continue;  // a remark between sections
      in_.expect_end_of_line("the name of a section");
      read_section(section);
    }
    for (const char* needed : {"$MeshFormat", "$Nodes", "$Elements"})
      if (seen_.count(needed) == 0)
        in_.fail(text("expected a section '", needed, "', got the end of the file; save the mesh, ",
                      "with Mesh.SaveParametric = 0"));
    resolve_nodes();
    return std::move(out_);
  }

 private:
  void read_section(const std::string& section) {
    using Member = void (SectionReader::*)();
    static const std::map<std::string, Member> members = {
        {"$MeshFormat", &SectionReader::read_format},
        {"$PhysicalNames", &SectionReader::read_names},
        {"$Entities", &SectionReader::read_entities},
        {"$Nodes", &SectionReader::read_nodes},
        {"$Elements", &SectionReader::read_elements}};
    if (section == "$PartitionedEntities")
      in_.fail("the mesh is divided for parallel computers; save it without partitions");
    if (section == "$NOD") in_.fail("version 1 is not read; set Mesh.MshFileVersion = 4.1");
    if (section.rfind("$End", 0) == 0) in_.fail("the beginning of a section", section);
    const std::string end = "$End" + section.substr(1);
    const auto member = members.find(section);
    if (member == members.end()) return skip_to(end);
    if (!seen_.insert(section).second) in_.fail("the section '" + section + "' comes twice");
    if (seen_.count("$MeshFormat") == 0) in_.fail("'$MeshFormat' as the first section", section);
    (this->*member->second)();
    in_.next_line();
    const std::string_view word = in_.word();
    if (word != end) in_.fail(text("expected '", end, "' after what was announced"), word);
    in_.expect_end_of_line("'" + end + "'");
  }

  void skip_to(const std::string& end) {
    while (in_.next_line())
      if (in_.word() == end) return;
    in_.fail(text("expected '", end.substr(0, 40), "', got the end of the file", GmshText::again));
  }

  void read_format() {
    in_.next_line();
    const double version = in_.number(in_.word(), "version of the format");
    if (version != 2.2 && version != 4.1)
      in_.fail(
          text("expected version 2.2 or 4.1, got ", version, "; set Mesh.MshFileVersion = 4.1"));
    version_4_ = version == 4.1;
    if (in_.next("file type", 0, 1) == 1)
      in_.fail("expected a file written as text, got a binary one; set Mesh.Binary = 0");
    in_.next("size of a number", 1, 64);
    in_.expect_end_of_line("version, file type and size");
  }

  void read_names() { out_.groups.read_names(in_); }
  void read_entities() {
    if (!version_4_) in_.fail("'$Entities' belongs to version 4.1, the file says 2.2");
    if (seen_.count("$Elements") != 0) in_.fail("'$Entities' must stand before '$Elements'");
    out_.groups.read_entities(in_);
  }

  /// x, y and z, the last two on this line.
  void read_position(GmshNode& node, std::string_view x) {
    node.line = in_.line();
    node.position[0] = in_.number(x, "x");
    node.position[1] = in_.number(in_.word(), "y");
    node.position[2] = in_.number(in_.word(), "z");
  }

  void read_nodes() {
    if (version_4_) return read_node_blocks();
    const Whole count = in_.counts({"number of nodes"}).front();
    for (Whole k = 0; k < count; ++k) {
      GmshNode node;
      node.tag = in_.whole(in_.first_word("nodes", k, count), "node tag", 1, any);
      read_position(node, in_.word());
      in_.expect_end_of_line("tag, x, y, z of a node");
      out_.nodes.push_back(node);
    }
  }

  /// Version 4.1: the nodes of an entity stand together, first their tags, then their positions.
  void read_node_blocks() {
    const auto counts =
        in_.counts({"number of blocks", "number of nodes", "smallest tag", "largest tag"});
    for (Whole block = 0; block < counts[0]; ++block) {
      const auto dimension = static_cast<int>(
          in_.whole(in_.first_word("blocks of nodes", block, counts[0]), "dimension", 0, 3));
      in_.next("entity tag", -any, any);
      const bool parametric = in_.next("parametric", 0, 1) == 1;
      const Whole size = in_.next("number of nodes");
      in_.expect_end_of_line("the head of a block");
      const std::size_t first = out_.nodes.size();
      for (Whole k = 0; k < size; ++k) {
        GmshNode node;
        node.tag = in_.whole(in_.first_word("node tags", k, size), "node tag", 1, any);
        in_.expect_end_of_line("a node tag");
        out_.nodes.push_back(node);
      }
      for (std::size_t k = first; k < out_.nodes.size(); ++k) {
        const auto done = static_cast<Whole>(k - first);
        read_position(out_.nodes[k], in_.first_word("positions", done, size));
        for (int u = 0; parametric && u < dimension; ++u) in_.word();
        in_.expect_end_of_line("the position of a node");
      }
    }
    expect_sum("nodes", counts[1], out_.nodes.size());
  }

  /// Checks what a section announced for all its blocks together.
  void expect_sum(const char* things, Whole announced, std::size_t got) const {
    if (static_cast<Whole>(got) != announced)
      in_.fail(
          text("expected ", announced, ' ', things, " in all blocks, got ", got, GmshText::again));
  }

  void read_elements() {
    if (version_4_) return read_element_blocks();
    const Whole count = in_.counts({"number of elements"}).front();
    for (Whole k = 0; k < count; ++k) {
      static_cast<void>(in_.whole(in_.first_word("elements", k, count), "element tag", 0, any));
      const Whole type = in_.next("element type");
      std::vector<Whole> groups;
      const Whole tags = in_.next("number of tags");
      for (Whole tag = 0; tag < tags; ++tag) {  // the first is the physical group, 0 for none
        const Whole value = in_.next("tag", -INT32_MAX, INT32_MAX);
        if (tag == 0 && value != 0) groups.push_back(value);
      }
      read_element(type, out_.groups.set_of(std::move(groups)));
    }
  }

  /// Version 4.1: the elements of an entity that are of one type stand together.
  void read_element_blocks() {
    const auto counts =
        in_.counts({"number of blocks", "number of elements", "smallest tag", "largest tag"});
    std::size_t got = 0;
    for (Whole block = 0; block < counts[0]; ++block) {
      const auto dimension = static_cast<int>(
          in_.whole(in_.first_word("blocks of elements", block, counts[0]), "dimension", 0, 3));
      const Whole entity = in_.next("entity tag", -any, any);
      const Whole type = in_.next("element type");
      const Whole size = in_.next("number of elements");
      in_.expect_end_of_line("the head of a block");
      if (dimension != kind_of(type).dimension)
        in_.fail(text("elements of type ", type, " cannot be of dimension ", dimension));
      const std::size_t groups = out_.groups.set_of(in_, dimension, entity);
      for (Whole k = 0; k < size; ++k, ++got) {
        static_cast<void>(in_.whole(in_.first_word("elements", k, size), "element tag", 0, any));
        read_element(type, groups);
      }
    }
    expect_sum("elements", counts[1], got);
  }

  /// The nodes of an element, the rest of its line.
  void read_element(Whole type, std::size_t groups) {
    GmshElement element;
    const ElementKind kind = kind_of(type);
    element.corners = kind.corners;
    element.n_nodes = kind.nodes;
    element.groups = groups;
    element.line = in_.line();
    for (std::size_t k = 0; k < kind.nodes; ++k)  // resolve_nodes() puts numbers in their place
      element.nodes[k] = static_cast<std::size_t>(in_.next("node tag", 1));
    in_.expect_end_of_line("the nodes of the element");
    if (kind.dimension > 0) (kind.dimension == 1 ? out_.lines : out_.cells).push_back(element);
  }

  [[nodiscard]] ElementKind kind_of(Whole type) const {
    static const std::map<Whole, ElementKind> known = {
        {15, {0, 1, 1}}, {1, {1, 2, 2}}, {8, {1, 2, 3}}, {2, {2, 3, 3}},
        {9, {2, 3, 6}},  {3, {2, 4, 4}}, {16, {2, 4, 8}}};
    const auto found = known.find(type);
    if (found == known.end()) in_.fail(way_out(type));
    return found->second;
  }

  /// Puts the numbers of nodes in the place of their tags.
  void resolve_nodes() {
    std::vector<std::pair<Whole, std::size_t>> order;
    order.reserve(out_.nodes.size());
    for (const GmshNode& node : out_.nodes) order.emplace_back(node.tag, order.size());
    std::sort(order.begin(), order.end());
    for (std::size_t k = 1; k < order.size(); ++k)
      require_input(order[k].first != order[k - 1].first, out_.name, ":",
                    out_.nodes[order[k].second].line, ": node ", order[k].first,
                    " stands here and in line ", out_.nodes[order[k - 1].second].line,
                    "; give each its own tag");
    for (std::vector<GmshElement>* elements : {&out_.lines, &out_.cells})
      for (GmshElement& element : *elements)
        for (std::size_t k = 0; k < element.n_nodes; ++k) {
          const std::pair<Whole, std::size_t> wanted = {element.nodes[k], 0};
          const auto place = std::lower_bound(order.begin(), order.end(), wanted);
          require_input(place != order.end() && place->first == wanted.first, out_.name, ":",
                        element.line, ": the element refers to node ", wanted.first,
                        ", which '$Nodes' does not have", GmshText::again);
          element.nodes[k] = place->second;
        }
  }

  GmshText in_;
  GmshRecords out_;
  bool version_4_ = false;
  std::set<std::string> seen_;  // sections
};

}  // namespace

GmshRecords gmsh_records(std::string_view content, const std::string& name) {
  const std::string other = content.find("$MeshFormat") == content.npos ? other_kind(content) : "";
  require_input(other.empty(), name, ":1: this is ", other);
  return SectionReader(content, name).read();
}

}  // namespace signorini
