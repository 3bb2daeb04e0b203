#include "command_line/backends.hpp"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "command_line/stiffness_share.hpp"
#include "signorini/core/errors.hpp"

namespace command_line {

using namespace signorini;
namespace fs = std::filesystem;

namespace {

/// Puts the number that one of two variables of the environment holds in the place of another.
void read_variable(const char* first, const char* second, int& number) {
  for (const char* const name : {first, second})
    if (const char* const value = std::getenv(name)) {
      const std::string_view digits(value);
      std::from_chars(digits.data(), digits.data() + digits.size(), number);
      return;
    }
}

}  // namespace

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

Launch launched() {
  Launch launch;
  read_variable("OMPI_COMM_WORLD_RANK", "PMI_RANK", launch.rank);
  read_variable("OMPI_COMM_WORLD_SIZE", "PMI_SIZE", launch.size);
  return launch;
}

int help(const Team& team, const std::string& file) {
  return team.help([&](const std::string& content) {
    const SceneFile scene = parse_scene(content, file, folder_of(file));
    return stiffness_share(scene.scene, team.rank - 1, team.size - 1);
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
