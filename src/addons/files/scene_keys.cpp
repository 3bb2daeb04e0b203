#include "addons/files/scene_keys.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "addons/files/kinds.hpp"
#include "papers/solver_table.hpp"
#include "signorini/contact/gap_operators.hpp"
#include "signorini/core/family.hpp"
#include "signorini/fem/strain_laws.hpp"

namespace signorini {

template <>
const std::vector<Word<Quadrature>> words_of<Quadrature> = {
    {"segments", Quadrature::Segments}, {"source edges", Quadrature::SourceEdges}};

namespace {

/// One boundary, or one that is made of several of a body, and called by all of their names.
Side side_of_several(const Value& value, std::vector<Body>& bodies) {
  const std::vector<const Value*> all = value.one_or_several();
  if (all.empty()) value.fail("expected a boundary or a list of them, got []");
  Side whole = side_of(*all.front(), bodies);
  if (all.size() == 1) return whole;
  auto body = std::find_if(bodies.begin(), bodies.end(),
                           [&](const Body& one) { return one.mesh.name == whole.body; });
  std::vector<CellSide> sides;
  std::set<std::string> names;
  whole.boundary.clear();
  for (const Value* const item : all) {
    const Side next = side_of(*item, bodies);
    if (next.body != whole.body)
      item->fail("the boundaries of a list are one side of one body: this is one of '", next.body,
                 "', and the first one of '", whole.body, "'. Give each body a contact of its own");
    if (!names.insert(next.boundary).second)
      item->fail("the boundary ", in_quotes(next.boundary), " stands in the list twice");
    for (const CellSide& side : body->mesh.boundaries.at(next.boundary))
      if (std::none_of(sides.begin(), sides.end(), [&](const CellSide& known) {
            return known.cell == side.cell && known.side == side.side;
          }))
        sides.push_back(side);
    whole.boundary += (whole.boundary.empty() ? "" : "+") + next.boundary;
  }
  body->mesh.boundaries[whole.boundary] = std::move(sides);
  return whole;
}

void read_body(const Value& value, SceneDraft& scene) {
  BodyDraft draft;
  if (scene.material) draft.material = *scene.material;
  read_members(value, body_keys(), draft);
  if (!draft.own_material && !scene.material)
    value.fail("the key 'material' is missing, of the body or at the head of the file");
  scene.material_used = scene.material_used || !draft.own_material;
  scene.file.notes.insert(scene.file.notes.end(), draft.notes.begin(), draft.notes.end());
  std::vector<Body>& bodies = scene.file.scene.bodies;
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (bodies[k].mesh.name == draft.mesh.name)
      value.fail("the body of line ", scene.file.body_lines[k], " is called ",
                 in_quotes(draft.mesh.name), " too: give every body a name of its own");
  bodies.push_back(std::move(draft));
  scene.file.body_lines.push_back(value.line);
}

void read_bodies(const Value& value, SceneDraft& draft) {
  draft.file.scene.bodies.clear();
  each_item(read_body)(value, draft);
  if (draft.file.scene.bodies.empty()) value.fail("a scene needs at least one body");
}

void read_contact(const Value& value, SceneDraft& draft) {
  ContactDraft contact;
  contact.bodies = &draft.file.scene.bodies;
  read_members(value, contact_keys(), contact);
  check_choices(value, contact);
  draft.file.scene.contacts.push_back(std::move(contact));
  draft.file.contact_lines.push_back(value.line);
}

void read_target(const Value& value, ContactDraft& contact) {
  if (value.kind == Value::Kind::Table)
    contact.target = read_obstacle(value);
  else
    contact.target = side_of_several(value, *contact.bodies);
}

void read_interference(const Value& value, ContactDraft& contact) {
  double& most = contact.interference.emplace();
  const Value& own = without_history(value, contact.interference_history);
  if (!varies(own)) return take(own, most, Bound::NotNegative);
  const Side& source = contact.source;
  const Mesh& mesh =
      std::find_if(contact.bodies->begin(), contact.bodies->end(), [&](const Body& body) {
        return body.mesh.name == source.body;
      })->mesh;
  const Variation variation = read_variation(own, 1, mesh, source.boundary);
  const NodeArray nodes = mesh.nodes(boundary_nodes(mesh, source.boundary), Eigen::all);
  for (Eigen::Index k = 0; k < nodes.rows(); ++k)
    if (const double there = variation.at(nodes.row(k).transpose())(0); there < 0)
      own.fail("expected a length >= 0 all along the source, got ", there, " at ",
               in_brackets(nodes.row(k)));
  most = largest_size(variation, nodes);
  contact.interference_share = field_of(variation, most);
}

void read_friction(const Value& value, ContactDraft& contact) {
  Friction& friction = contact.friction.emplace();
  take_or_table(value, friction_keys(), friction, &Friction::coefficient, Bound::NotNegative);
  if (value.kind != Value::Kind::Table) return;
  // So that what a law refuses is told where it stands.
  value.explain([&] { static_cast<void>(find_friction_law(friction.law).bound(friction, 1)); });
  if (value.find("coefficient") == nullptr && value.find("cohesion") == nullptr)
    value.fail(
        "expected a coefficient or a cohesion, got neither: give one, or leave friction out");
}

/// A body with a law moves, and so do its pairs: to say that it does not is to say two things.
void read_moves(const Value& value, SceneDraft& draft) {
  take(value, draft.file.scene.moves);
  if (draft.file.scene.moves) return;
  for (const Body& body : draft.file.scene.bodies)
    if (body.material.law != nullptr)
      value.fail("body '", body.mesh.name, "' has the law ", body.material.law->name,
                 ", and its pairs are those of where it has moved to: leave out the key, or the law");
}

void read_plot(const Value& value, Output& output) {
  take(value, output.plot);
  const std::string ending = std::filesystem::path(output.plot).extension().string();
  if (std::find(picture_endings.begin(), picture_endings.end(), ending) == picture_endings.end())
    value.fail("expected a file .svg, .png or .pdf, got ", in_quotes(output.plot));
}

void read_halvings(const Value& value, SceneDraft& draft) {
  std::optional<Path>& path = draft.file.scene.path;
  if (!path) value.fail("has no meaning without [[steps]]: leave it out");
  take(value, path->halvings, Bound::NotNegative);
}

}  // namespace

void check_choices(const Value& value, const ContactSpec& contact) {
  const bool rigid = std::holds_alternative<Obstacle>(contact.target);
  const GapOperator& gap_operator = find_gap_operator(contact.gap_operator);
  const auto refuse = [&](const char* name, bool taken) {
    const Value* const choice = value.find(name);
    if (choice == nullptr || (!rigid && taken)) return;
    choice->fail("has no meaning ",
                 rigid ? "beside a rigid obstacle" : "for the operator " + contact.gap_operator,
                 ": leave it out");
  };
  refuse("operator", true);
  refuse("points", gap_operator.takes_points);
  refuse("quadrature", gap_operator.takes_quadrature);
}

Side side_of(const Value& value, const std::vector<Body>& bodies) {
  std::string word;
  take(value, word);
  std::vector<std::string> known;
  for (const Body& body : bodies)
    for (const auto& [name, sides] : body.mesh.boundaries) {
      const std::string full = body.mesh.name + "." + name;
      if (word == full || (bodies.size() == 1 && word == name)) {
        if (sides.empty()) value.fail("the boundary ", in_quotes(word), " is empty");
        return {name, body.mesh.name};
      }
      known.push_back(bodies.size() == 1 ? name : full);
    }
  value.fail("there is no boundary ", in_quotes(word), suggestion(word, known));
}

const Keys<Friction>& friction_keys() {
  static const Keys<Friction> keys = {
      key("coefficient", &Friction::coefficient, "", "mu", Bound::NotNegative),
      key("cohesion", &Friction::cohesion, "force/length^2", "c where the sides touch",
          Bound::NotNegative),
      {{"law", "text", "", written(Friction().law),
        "name of the law: " + names_of(friction_laws())},
       [](const Value& value, Friction& friction) {
         take_member(value, friction_laws(), "law", friction.law);
       }}};
  return keys;
}

const Keys<ContactDraft>& contact_keys() {
  static const Keys<ContactDraft> keys = {
      {{"source", "\"BODY.BOUNDARY\" or list of them", "", "",
        "side that carries the forces (slave); of the only body \"BOUNDARY\" is enough", true},
       [](const Value& value, ContactDraft& contact) {
         contact.source = side_of_several(value, *contact.bodies);
       }},
      {{"target", "\"BODY.BOUNDARY\", list of them, or table", "", "",
        "side that it meets (master), or a rigid obstacle, see obstacles", true},
       read_target},
      {{"friction", "number >= 0 or table", "", "",
        "coefficient of friction; as a table, see friction"},
       read_friction},
      {{"interference", type_name<double>(Bound::NotNegative) + ", may vary and grow", "length", "",
        "by how much more the sides overlap than the meshes say: a press fit"},
       read_interference},
      key("adjust", &ContactSpec::adjust, "length",
          "gaps and overlaps of the meshes up to this count as none", Bound::NotNegative),
      {{"operator", "text", "", written(ContactSpec().gap_operator),
        "between two bodies: " + names_of(gap_operators())},
       [](const Value& value, ContactDraft& contact) {
         take_member(value, gap_operators(), "operator", contact.gap_operator);
       }},
      key("quadrature", &ContactSpec::quadrature, "", "where the operator integrates"),
      without_standard(
          key("points", &ContactSpec::points, "",
              "Gauss points per edge or segment; without it as many as the operator wants",
              Bound::Positive)),
      key("small_sliding", &ContactSpec::small_sliding, "",
          "whether a pair may slide farther than its edge and still press on the place that it "
          "faced at first")};
  return keys;
}

const Keys<Output>& output_keys() {
  static const Keys<Output> keys = {
      key("vtu", &Output::vtu, "", "file of meshes and fields, for ParaView"),
      key("ascii", &Output::ascii, "", "whether its numbers are text, in the place of their bytes"),
      key("csv", &Output::csv, "", "file of the pressure table"),
      {{"plot", "text", "", "", "picture of pressure and deformed meshes, .svg, .png or .pdf"},
       read_plot},
      key("state", &Output::state, "", "of load steps: where they are, for --from"),
      key("probes", &Output::probes, "", "file of the table of what [[probe]] reads")};
  return keys;
}

namespace {

/// Keys in front of those of bonds.
const Keys<SceneDraft>& first_keys() {
  static const Keys<SceneDraft> keys = {
      {{"title", "text", "", "", "what it is, one line"},
       [](const Value& value, SceneDraft& draft) { take(value, draft.file.title); }},
      {{"solver", "text", "", written(std::string(Scene().solver.name)),
        "of the contact problem, see signorini --list"},
       [](const Value& value, SceneDraft& draft) {
         std::string name;
         take_member(value, all_solvers(), "solver", name);
         draft.file.scene.solver = find_solver(name);
       }},
      {{"material", "table", "", "", "of the bodies that have none of their own, see material"},
       [](const Value& value, SceneDraft& draft) {
         read_material(value, draft.material.emplace());
       }},
      {{"body", "table or list of them", "", "", "each a [[body]] with its mesh, see body", true},
       read_bodies},
      {{"contact", "table or list of them", "", "",
        "what may touch, each a [[contact]], see contact"},
       each_item(read_contact)}};
  return keys;
}

/// Keys behind those of bonds.
const Keys<SceneDraft>& last_keys() {
  static const Keys<SceneDraft> keys = {
      {{"history", "table or list of them", "", "",
        "each a [[history]], what loads grow with if steps do not say it, see load steps"},
       read_histories},
      {{"steps", "table or list of them", "", "",
        "each a [[steps]], one after another, see load steps; without it all loads come at once"},
       read_steps},
      {{"halvings", type_name<int>(Bound::NotNegative), "", written(Path().halvings),
        "how often in a row a step that fails is tried half as long"},
       read_halvings},
      {{"moves", type_name<bool>(), "", written(Scene().moves),
        "whether pairs are those of bodies where they have moved to, in [[steps]]"},
       read_moves},
      {{"probe", "table or list of them", "", "", "each a [[probe]], what is read, see probe"},
       read_probes},
      {{"output", "table", "", "", "what is written, into the working folder, see output"},
       [](const Value& value, SceneDraft& draft) {
         read_members(value, output_keys(), draft.file.output);
       }}};
  return keys;
}

}  // namespace

const Keys<SceneDraft>& scene_keys() {
  static const Keys<SceneDraft> keys = [] {
    Keys<SceneDraft> all = first_keys();
    all.insert(all.end(), bond_keys().begin(), bond_keys().end());
    all.insert(all.end(), last_keys().begin(), last_keys().end());
    return all;
  }();
  return keys;
}

}  // namespace signorini
