#include <Eigen/Geometry>
#include <limits>
#include <map>
#include <utility>

#include "addons/files/kinds.hpp"
#include "addons/files/scene_keys.hpp"
#include "meshes/regions.hpp"
#include "signorini/core/family.hpp"
#include "signorini/core/index.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/fem/strain_laws.hpp"

namespace signorini {

using Eigen::Index, Eigen::Vector2d;

template <>
const std::vector<Word<PlaneState>> words_of<PlaneState> = {
    {to_string(PlaneState::Strain), PlaneState::Strain},
    {to_string(PlaneState::Stress), PlaneState::Stress},
    {to_string(PlaneState::Axial), PlaneState::Axial}};

namespace {

template <typename Thing>
std::vector<std::string> names_in(const std::map<std::string, Thing>& named) {
  std::vector<std::string> names;
  for (const auto& one : named) names.push_back(one.first);
  return names;
}

/// Checks that a mesh has a boundary, and that this is not empty.
void check_boundary(const Value& value, const Mesh& mesh, const std::string& name) {
  const auto found = mesh.boundaries.find(name);
  if (found == mesh.boundaries.end())
    value.fail("'", mesh.name, "' has no boundary ", in_quotes(name),
               suggestion(name, names_in(mesh.boundaries)));
  if (found->second.empty())
    value.fail("the boundary ", in_quotes(name), " of '", mesh.name, "' is empty");
}

/// Calls a function with every boundary and what is said of it: { top = 3.6 }.
template <typename Each>
void each_boundary(const Value& value, const Mesh& mesh, const Each& each) {
  if (value.kind != Value::Kind::Table || value.items.empty())
    value.fail("expected a table of boundaries such as { ",
               mesh.boundaries.empty() ? std::string("top") : mesh.boundaries.begin()->first,
               " = ... }, got ", value.shown());
  for (const Value& item : value.items) {
    check_boundary(item, mesh, item.name);
    each(item);
  }
}

VectorField constant(const Vector2d& vector) {
  return [vector](const Vector2d& /*at*/) { return vector; };
}

/// Adds a load to each boundary of a table, filled by a function from what is said of it.
template <typename Fill>
void read_edge_loads(const Value& value, BodyDraft& draft, const Fill& fill) {
  each_boundary(value, draft.mesh, [&](const Value& item) {
    EdgeLoad& load = draft.loads.edges.emplace_back();
    load.boundary = item.name;
    fill(item, load);
  });
}

void read_pressure(const Value& value, BodyDraft& draft) {
  read_edge_loads(value, draft, [&](const Value& item, EdgeLoad& load) {
    const Value& own = without_history(item, load.history);
    if (!varies(own)) return take(own, load.pressure);
    const Variation variation = read_variation(own, 1, draft.mesh, item.name);
    load.pressure = largest_size(
        variation, draft.mesh.nodes(boundary_nodes(draft.mesh, item.name), Eigen::all));
    load.share = field_of(variation, load.pressure);
    load.rule = rule_of(variation);
  });
}

void read_traction(const Value& value, BodyDraft& draft) {
  read_edge_loads(value, draft, [&](const Value& item, EdgeLoad& load) {
    const Value& own = without_history(item, load.history);
    if (varies(own)) {
      const Variation variation = read_variation(own, 2, draft.mesh, item.name);
      load.traction = [variation](const Vector2d& x) { return Vector2d(variation.at(x)); };
      load.rule = rule_of(variation);
      return;
    }
    Vector2d traction;
    take(own, traction);
    load.traction = constant(traction);
  });
}

void read_element(const Value& value, BodyDraft& draft) {
  take_member(value, elements(), "element", draft.element);
  value.explain([&] { static_cast<void>(element_for(draft.mesh, draft.element)); });
}

void read_own_material(const Value& value, BodyDraft& draft) {
  draft.material = {};
  read_material(value, draft.material);
  draft.own_material = true;
}

void read_temperature(const Value& value, BodyDraft& draft) {
  take_or_table(value, temperature_keys(), draft.temperature.emplace(), &Temperature::uniform);
  if (const Value* const varying = value.find("varying"))
    draft.temperature->varying = field_of(read_variation(*varying, 1, draft.mesh, ""));
}

void read_springs(const Value& value, BodyDraft& draft) {
  each_boundary(value, draft.mesh, [&](const Value& item) {
    Vector2d stiffness;
    take(item, stiffness, Bound::NotNegative);
    draft.springs.push_back({item.name, stiffness, {}});
  });
}

void read_body_force(const Value& value, BodyDraft& draft) {
  Vector2d force;
  take_growing(value, force, draft.loads.body_force_history);
  draft.loads.body_force = constant(force);
}

/// Supports by the components of a displacement that are given; `made` makes one of an axis and a displacement.
template <typename Given, typename Made>
void prescribe(const Given& given, const Made& made, BodyDraft& draft) {
  for (const auto& [axis, by] : {std::pair(Axis::X, given.x), std::pair(Axis::Y, given.y)}) {
    if (!by) continue;
    draft.supports.push_back(made(axis, *by));
    draft.supports.back().history = given.history;
  }
}

/// The boundary that a node at a place lies on: the one with the nearest node.
std::string boundary_at(const Value& value, const Mesh& mesh, const Vector2d& at) {
  double least = std::numeric_limits<double>::infinity();
  std::string nearest;
  for (const auto& named : mesh.boundaries)
    for (const Index node : boundary_nodes(mesh, named.first))
      if (const double apart = (mesh.nodes.row(node).transpose() - at).norm(); apart < least) {
        least = apart;
        nearest = named.first;
      }
  if (nearest.empty()) value.fail("'", mesh.name, "' has no boundary that the point could be on");
  return nearest;
}

void read_point(const Value& value, BodyDraft& draft) {
  PointDraft point;
  read_members(value, point_keys(), point);
  const bool moved = point.x || point.y;
  if (!point.force && !point.spring && !moved)
    value.fail("nothing acts at this point: give force, spring, x or y");
  if (point.force) draft.loads.points.push_back({point.at, *point.force, point.history});
  if (const Value* const history = value.find("history"); history && !point.force && !moved)
    history->fail("has no meaning for a spring: leave it out");
  if (!point.spring && !moved) return;
  const std::string boundary = boundary_at(value, draft.mesh, point.at);
  if (point.spring) draft.springs.push_back({boundary, *point.spring, point.at});
  const auto made = [&](Axis axis, double by) {
    return prescribed_at(boundary, point.at, axis, by);
  };
  prescribe(point, made, draft);
}

/// Gives the cells of a box a name, and returns it.
std::string region_of_box(const Value& value, const std::vector<double>& box, Mesh& mesh) {
  std::size_t number = mesh.regions.size() + 1;
  while (mesh.regions.count(text("box ", number)) > 0) ++number;
  const std::string name = text("box ", number);
  value.explain([&] {
    mesh = with_region(std::move(mesh), name, {box[0], box[1]}, {box[2], box[3]});
  });
  return name;
}

/// The smallest box around the corners of some cells.
Eigen::AlignedBox2d box_around(const Mesh& mesh, const std::vector<Index>& cells) {
  Eigen::AlignedBox2d box;
  for (const Index cell : cells)
    for (int k = 0; k < mesh.corners(cell); ++k)
      box.extend(Vector2d(mesh.nodes.row(mesh.cells(cell, k)).transpose()));
  return box;
}

/// How many cells the edges of a box cut, by more than the last of six digits that a file of nodes may have.
Index cells_cut(const Mesh& mesh, const std::vector<double>& box) {
  Index count = 0;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) {
    const Eigen::AlignedBox2d around = box_around(mesh, {cell});
    const Vector2d& low = around.min();
    const Vector2d& high = around.max();
    const Vector2d little = 1e-6 * (high - low);
    const auto within = [&](int axis, double x) {
      return x > low(axis) + little(axis) && x < high(axis) - little(axis);
    };
    const auto spans = [&](int axis) {
      return box[at(axis)] < high(axis) - little(axis) &&
             box[at(axis + 2)] > low(axis) + little(axis);
    };
    const auto cut = [&](int axis) {
      return spans(1 - axis) && (within(axis, box[at(axis)]) || within(axis, box[at(axis + 2)]));
    };
    if (cut(0) || cut(1)) ++count;
  }
  return count;
}

/// Says of a box whose edges are not those of cells what became of it.
void note_on_box(const Value& value, const LayerDraft& layer, BodyDraft& draft) {
  const Mesh& mesh = draft.mesh;
  const Index cut = cells_cut(mesh, layer.box);
  if (cut == 0) return;
  const Eigen::AlignedBox2d taken = box_around(mesh, region(mesh, layer.region));
  const auto corners = [](double left, double bottom, double right, double top) {
    return text('[', left, ", ", bottom, ", ", right, ", ", top, ']');
  };
  draft.notes.push_back(text(
      value.origin->name, ":", value.find("box")->line, ": the edges of the box ",
      corners(layer.box[0], layer.box[1], layer.box[2], layer.box[3]), " of a layer of '",
      mesh.name, "' cut ", cut, cut == 1 ? " cell" : " cells",
      ". A cell is in a layer whole or not at all, by its middle: the layer takes the cells of ",
      corners(taken.min().x(), taken.min().y(), taken.max().x(), taken.max().y()),
      ". Let cells end at the edges of the box if that is not meant"));
}

void read_layer(const Value& value, BodyDraft& draft) {
  LayerDraft layer{draft.material};
  read_members(value, layer_keys(), layer);
  if (layer.region.empty() == layer.box.empty()) value.fail("give either region or box");
  if (layer.region.empty()) {
    layer.region = region_of_box(value, layer.box, draft.mesh);
    note_on_box(value, layer, draft);
  } else if (draft.mesh.regions.count(layer.region) == 0) {
    value.find("region")->fail("'", draft.mesh.name, "' has no region ", in_quotes(layer.region),
                               suggestion(layer.region, names_in(draft.mesh.regions)));
  }
  value.explain([&] { check_material(layer); });
  draft.layers.push_back({layer.region, layer});
}

/// Displacements that are given along a boundary, where they stand in the file.
struct Moved {
  const Value* x = nullptr;
  const Value* y = nullptr;
  std::string history;
};

Key<Moved> moved_key(const char* name, const Value* Moved::*member, const char* help) {
  return {{name, "number, may vary", "length", "", help},
          [member](const Value& value, Moved& moved) { moved.*member = &value; }};
}

void read_prescribed(const Value& value, BodyDraft& draft) {
  static const Keys<Moved> keys = {moved_key("x", &Moved::x, "displacement along x"),
                                   moved_key("y", &Moved::y, "displacement along y"),
                                   history_key(&Moved::history)};
  each_boundary(value, draft.mesh, [&](const Value& item) {
    const auto made = [&](Axis axis, const Value& by) {
      if (varies(by))
        return prescribed(item.name, axis, field_of(read_variation(by, 1, draft.mesh, item.name)));
      double everywhere = 0;
      take(by, everywhere);
      return prescribed(item.name, axis, everywhere);
    };
    for (const Value* const one : item.one_or_several()) {
      Moved moved;
      read_members(*one, keys, moved);
      if (!moved.x && !moved.y) one->fail("expected { x = ... }, { y = ... } or both");
      prescribe(moved, made, draft);
    }
  });
}

Key<BodyDraft> supported(const char* name, const char* help, Support (*made)(const std::string&)) {
  return {{name, "boundary or list of them", "", "", help},
          [made](const Value& value, BodyDraft& draft) {
            for (const Value* const item : value.one_or_several()) {
              std::string boundary;
              take(*item, boundary);
              check_boundary(*item, draft.mesh, boundary);
              draft.supports.push_back(made(boundary));
            }
          }};
}

}  // namespace

void read_material(const Value& value, Material& material) {
  read_members(value, material_keys(), material);
  value.explain([&] { check_material(material); });
}

const Keys<Material>& material_keys() {
  static const Keys<Material> keys = {
      required(key("youngs_modulus", &Material::youngs_modulus, "force/length^2",
                   "Young's modulus E", Bound::Positive)),
      required(key("poisson_ratio", &Material::poisson_ratio, "", "Poisson's ratio")),
      key("state", &Material::state, "", "what does not happen across the plane"),
      key("thickness", &Material::thickness, "length", "across the plane", Bound::Positive),
      key("expansion", &Material::expansion, "1/temperature", "thermal strain per temperature"),
      {{"law", "text", "", "\"small\"", "what it answers to strains: " + names_of(strain_laws())},
       [](const Value& value, Material& material) {
         std::string name;
         take(value, name);
         value.explain([&] { material.law = find_strain_law(name); });
       }}};
  return keys;
}

const Keys<LayerDraft>& layer_keys() {
  static const Keys<LayerDraft> keys = [] {
    Keys<LayerDraft> made = {
        key("region", &LayerDraft::region, "", "of the mesh: the cells of the layer"),
        {{"box", "[left, bottom, right, top]", "length", "",
          "in place of region: the cells whose middle lies in it or on its edge"},
         [](const Value& value, LayerDraft& layer) {
           for (const Value& item : list_of(value, 4, "number")) {
             layer.box.push_back(0);
             take(item, layer.box.back());
           }
         }}};
    for (Key<Material> key : material_keys()) {
      if (key.name == "state" || key.name == "thickness") continue;
      key.required = false;
      key.standard = "that of the body";
      made.emplace_back(key);
    }
    return made;
  }();
  return keys;
}

const Keys<PointDraft>& point_keys() {
  static const Keys<PointDraft> keys = {
      required(key("at", &PointDraft::at, "length",
                   "where: a node of the edge, for a force also between nodes")),
      key("force", &PointDraft::force, "force", "on the body"),
      key("spring", &PointDraft::spring, "force/length", "to the ground, in x and y",
          Bound::NotNegative),
      key("x", &PointDraft::x, "length", "given displacement along x"),
      key("y", &PointDraft::y, "length", "given displacement along y"),
      history_key(&PointDraft::history)};
  return keys;
}

const Keys<Temperature>& temperature_keys() {
  static const Keys<Temperature> keys = {
      key("uniform", &Temperature::uniform, "temperature", "at the origin"),
      key("gradient", &Temperature::gradient, "temperature/length", "along x and y"),
      {{"varying", "table", "temperature", "",
        "what comes on top, over x or y or as a polynomial, "
        "see values that vary"},
       [](const Value& /*value*/, Temperature& /*temperature*/) {}},  // by who knows the mesh
      history_key(&Temperature::history)};
  return keys;
}

const Keys<BodyDraft>& body_keys() {
  static const Keys<BodyDraft> keys = {
      {{"name", "text", "", "\"body\"", "of the body; no other body has it"},
       [](const Value& value, BodyDraft& draft) { take(value, draft.mesh.name); }},
      {{"mesh", "table", "", "",
        "such as { kind = \"block\", size = [50, 5], cells = [100, 10] }, see meshes", true},
       [](const Value& value, BodyDraft& draft) {
         draft.mesh = read_mesh(value, draft.mesh.name);
       }},
      {{"element", "text", "", "the usual one of its cells",
        "of the cells: " + names_of(elements()) + "; usual are t3, t6, q4_incompatible, q8"},
       read_element},
      {{"material", "table", "", "that of the scene", "see material"}, read_own_material},
      supported("fixed", "no displacement", fixed),
      supported("symmetric", "no displacement across straight boundaries, free along them",
                symmetric),
      {{"prescribed", "table of boundary = { x, y, history }, or of lists of them", "length", "",
        "given displacements, as { right = { x = 0.1 } }; the other component is free"},
       read_prescribed},
      {{"pressure", "table of boundary = number, may vary and grow", "force/length^2", "",
        "against the body, as { top = 3.6 }; < 0 pulls"},
       read_pressure},
      {{"traction", "table of boundary = [x, y], may vary and grow", "force/length^2", "",
        "as { right = [0, -1] }"},
       read_traction},
      {{"spring", "table of boundary = [x, y] >= 0", "force/length^3", "",
        "to the ground in x and y, as { bottom = [0, 50] }"},
       read_springs},
      {{"body_force", "[x, y], may grow", "force/length^3", "", "such as the weight"},
       read_body_force},
      {{"point", "table or list of them", "", "", "what acts at single points, see point"},
       each_item(read_point)},
      {{"temperature", "number or table", "temperature", "",
        "above that without stress; as a table, see temperature"},
       read_temperature},
      {{"layer", "table or list of them", "", "", "parts of another material, see layer"},
       each_item(read_layer)}};
  return keys;
}

}  // namespace signorini
