#include "command_line/backends.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"

namespace command_line {

using namespace signorini;
namespace fs = std::filesystem;

void become_whole(char** argv) {
  std::error_code unknown;
  const fs::path own = fs::read_symlink("/proc/self/exe", unknown);
  const fs::path whole = own.parent_path() / "signorini-backends";
  if (unknown || own == whole || !fs::exists(whole, unknown)) return;
  execv(whole.c_str(), argv);
}

bool has_backend(const std::string& name) {
  const std::vector<Backend>& family = backends();
  return std::any_of(family.begin(), family.end(),
                     [&](const Backend& member) { return member.name == name; });
}

int help(const Team& team, const std::string& file) {
  return team.help([&](const std::string& content) {
    const SceneFile scene = parse_scene(content, file, folder_of(file));
    return stiffness_share(plan(scene.scene).bodies, team.rank - 1, team.size - 1);
  });
}

void count_members(const Team* team, Ledger& ledger) {
  if (team == nullptr) return;
  int process = 0;
  for (const TeamMember& member : team->members()) {
    const Ledger::Phase phase(ledger, text("process ", process++));
    ledger.count("peak bytes", member.peak_bytes);
    ledger.count("stiffness entries", member.stiffness_entries);
    ledger.count("operations", static_cast<long long>(member.operations));
  }
}

}  // namespace command_line
