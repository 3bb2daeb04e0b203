#include "addons/files/filed_meshes.hpp"

#include <algorithm>
#include <utility>

#include "addons/files/gmsh.hpp"
#include "addons/files/inp.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/family.hpp"
#include "signorini/core/wording.hpp"

namespace signorini {
namespace {

const char* const joined_body = "the body of this file";

/// A mesh of a file.
struct Filed {
  std::string file;
  std::vector<std::string> groups;  // of cells, that are the body
  const Value* value = nullptr;
};

/// Where the file is, which from now on is one that the scene reads.
std::filesystem::path place_of(const Filed& filed, const Origin& origin) {
  return *origin.files.insert(origin.folder / filed.file).first;
}

/// The mesh of one surface; those of the others wait for their bodies.
Mesh mesh_of_surface(const Origin& origin, const std::filesystem::path& file,
                     const std::string& surface) {
  std::vector<Mesh>& meshes = origin.waiting[file];
  const auto place = [&] {
    return std::find_if(meshes.begin(), meshes.end(),
                        [&](const Mesh& mesh) { return mesh.name == surface; });
  };
  if (place() == meshes.end()) {
    meshes = read_gmsh(file);
    static_cast<void>(mesh_named(meshes, surface));
  }
  const auto found = place();
  Mesh mesh = std::move(*found);
  meshes.erase(found);
  return mesh;
}

Mesh mesh_of_file(const Filed& filed, const Origin& origin) {
  const std::filesystem::path file = place_of(filed, origin);
  if (filed.groups.size() == 1) return mesh_of_surface(origin, file, filed.groups.front());
  if (filed.groups.size() > 1)
    return mesh_named(read_gmsh(file, {{joined_body, filed.groups}}), joined_body);
  std::vector<Mesh> meshes = read_gmsh(file);
  require_input(meshes.size() == 1, "the file has ", meshes.size(),
                " bodies: say which one with surface = \"NAME\"; there are: ", names_of(meshes));
  return std::move(meshes.front());
}

Mesh mesh_of_inp(const Filed& filed, const Origin& origin) {
  InpMeshes read = read_inp(place_of(filed, origin), filed.groups);
  require_input(read.meshes.size() == 1, "the file has ", read.meshes.size(),
                " bodies: say which one with set = \"NAME\"; there are: ", names_of(read.meshes));
  if (!read.unread.empty())
    origin.notes.insert(text(filed.file, ": read are nodes, plane elements, sets and surfaces, ",
                             "and not: ", listed(read.unread)));
  for (const std::string& note : read.notes) origin.notes.insert(filed.file + ": " + note);
  return std::move(read.meshes.front());
}

/// A kind of meshes that stand in files. \param file  what the key `file` is about \param group  the key of groups of cells
Kind<Mesh> filed_kind(const char* name, const char* help, const char* file, const KeyInfo& group,
                      const char* group_name, Mesh (*read)(const Filed&, const Origin&)) {
  const Keys<Filed> keys = {{{"file", "text", "", "", file, true},
                             [](const Value& value, Filed& filed) {
                               take(value, filed.file);
                               filed.value = &value;
                             }},
                            {group, [group_name](const Value& value, Filed& filed) {
                               for (const Value* item : value.one_or_several())
                                 take(*item, filed.groups.emplace_back());
                               if (filed.groups.empty())
                                 value.fail("expected the name of ", group_name, ", got none");
                             }}};
  return {name, help, infos(keys), [keys, read](const Value& table) -> Mesh {
            Filed filed;
            fill(table, keys, filed);
            return filed.value->explain([&] { return read(filed, *table.origin); });
          }};
}

}  // namespace

Kind<Mesh> gmsh_kind() {
  return filed_kind(
      "gmsh", "a physical surface of a Gmsh file; boundaries are its physical curves",
      "written by Gmsh, in the folder of the scene file",
      {"surface", "text or list of them", "", "",
       "physical surface that is the body; may be left out if there is only one. Of a list each "
       "becomes a region, for layers"},
      "a physical surface", mesh_of_file);
}

Kind<Mesh> inp_kind() {
  return filed_kind(
      "inp",
      "plane elements of an input file of CalculiX or Abaqus; boundaries are its surfaces, sets of "
      "line elements and node sets, as far as they are sides on the border",
      "input file, in the folder of the scene file",
      {"set", "text or list of them", "", "",
       "element set that is the body; may be left out if there is only one with a section. Of a "
       "list each becomes a region, for layers"},
      "an element set", mesh_of_inp);
}

}  // namespace signorini
