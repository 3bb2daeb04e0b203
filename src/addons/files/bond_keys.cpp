#include <memory>

#include "addons/files/scene_keys.hpp"

namespace signorini {
namespace {

void read_terms(const Value& value, RelationDraft& relation) {
  for (const Value* const item : value.one_or_several()) {
    TermDraft term;
    term.bodies = relation.bodies;
    read_members(*item, term_keys(), term);
    relation.terms.push_back(std::move(term));
  }
  if (relation.terms.empty()) value.fail("expected a term or a list of them, got []");
}

void read_relation(const Value& value, SceneDraft& draft) {
  RelationDraft relation;
  relation.bodies = &draft.file.scene.bodies;
  read_members(value, relation_keys(), relation);
  int numbers = 0;
  for (const char* const name : {"right", "at_most", "at_least"})
    if (const Value* const given = value.find(name); given != nullptr && ++numbers > 1)
      given->fail("a relation has one number, right, at_most or at_least: write two relations for two");
  draft.bonds.relations.push_back(std::move(relation));
}

void read_rigid(const Value& value, SceneDraft& draft) {
  RigidDraft rigid;
  rigid.bodies = &draft.file.scene.bodies;
  read_members(value, rigid_keys(), rigid);
  draft.bonds.rigid.push_back(std::move(rigid));
}

void read_tie(const Value& value, SceneDraft& draft) {
  TieDraft tie;
  tie.bodies = &draft.file.scene.bodies;
  read_members(value, tie_keys(), tie);
  check_choices(value, tie);
  for (const char* const name : {"friction", "slides", "closes"})
    if (const Value* const other = value.find(name); other != nullptr && tie.stiffness)
      other->fail("has no meaning beside stiffness, which makes springs of the tie: leave it out");
  if (tie.friction && !tie.slides)
    value.find("friction")->fail("sides that are tied do not slide: add slides = true, or leave it out");
  if (const Value* const closes = value.find("closes"); closes != nullptr && tie.friction)
    closes->fail("has no meaning beside friction, whose pairs close what is open: leave it out");
  if (tie.friction) {
    draft.bonds.two_sided.push_back(draft.file.scene.contacts.size());
    draft.file.scene.contacts.push_back(tie);
    draft.file.contact_lines.push_back(value.line);
  } else {
    draft.bonds.ties.push_back({tie, tie.slides, tie.closes, tie.stiffness});
    draft.file.tie_lines.push_back(value.line);
  }
}

/// A key whose tables add to the bonds of a scene.
Key<SceneDraft> bond_key(const char* name, const char* help,
                         void (*read)(const Value&, SceneDraft&)) {
  return {{name, "table or list of them", "", "", help},
          [read](const Value& value, SceneDraft& draft) {
            each_item(read)(value, draft);
            draft.file.scene.bonds = std::make_shared<const Bonds>(draft.bonds);
          }};
}

/// A key of a rigid side of which the value may grow with a history.
template <typename M>
Key<RigidDraft> growing_key(const char* name, M RigidSide::*member, std::string RigidHistories::*history,
                            const char* unit, const char* help) {
  Key<RigidSide> made = key(name, member, unit, help);
  made.type += ", may grow";
  made.read = [member, history](const Value& value, RigidSide& rigid) {
    take_growing(value, rigid.*member, rigid.histories.*history);
  };
  return made;
}

template <typename Draft>
Key<Draft> side_key(const char* help) {
  return {{"side", "\"BODY.BOUNDARY\"", "", "", help, true},
          [](const Value& value, Draft& draft) { draft.side = side_of(value, *draft.bodies); }};
}

/// A key that gives the number of a relation, and says how it holds.
Key<RelationDraft> limit_key(const char* name, Holds holds, const char* help) {
  return {{name, "number", "length", "", help}, [holds](const Value& value, RelationDraft& relation) {
            take(value, relation.right);
            relation.holds = holds;
          }};
}

}  // namespace

const Keys<TieDraft>& tie_keys() {
  static const Keys<TieDraft> keys = [] {
    Keys<TieDraft> made;
    for (const Key<ContactDraft>& key : contact_keys())
      if (key.name != "interference" && key.name != "small_sliding" && key.name != "adjust")
        made.emplace_back(key);
    made.push_back(key("slides", &TieDraft::slides, "",
                       "whether the source may slide along the target; it never lifts off"));
    made.push_back(key("closes", &TieDraft::closes, "",
                       "whether gaps and overlaps of the meshes are closed, which strains the bodies; "
                       "without it they stay"));
    made.push_back(key("stiffness", &TieDraft::stiffness, "force/length^3",
                       "springs in the place of the tie, along the normal and along the tangent",
                       Bound::NotNegative));
    return made;
  }();
  return keys;
}

const Keys<TermDraft>& term_keys() {
  static const Keys<TermDraft> keys = {
      side_key<TermDraft>("all its nodes, one equation each; of the only body \"BOUNDARY\" is enough"),
      key("point", &TermDraft::only_at, "length", "or its node there alone, in all equations"),
      key("along", &TermDraft::along, "", "the displacement is multiplied by this vector"),
      key("times", &TermDraft::times, "", "and by this number")};
  return keys;
}

const Keys<RelationDraft>& relation_keys() {
  static const Keys<RelationDraft> keys = {
      {{"terms", "table or list of them", "", "",
        "that add up, as { side = \"right\", along = [0, 1], times = -1 }, see terms", true},
       read_terms},
      {{"right", "number, may grow", "length", "0", "what the terms add up to"},
       [](const Value& value, RelationDraft& relation) {
         take_growing(value, relation.right, relation.history);
       }},
      limit_key("at_most", Holds::AtMost, "instead of right: what they may reach and not pass, as a contact"),
      limit_key("at_least", Holds::AtLeast, "the same from above"),
      key("stiffness", &RelationDraft::stiffness, "force/length",
          "a spring in the place of each equation, on what is missing in it", Bound::Positive)};
  return keys;
}

const Keys<RigidDraft>& rigid_keys() {
  static const Keys<RigidDraft> keys = {
      side_key<RigidDraft>("whose nodes move as a rigid body"),
      key("centre", &RigidDraft::centre, "length", "point that moves by x and y, and that force acts on"),
      growing_key("x", &RigidSide::x, &RigidHistories::x, "length", "given displacement of the centre along x; free without it"),
      growing_key("y", &RigidSide::y, &RigidHistories::y, "length", "given displacement of the centre along y; free without it"),
      growing_key("turn", &RigidSide::turn, &RigidHistories::turn, "rad", "given turn, anticlockwise and small; free without it"),
      growing_key("force", &RigidSide::force, &RigidHistories::force, "force", "on the centre; in axial symmetry [0, F], all round"),
      growing_key("moment", &RigidSide::moment, &RigidHistories::moment, "force*length", "anticlockwise")};
  return keys;
}

const Keys<SceneDraft>& bond_keys() {
  static const Keys<SceneDraft> keys = {
      bond_key("tie", "what holds together, each a [[tie]], see tie", read_tie),
      bond_key("relation", "displacements that add up to a number, each a [[relation]], see relation",
               read_relation),
      bond_key("rigid", "sides that move as rigid bodies, each a [[rigid]], see rigid side",
               read_rigid)};
  return keys;
}

}  // namespace signorini
