#include <algorithm>
#include <utility>

#include "addons/along/place_in_mesh.hpp"
#include "addons/along/probes.hpp"
#include "addons/files/scene_keys.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/fem/elements.hpp"

namespace signorini {
namespace {

/// The body that a probe names, or the only one.
const Body& body_of(const Value& value, const std::string& name, const std::vector<Body>& bodies) {
  std::vector<std::string> known;
  for (const Body& body : bodies) {
    if (body.mesh.name == name || (name.empty() && bodies.size() == 1)) return body;
    known.push_back(body.mesh.name);
  }
  if (name.empty()) value.fail("the key 'body' is missing: there are several: ", listed(known));
  value.find("body")->fail("no body is called ", in_quotes(name), suggestion(name, known));
}

/// Checks that the mesh has a boundary with sides.
void check_boundary(const Value& value, const Mesh& mesh, const std::string& name) {
  value.explain([&] { static_cast<void>(side_curves(mesh, name)); });
}

/// Refuses a probe that says twice where it is, or not at all.
void check_place(const Value& value, const ProbeDraft& draft) {
  if (draft.from.has_value() != draft.to.has_value())
    value.fail("a line needs both from and to, got only ", draft.from ? "from" : "to");
  const int places = (draft.at ? 1 : 0) + (draft.from ? 1 : 0) + (draft.along.empty() ? 0 : 1) +
                     (draft.of.empty() ? 0 : 1);
  if (places != 1)
    value.fail("expected one place, got ", places,
               ": give one of at (a point), from and to (a line), along (a boundary, node by node) "
               "and of (a boundary, in sum)");
  if (const Value* const points = value.find("points")) {
    if (!draft.from) points->fail("has no meaning but for a line, from and to: leave it out");
    if (draft.points < 2) points->fail("a line has 2 points or more, got ", draft.points);
  }
}

void read_probe(const Value& value, SceneDraft& scene) {
  ProbeDraft draft;
  read_members(value, probe_keys(), draft);
  check_place(value, draft);
  const Body& body = body_of(value, draft.body, scene.file.scene.bodies);
  std::vector<Probe>& probes = scene.file.probes;
  Probe probe;
  probe.name = draft.name.empty() ? text("probe ", probes.size() + 1) : draft.name;
  if (std::any_of(probes.begin(), probes.end(),
                  [&](const Probe& known) { return known.name == probe.name; }))
    value.fail("another probe is called ", in_quotes(probe.name),
               " too: give every probe a name of its own");
  probe.body = body.mesh.name;
  probe.along = draft.along;
  probe.of = draft.of;
  for (const char* const name : {"along", "of"})
    if (const Value* const place = value.find(name)) check_boundary(*place, body.mesh, place->text);
  if (draft.at) probe.points = draft.at->transpose();
  probe.line = draft.from.has_value();
  if (probe.line) probe.points = points_between(*draft.from, *draft.to, draft.points);
  const Element& element = value.explain([&]() -> const Element& {
    check_mesh(body.mesh);
    return element_for(body.mesh, body.element);
  });
  bool outside = probe.points.rows() > 0;  // all of it
  for (Eigen::Index k = 0; k < probe.points.rows() && outside; ++k)
    outside = is_outside(place_in_mesh(body.mesh, element, probe.points.row(k).transpose()));
  if (outside)
    value.explain([&] {
      static_cast<void>(place_within(body.mesh, element, probe.points.row(0).transpose()));
    });
  probes.push_back(std::move(probe));
}

}  // namespace

const Keys<ProbeDraft>& probe_keys() {
  static const Keys<ProbeDraft> keys = {
      {{"name", "text", "", "\"probe 1\" and so on", "of the probe; no other has it"},
       [](const Value& value, ProbeDraft& draft) { take(value, draft.name); }},
      {{"body", "text", "", "the only one", "name of the body that it is in"},
       [](const Value& value, ProbeDraft& draft) { take(value, draft.body); }},
      key("at", &ProbeDraft::at, "length",
          "a point, before loading: displacement and stress there"),
      key("from", &ProbeDraft::from, "length",
          "begin of a line: the same at points along it; no value where the body has none, as in a hole"),
      key("to", &ProbeDraft::to, "length", "end of the line"),
      key("points", &ProbeDraft::points, "", "how many on the line, at equal distances",
          Bound::Positive),
      key("along", &ProbeDraft::along, "",
          "a boundary: the same at its nodes, and the forces of contact, supports, springs and bonds "
          "on them"),
      key("of", &ProbeDraft::of, "",
          "a boundary: its mean displacement, and force and moment about the origin of contact, "
          "supports, springs and bonds on its nodes")};
  return keys;
}

void read_probes(const Value& value, SceneDraft& draft) { each_item(read_probe)(value, draft); }

}  // namespace signorini
