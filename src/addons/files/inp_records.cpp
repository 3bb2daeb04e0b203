#include "addons/files/inp_records.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <functional>
#include <set>
#include <utility>

#include "addons/files/inp_elements.hpp"
#include "addons/files/inp_text.hpp"
#include "addons/files/other_kind.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/wording.hpp"

namespace signorini {
namespace {

using Whole = std::int64_t;
using Fields = std::vector<std::string_view>;
constexpr Whole largest_number = INT32_MAX;

class Reader {
 public:
  Reader(std::string_view content, const std::string& name) : in_(content, name) {
    out_.name = name;
  }

  InpRecords read() {
    while (in_.next()) {
      if (in_.keyword().empty()) {
        if (data_) data_(in_.fields());
      } else {
        end_element();
        read_keyword(in_.keyword());
      }
    }
    end_element();
    return std::move(out_);
  }

 private:
  void read_keyword(const std::string& keyword) {
    using Member = void (Reader::*)();
    static const std::map<std::string, Member> members = {
        {"NODE", &Reader::begin_nodes},
        {"ELEMENT", &Reader::begin_elements},
        {"NSET", &Reader::begin_node_set},
        {"ELSET", &Reader::begin_element_set},
        {"SURFACE", &Reader::begin_surface},
        {"SOLID SECTION", &Reader::begin_section},
        {"SHELL SECTION", &Reader::begin_section},
        {"MEMBRANE SECTION", &Reader::begin_section},
        {"PART", &Reader::begin_part},
        {"END PART", &Reader::end_part},
        {"INSTANCE", &Reader::begin_instance},
        {"END INSTANCE", &Reader::end_part}};
    static const std::set<std::string> passed = {"HEADING", "PREPRINT", "ASSEMBLY", "END ASSEMBLY"};
    data_ = {};
    const auto no = inp_refused().find(keyword);
    if (no != inp_refused().end()) in_.fail(text("*", keyword, " is not read: ", no->second));
    const auto member = members.find(keyword);
    if (member != members.end()) return (this->*member->second)();
    if (passed.count(keyword) == 0) out_.unread.emplace("*" + keyword, in_.line());
  }

  void refuse_input() const {
    if (in_.has("INPUT")) in_.fail("INPUT= is not read: put that file here");
  }

  /// A name with its place in front: that of the part, or the assembly.
  [[nodiscard]] std::string placed(const std::string& name, bool of_part) const {
    return (of_part ? part_ : "Assembly") + "." + name;
  }

  /// The key of a set of this name: of the part, or assembly, that the file is in, if that has one; else of any.
  [[nodiscard]] std::string key_of(const InpSets& sets, const std::string& name) const {
    std::string own = inp_key(in_part_ ? part_ : "Assembly") + "." + inp_key(name);
    return sets.count(own) != 0 ? own : inp_key(name);
  }

  /// A set of this name where the file is now. One of a part and one of the assembly are two: of element sets that of the part
  /// keeps the name, as it may be a body; of others that of the assembly does, as loads and supports name it.
  InpSet& set_named(InpSets& sets, const std::string& name) {
    InpSet wanted{name, {}, in_.line(), in_part_};
    std::string key = key_of(sets, name);
    const auto other = sets.find(key);
    if (other != sets.end() && other->second.of_part != in_part_) {
      note_two(sets, other->second, name);
      const bool keeps = &sets == &out_.element_sets ? in_part_ : !in_part_;
      if (keeps)
        put_in_place(sets, key);
      else
        key = inp_key(wanted.name = placed(name, in_part_));
    }
    return sets.try_emplace(key, std::move(wanted)).first->second;
  }

  /// Puts the place of a set in front of its name.
  void put_in_place(InpSets& sets, const std::string& key) {
    auto moved = sets.extract(key);
    InpSet& set = moved.mapped();
    set.name = placed(set.name, set.of_part);
    moved.key() = inp_key(set.name);
    rename(sets, key, moved.key());
    const std::string taken = set.name;
    if (!sets.insert(std::move(moved)).inserted)
      in_.fail(text("a name of its own: another set is called '", taken, "' already"), taken);
  }

  /// Calls a set by its new key wherever it is named so far; surfaces are named by nothing.
  void rename(const InpSets& sets, const std::string& key, const std::string& now) {
    if (&sets != &out_.node_sets && &sets != &out_.element_sets) return;
    const auto renamed = [&](std::string& name) {
      if (name == key) name = now;
    };
    const bool nodes = &sets == &out_.node_sets;
    for (InpSets* const all : {nodes ? &out_.node_sets : &out_.element_sets,
                               nodes ? &out_.node_surfaces : &out_.surfaces})
      for (auto& named : *all)
        for (InpEntry& entry : named.second.entries) renamed(entry.set);
    if (nodes) return;
    for (std::string& name : out_.sections) renamed(name);
    for (std::string& name : out_.of_elements) renamed(name);
    for (auto& one : out_.thicknesses) renamed(one.set);
  }

  void note_two(const InpSets& sets, const InpSet& other, const std::string& name) {
    const bool elements = &sets == &out_.element_sets;
    const char* const what = elements                   ? "element sets"
                             : &sets == &out_.node_sets ? "node sets"
                                                        : "surfaces";
    out_.notes.push_back(text("two ", what, " are called '", name, "', one of the part and one of ",
                              "the assembly (lines ", other.line, " and ", in_.line(), "): here '",
                              name, "' is that of the ", elements ? "part" : "assembly",
                              ", and the other one is '", placed(name, !elements), '\''));
  }

  void begin_nodes() {
    refuse_input();
    if (in_.has("SYSTEM") && inp_key(in_.value("SYSTEM")) != "R")
      in_.fail("SYSTEM= is not read: write nodes in x and y");
    InpSet* const set = in_.has("NSET") ? &set_named(out_.node_sets, in_.value("NSET")) : nullptr;
    data_ = [this, set](const Fields& fields) {
      GmshNode node;
      node.line = in_.line();
      node.tag = in_.whole(fields[0], "node number", 1, largest_number);
      if (fields.size() < 3) in_.fail("expected number, x and y of a node");
      for (std::size_t k = 0; k < 3 && k + 1 < fields.size(); ++k)
        if (!fields[k + 1].empty()) node.position[k] = in_.number(fields[k + 1], "coordinate");
      out_.nodes.push_back(node);
      if (set != nullptr) set->entries.push_back({node.tag, node.tag});
    };
  }

  void begin_elements() {
    refuse_input();
    type_ = inp_key(in_.value("TYPE"));
    read_as_ = inp_element_type(type_);
    wanted_ = read_as_.nodes;
    InpSet* set = nullptr;
    if (read_as_.corners > 2 && !in_.has("ELSET"))
      set = &set_named(out_.element_sets, text("block ", ++blocks_));
    if (in_.has("ELSET")) {
      set = &set_named(out_.element_sets, in_.value("ELSET"));
      const std::string key = key_of(out_.element_sets, in_.value("ELSET"));
      if (std::find(out_.of_elements.begin(), out_.of_elements.end(), key) ==
          out_.of_elements.end())
        out_.of_elements.push_back(key);
    }
    data_ = [this, set](const Fields& fields) {
      if (read_as_.corners == 0) {
        out_.unread.emplace("elements of type " + type_, in_.line());
        return;
      }
      if (numbers_.empty()) element_line_ = in_.line();
      if (read_as_.nodes == 0) wanted_ = fields.size() > 3 ? 3 : 2;
      for (const std::string_view field : fields)
        numbers_.push_back(in_.whole(field, "element or node number", 1, largest_number));
      if (numbers_.size() > wanted_) add_element(set);
    };
  }

  void add_element(InpSet* set) {
    if (numbers_.size() != wanted_ + 1)
      in_.fail(text("expected ", wanted_, " nodes of an element ", type_, ", got ",
                    numbers_.size() - 1));
    GmshElement element;
    element.corners = read_as_.corners;
    element.n_nodes = wanted_;
    element.line = element_line_;
    std::copy(numbers_.begin() + 1, numbers_.end(), element.nodes.begin());
    (read_as_.corners == 2 ? out_.lines : out_.cells).push_back(element);
    (read_as_.corners == 2 ? out_.line_numbers : out_.cell_numbers).push_back(numbers_[0]);
    if (read_as_.corners > 2) out_.first_sides.push_back(read_as_.first_side);
    if (set != nullptr) set->entries.push_back({numbers_[0], numbers_[0]});
    numbers_.clear();
  }

  /// Refuses an element of which nodes are missing.
  void end_element() {
    if (numbers_.empty()) return;
    in_.fail(text("the element of line ", element_line_, " has ", numbers_.size() - 1,
                  " nodes, and ", type_, " has ", wanted_));
  }

  void begin_node_set() {
    begin_set(set_named(out_.node_sets, in_.value("NSET")), out_.node_sets, "node");
  }
  void begin_element_set() {
    begin_set(set_named(out_.element_sets, in_.value("ELSET")), out_.element_sets, "element");
  }

  /// Reads the members of a set. \param sets  that they may name
  void begin_set(InpSet& set, const InpSets& sets, const std::string& what) {
    const bool range = in_.has("GENERATE");
    data_ = [this, &sets, &set, range, what](const Fields& fields) {
      if (!range) {
        for (const std::string_view field : fields)
          if (!field.empty()) set.entries.push_back(entry(sets, field, what));
        return;
      }
      InpEntry all;
      if (fields.size() < 2) in_.fail("expected first, last and step of GENERATE");
      all.first = in_.whole(fields[0], "first " + what, 1, largest_number);
      all.last = in_.whole(fields[1], "last " + what, 1, largest_number);
      if (fields.size() > 2 && !fields[2].empty()) all.step = in_.whole(fields[2], "step", 1, largest_number);
      set.entries.push_back(all);
    };
  }

  /// A number, or the name of a set.
  [[nodiscard]] InpEntry entry(const InpSets& sets, std::string_view field,
                               const std::string& what) const {
    if (!field.empty() && std::isdigit(static_cast<unsigned char>(field.front())) != 0) {
      if (field.size() > 2 && field.substr(field.size() - 2) == ".0")  // as meshio writes
        field.remove_suffix(2);
      const Whole number = in_.whole(field, what + " number", 1, largest_number);
      return {number, number};
    }
    const std::string key = key_of(sets, std::string(field));
    if (sets.count(key) == 0) in_.fail(text("a set of ", what, "s that is defined above"), field);
    InpEntry other;
    other.set = key;
    return other;
  }

  void begin_surface() {
    const std::string type = in_.has("TYPE") ? inp_key(in_.value("TYPE")) : "ELEMENT";
    if (type == "NODE") {
      begin_set(set_named(out_.node_surfaces, in_.value("NAME")), out_.node_sets, "node");
      // Behind the comma stands the area of a node.
      data_ = [read = std::move(data_)](const Fields& fields) { read({fields.front()}); };
      return;
    }
    if (type != "ELEMENT") {
      out_.unread.emplace("*SURFACE, TYPE=" + type, in_.line());
      return;
    }
    InpSet& surface = set_named(out_.surfaces, in_.value("NAME"));
    data_ = [this, &surface](const Fields& fields) {
      InpEntry all = entry(out_.element_sets, fields[0], "element");
      const std::string side = fields.size() > 1 ? inp_key(fields[1]) : "";
      if (!side.empty()) {
        all.edge = side[0] == 'E';
        if (side.size() != 2 || (side[0] != 'S' && !all.edge) || side[1] < '1' ||
            side[1] > (all.edge ? '4' : '6'))
          in_.fail("a side S1 to S6 or an edge E1 to E4", fields[1]);
        all.side = side[1] - '0';
      }
      surface.entries.push_back(all);
    };
  }

  void begin_section() {
    const std::string set = key_of(out_.element_sets, in_.value("ELSET"));
    out_.sections.push_back(set);
    if (in_.has("COMPOSITE")) return;
    data_ = [this, set, first = true](const Fields& fields) mutable {
      if (!std::exchange(first, false) || fields[0].empty()) return;
      if (const std::string value(fields[0]); std::strtod(value.c_str(), nullptr) != 1)
        out_.thicknesses.push_back({set, clipped(value), in_.line()});
    };
  }

  void end_part() { in_part_ = false; }

  void begin_part() {
    in_part_ = true;
    part_ = in_.has("NAME") ? in_.value("NAME") : "Part";
    if (++parts_ > 1)
      in_.fail("several parts are not read: write the file without parts and assemblies");
  }

  void begin_instance() {
    in_part_ = true;
    if (part_.empty()) part_ = in_.has("NAME") ? in_.value("NAME") : "Instance";
    if (++instances_ > 1)
      in_.fail("several instances are not read: write the file without parts and assemblies");
    data_ = [this](const Fields& /*fields*/) {
      in_.fail(
          "instances that are moved are not read: write the file without parts and assemblies");
    };
  }

  InpText in_;
  InpRecords out_;
  std::function<void(const Fields&)> data_;  // reads the lines below it; empty: nobody does
  std::string type_;                         // of the present elements
  InpElementType read_as_;
  std::size_t wanted_ = 0;      // nodes of the present element
  int blocks_ = 0;              // elements that no set is given for
  std::vector<Whole> numbers_;  // of the present element, which may go on in the next line
  std::size_t element_line_ = 0;
  bool in_part_ = false;  // or in an instance
  std::string part_;      // name of it
  int parts_ = 0;
  int instances_ = 0;
};

}  // namespace

InpRecords inp_records(std::string_view content, const std::string& name) {
  require_input(!is_utf16(content), name, ":1: this is ", other_kind(content));
  return Reader(content, name).read();
}

}  // namespace signorini
