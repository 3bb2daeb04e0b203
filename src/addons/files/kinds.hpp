// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Things of several kinds, each kind with keys of its own: meshes and rigid obstacles.
#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "addons/files/keys.hpp"
#include "signorini/contact/obstacle.hpp"
#include "signorini/fem/mesh.hpp"

namespace signorini {

/// One kind of a thing.
template <typename Thing>
struct Kind {
  std::string name;                         ///< as in `kind = "NAME"`
  std::string help;                         ///< one line
  std::vector<KeyInfo> keys;                ///< its own
  std::function<Thing(const Value&)> make;  ///< from a table through check_members()
};

/// A kind whose keys fill a Spec, of which a function makes the thing.
/// \param name  of the kind
/// \param help  one line
/// \param keys  of the Spec
/// \param make  function of a Spec that may throw std::invalid_argument
/// \return the kind
template <typename Thing, typename Spec, typename Make>
[[nodiscard]] Kind<Thing> kind_of(const char* name, const char* help, const Keys<Spec>& keys,
                                  const Make& make) {
  return {name, help, infos(keys), [keys, make](const Value& table) -> Thing {
            Spec spec;
            fill(table, keys, spec);
            return table.explain([&]() -> Thing { return make(spec); });
          }};
}

/// Which kind a table is of. Checks its keys.
/// \param table   any value
/// \param kinds   that there are
/// \param common  keys of all kinds besides `kind`
/// \return the member of `kinds`
/// \throws ProblemError if there is no such kind, or for a key that is unknown or of another kind
template <typename Thing>
[[nodiscard]] const Kind<Thing>& find_kind(const Value& table,
                                           const std::vector<Kind<Thing>>& kinds,
                                           const std::vector<KeyInfo>& common) {
  std::vector<std::string> names;
  for (const Kind<Thing>& kind : kinds) names.push_back(kind.name);
  if (table.kind != Value::Kind::Table)
    table.fail("expected a table such as { kind = \"", names.front(), "\", ... }, got ",
               table.shown());
  const Value* const wanted = table.find("kind");
  if (wanted == nullptr) table.fail("the key 'kind' is missing: one of ", listed(names));
  std::string name;
  take(*wanted, name);
  const Kind<Thing>* found = nullptr;
  for (const Kind<Thing>& kind : kinds)
    if (kind.name == name) found = &kind;
  if (found == nullptr) wanted->fail("unknown kind ", in_quotes(name), suggestion(name, names));
  std::vector<KeyInfo> known = found->keys;
  known.insert(known.end(), common.begin(), common.end());
  known.push_back({"kind", "text", "", "", "", true});
  check_members(table, known, [&](const std::string& key) {
    std::string owners;
    for (const Kind<Thing>& kind : kinds)
      for (const KeyInfo& info : kind.keys)
        if (info.name == key) owners += (owners.empty() ? "" : ", ") + kind.name;
    return owners.empty() ? owners : "it is no key of kind '" + name + "' but of " + owners;
  });
  return *found;
}

/// \return the kinds of meshes
[[nodiscard]] const std::vector<Kind<Mesh>>& mesh_kinds();

/// \return the keys that meshes of all kinds have, besides `kind`
[[nodiscard]] const std::vector<KeyInfo>& mesh_keys();

/// Makes a mesh.
/// \param table  any value
/// \param name   of the mesh
/// \return a mesh, not looked at by check_mesh()
/// \throws ProblemError for what is wrong with the table or the file that it names
[[nodiscard]] Mesh read_mesh(const Value& table, const std::string& name);

/// \return the kinds of rigid obstacles
[[nodiscard]] const std::vector<Kind<Obstacle>>& obstacle_kinds();

/// Makes a rigid obstacle. \param table  any value
/// \return the obstacle
/// \throws ProblemError for what is wrong with the table
[[nodiscard]] Obstacle read_obstacle(const Value& table);

}  // namespace signorini
