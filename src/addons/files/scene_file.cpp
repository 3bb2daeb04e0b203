#include "addons/files/scene_file.hpp"

#include <algorithm>
#include <utility>

#include "addons/files/kinds.hpp"
#include "addons/files/scene_keys.hpp"
#include "addons/text/text_reader.hpp"
#include "signorini/scene/notes.hpp"

namespace signorini {
namespace {

/// Whether a scene by itself fails with a message, whatever the notes.
bool fails_with(const std::string& message, const Scene& scene) {
  try {
    for (const BodyModel& body : plan(scene).bodies)
      static_cast<void>(nodal_loads(body.mesh, body.element, body.material, body.loads));
  } catch (const ProblemError& error) {
    return without_notes(error.what()) == without_notes(message);
  } catch (const std::exception&) {
    return false;
  }
  return false;
}

/// What tables call the contacts; nothing if there is no plan.
std::vector<std::string> names_of_contacts(const Scene& scene) {
  try {
    return plan(scene).contacts;
  } catch (const std::exception&) {
    return {};
  }
}

/// The line that is to blame for an error.
std::size_t line_of(const SceneFile& file, const std::string& message) {
  const std::vector<Body>& bodies = file.scene.bodies;
  const std::vector<ContactSpec>& contacts = file.scene.contacts;
  const auto fails = [&](std::vector<Body> some, std::vector<ContactSpec> touching) {
    return fails_with(message,
                      {std::move(some), std::move(touching), file.scene.solver, file.scene.path});
  };
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (message.rfind("body '" + bodies[k].mesh.name + "'", 0) == 0 || fails({bodies[k]}, {}))
      return file.body_lines[k];
  if (!fails(bodies, {})) {
    for (std::size_t k = 0; k < contacts.size(); ++k)
      if (fails(bodies, {contacts[k]})) return file.contact_lines[k];
    for (std::size_t k = contacts.size(); k-- > 0;) {
      std::vector<ContactSpec> others = contacts;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
      if (fails(bodies, contacts) && !fails(bodies, std::move(others)))
        return file.contact_lines[k];
    }
  }
  for (std::size_t k = 0; k < file.tie_lines.size(); ++k) {
    Scene some{bodies, contacts, file.scene.solver, file.scene.path};
    some.bonds = std::make_shared<const Bonds>(Bonds{{file.scene.bonds->ties[k]}});
    if (fails_with(message, some)) return file.tie_lines[k];
  }
  const std::vector<std::string> names = names_of_contacts(file.scene);
  for (std::size_t k = names.size(); k-- > 0;)  // a later name may have an earlier one in it
    if (message.find(names[k]) != std::string::npos) return file.contact_lines[k];
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (message.find("'" + bodies[k].mesh.name + "'") != std::string::npos)
      return file.body_lines[k];
  return file.body_lines.empty() ? 1 : file.body_lines.front();
}

void add_table(std::string& page, const std::vector<KeyInfo>& keys) {
  page += "| key | value | unit | without it | |\n|:--|:--|:--|:--|:--|\n";
  for (const KeyInfo& key : keys) {
    const auto code = [](const std::string& words) {
      return words.empty() ? words : "`" + words + "`";
    };
    page += "| `" + key.name + "` | " + key.type + " | " + key.unit + " | " +
            (key.required ? "must be there" : code(key.standard)) + " | " + key.help + " |\n";
  }
}

template <typename T>
void add_section(std::string& page, const std::string& heading, const Keys<T>& keys) {
  page += "\n### " + heading + "\n\n";
  add_table(page, infos(keys));
}

template <typename Thing>
void add_kinds(std::string& page, const std::string& heading, const std::vector<Kind<Thing>>& kinds,
               const std::vector<KeyInfo>& common) {
  page += "\n### " + heading + "\n";
  if (!common.empty()) {
    page += "\nOf all kinds:\n\n";
    add_table(page, common);
  }
  for (const Kind<Thing>& kind : kinds) {
    page += "\n`kind = \"" + kind.name + "\"`: " + kind.help + "\n\n";
    add_table(page, kind.keys);
  }
}

}  // namespace

SceneFile parse_scene(std::string_view content, const std::string& name,
                      const std::filesystem::path& folder) {
  const Value root = parse_toml(content, {name, folder});
  SceneDraft draft;
  draft.file.name = name;
  draft.root = &root;
  read_members(root, scene_keys(), draft);
  if (draft.material && !draft.material_used)
    root.find("material")->fail("is unused: every body has a material of its own");
  check_histories(draft);
  const std::set<std::string>& of_files = root.origin->notes;
  draft.file.notes.insert(draft.file.notes.end(), of_files.begin(), of_files.end());
  draft.file.files.assign(root.origin->files.begin(), root.origin->files.end());
  return std::move(draft.file);
}

SceneFile read_scene(const std::filesystem::path& file) {
  return parse_scene(file_content(file, largest_scene_file), file.string(), file.parent_path());
}

std::string located(const SceneFile& file, const std::string& message) {
  if (message.rfind(file.name + ":", 0) == 0) return message;
  return text(file.name, ":", line_of(file, message), ": ", message);
}

std::string key_reference() {
  std::string page = "### Scene: the head of the file\n\n";
  add_table(page, infos(scene_keys()));
  add_section(page, "Body: `[[body]]`", body_keys());
  add_kinds(page, "Meshes: `mesh = { kind = ..., ... }`", mesh_kinds(), mesh_keys());
  add_section(page, "Material", material_keys());
  add_section(page, "Point", point_keys());
  add_section(page, "Temperature", temperature_keys());
  add_section(page, "Layer", layer_keys());
  page += "\n### Values that vary: `{ over = ..., table = ... }` or `{ polynomial = ... }`\n\n";
  add_table(page, varying_keys());
  add_section(page, "Contact: `[[contact]]`", contact_keys());
  add_kinds(page, "Obstacles: `target = { kind = ..., ... }`", obstacle_kinds(), {});
  add_section(page, "Friction", friction_keys());
  add_section(page, "Tie: `[[tie]]`", tie_keys());
  add_section(page, "Relation: `[[relation]]`", relation_keys());
  add_section(page, "Relation: `terms`", term_keys());
  add_section(page, "Rigid side: `[[rigid]]`", rigid_keys());
  add_section(page, "Load steps: `[[steps]]`", steps_keys());
  add_section(page, "Load steps: `[[history]]`", history_keys());
  page += "\n### Load steps: what may grow, as `{ value = ..., history = ... }`\n\n";
  add_table(page, growing_keys());
  add_section(page, "Probe: `[[probe]]`", probe_keys());
  add_section(page, "Output: `[output]`", output_keys());
  return page;
}

}  // namespace signorini
