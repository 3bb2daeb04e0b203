#include "command_line/file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <mutex>
#include <set>
#include <system_error>

#include "command_line/run_monitor.hpp"
#include "signorini/core/errors.hpp"

namespace command_line {
namespace {

using namespace signorini;
namespace fs = std::filesystem;

/// Opens a file, which is created if there is none, and locks it. A file system that has no locks grants them to all.
/// \return its descriptor; -1 if it cannot be opened, then errno says why, or is EWOULDBLOCK if another process has the lock
int opened(const fs::path& name) {
  const int descriptor = open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (descriptor < 0 || flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK)
    return descriptor;
  close(descriptor);
  errno = EWOULDBLOCK;
  return -1;
}

/// The names of the locks that this process has, for an interruption to remove.
struct Held {
  std::mutex guard;
  std::set<fs::path> names;
};

Held& held() {
  static Held all;
  return all;
}

void remember(const fs::path& name) {
  static const bool told = [] {
    do_last([] {
      const std::lock_guard<std::mutex> lock(held().guard);
      for (const fs::path& one : held().names) unlink(one.c_str());
    });
    return true;
  }();
  static_cast<void>(told);
  const std::lock_guard<std::mutex> lock(held().guard);
  held().names.insert(name);
}

}  // namespace

FileLock::FileLock(const fs::path& file)
    : name_(file.parent_path() / ("." + file.filename().string() + ".lock")) {
  // A run that ends removes the name before it gives the lock back: who gets that lock has one on a file without a name.
  for (struct stat status = {}; status.st_nlink == 0;) {
    descriptor_ = opened(name_);
    const int error = errno;
    require_input(
        descriptor_ >= 0 || error != EWOULDBLOCK, "cannot write '", file.string(),
        "': another run is writing it. Let that one end first, or give this run files of its own");
    const std::string reason = std::generic_category().message(error);
    std::error_code unseen;
    require_input(descriptor_ >= 0 || !fs::exists(fs::symlink_status(name_, unseen)),
                  "cannot write '", file.string(), "': its lock '", name_.string(),
                  "' cannot be opened (", reason, "); remove that if no other run writes");
    require_input(descriptor_ >= 0, "cannot write '", file.string(), "' (", reason,
                  "): give a folder that exists, has room and may be written to");
    fstat(descriptor_, &status);
    if (status.st_nlink == 0) close(descriptor_);
  }
  remember(name_);
}

FileLock::~FileLock() {
  const std::lock_guard<std::mutex> lock(held().guard);
  held().names.erase(name_);
  unlink(name_.c_str());
  close(descriptor_);
}

}  // namespace command_line
