#include "addons/files/inp.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "addons/files/inp_boundaries.hpp"
#include "addons/files/inp_text.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/wording.hpp"

namespace signorini {
namespace {

using Whole = std::int64_t;
using InpPlaces = std::vector<std::size_t>;

class Maker {
 public:
  explicit Maker(InpRecords records) : file_(std::move(records)) {
    for (std::size_t k = 0; k < file_.in.nodes.size(); ++k)
      file_.tags.add(file_.in.nodes[k].tag, k);
    file_.tags.end(file_.in.name, "node", [&](std::size_t k) { return file_.in.nodes[k].line; });
    for (std::size_t k = 0; k < file_.in.cells.size(); ++k)
      file_.numbers.add(file_.in.cell_numbers[k], k);
    for (std::size_t k = 0; k < file_.in.lines.size(); ++k)
      file_.numbers.add(file_.in.line_numbers[k], file_.in.cells.size() + k);
    file_.numbers.end(file_.in.name, "element",
                      [&](std::size_t k) { return file_.element(k).line; });
    for (std::vector<GmshElement>* list : {&file_.in.cells, &file_.in.lines})
      for (GmshElement& one : *list) look_up_nodes(one);
    require_input(
        !file_.in.cells.empty(), file_.in.name,
        ":1: the file has no plane elements, such as CPS4, CPE8 or CAX6",
        file_.in.unread.empty() ? "" : text("; not read is, for example, ", unread().back()));
  }

  InpMeshes make(const std::vector<std::string>& wanted) {
    const std::vector<std::string> bodies = wanted.empty() ? bodies_of_file() : checked(wanted);
    file_.out.name = file_.in.name;
    file_.out.surface = "element set";
    file_.out.nodes = file_.in.nodes;
    file_.body_of.assign(file_.in.cells.size(), InpFile::none);
    GmshParts parts;
    for (const std::string& key : bodies) {
      add_body(key, wanted.size() > 1);
      if (wanted.size() > 1) parts["body"].push_back(file_.in.element_sets.at(key).name);
    }
    if (bodies.empty()) add_cells(all_cells(), 0, 0);
    add_boundaries(file_);
    InpMeshes made;
    made.meshes = meshes_of(file_.out, parts);
    made.unread = unread();
    made.further_sets = further_sets(bodies);
    made.notes = file_.in.notes;
    for (const InpThickness& one : file_.in.thicknesses) add_note(one, made.notes);
    return made;
  }

 private:
  void look_up_nodes(GmshElement& one) const {
    for (std::size_t k = 0; k < one.n_nodes; ++k) {
      const auto place = file_.tags.find(static_cast<Whole>(one.nodes[k]));
      require_input(place.has_value(), file_.in.name, ":", one.line,
                    ": the element refers to node ", one.nodes[k], ", which no *NODE has");
      one.nodes[k] = *place;
    }
  }

  [[nodiscard]] InpPlaces all_cells() const {
    InpPlaces all(file_.in.cells.size());
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
    return all;
  }

  /// The cells of an element set.
  InpPlaces cells_in(const std::string& key) {
    InpPlaces cells = file_.elements.of(key);
    cells.erase(std::lower_bound(cells.begin(), cells.end(), file_.in.cells.size()), cells.end());
    return cells;
  }

  /// The sets that are bodies by themselves: those with a section, or those that elements are put into where they stand.
  std::vector<std::string> bodies_of_file() {
    for (const std::vector<std::string>* keys : {&file_.in.sections, &file_.in.of_elements}) {
      std::vector<std::string> bodies;
      for (const std::string& key : *keys)
        if (file_.in.element_sets.count(key) != 0 && !cells_in(key).empty() &&
            std::find(bodies.begin(), bodies.end(), key) == bodies.end())
          bodies.push_back(key);
      if (!bodies.empty()) return bodies;
    }
    return {};
  }

  std::vector<std::string> checked(const std::vector<std::string>& wanted) {
    std::vector<std::string> keys, known;
    for (const auto& [key, set] : file_.in.element_sets)
      if (!cells_in(key).empty()) known.push_back(set.name);
    for (const std::string& name : wanted) {
      keys.push_back(inp_key(name));
      const bool there = file_.in.element_sets.count(keys.back()) != 0;
      require_input(there && !cells_in(keys.back()).empty(), file_.in.name,
                    ":1: there is no element set ", in_quotes(name),
                    there ? " with plane elements" : "",
                    known.empty() ? "; there is none" : suggestion(name, known));
    }
    return keys;
  }

  void add_body(const std::string& key, bool part) {
    const Whole tag = file_.out.groups.add(2, file_.in.element_sets.at(key).name);
    if (!part) ++body_;
    add_cells(cells_in(key), file_.out.groups.set_of({tag}), body_);
  }

  void add_cells(const InpPlaces& cells, std::size_t group, std::size_t body) {
    for (const std::size_t cell : cells) {
      require_input(file_.body_of[cell] == InpFile::none, file_.in.name, ":",
                    file_.in.cells[cell].line,
                    ": this element is in two bodies: name the sets that are meant");
      file_.body_of[cell] = body;
      file_.out.cells.push_back(file_.in.cells[cell]);
      file_.out.cells.back().groups = group;
    }
  }

  [[nodiscard]] std::vector<std::string> unread() const {
    std::vector<std::string> all;
    for (const auto& [what, line] : file_.in.unread)
      all.push_back(text(what, " (line ", line, ')'));
    return all;
  }

  std::vector<std::string> further_sets(const std::vector<std::string>& bodies) {
    std::vector<std::string> all;
    for (const auto& [key, set] : file_.in.element_sets) {
      const std::size_t count = cells_in(key).size();
      if (count > 0 && std::find(bodies.begin(), bodies.end(), key) == bodies.end())
        all.push_back(text(set.name, " (", count, count == 1 ? " cell)" : " cells)"));
    }
    return all;
  }

  /// Says of a thickness of cells of a body that it is not taken.
  void add_note(const InpThickness& thickness, std::vector<std::string>& notes) {
    const auto set = file_.in.element_sets.find(thickness.set);
    if (set == file_.in.element_sets.end()) return;
    const InpPlaces cells = cells_in(thickness.set);
    if (std::all_of(cells.begin(), cells.end(),
                    [&](std::size_t cell) { return file_.body_of[cell] == InpFile::none; }))
      return;
    notes.push_back(
        text("the section of '", set->second.name, "' has the thickness ", thickness.value,
             " (line ", thickness.line,
             "), which is not taken: give the material of the body thickness = ", thickness.value));
  }

  InpFile file_;
  std::size_t body_ = 0;
};

}  // namespace

InpMeshes parse_inp(std::string_view content, const std::string& name,
                    const std::vector<std::string>& sets) {
  return Maker(inp_records(content, name)).make(sets);
}

InpMeshes read_inp(const std::filesystem::path& file, const std::vector<std::string>& sets) {
  return parse_inp(file_content(file, largest_gmsh_file), file.string(), sets);
}

bool is_inp(std::string_view content) {
  InpText in(content, "");
  try {
    return in.next() && !in.keyword().empty() && in.keyword() != "KEYWORD";
  } catch (const ProblemError&) {
    return false;
  }
}

}  // namespace signorini
