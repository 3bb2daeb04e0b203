#include "command_line/drafts.hpp"

#include <algorithm>
#include <iterator>
#include <system_error>
#include <utility>

#include "signorini/core/errors.hpp"

namespace command_line {
namespace {

using namespace signorini;
namespace fs = std::filesystem;

/// From the root, without detours.
fs::path whole(const fs::path& name) {
  std::error_code failed;
  const fs::path full = fs::absolute(name);
  fs::path found = fs::weakly_canonical(full, failed);
  return failed ? full.lexically_normal() : found;
}

void forget(const fs::path& file) {
  std::error_code ignored;
  fs::remove(file, ignored);
}

}  // namespace

Drafts::Drafts(const std::vector<std::string>& files, std::string read) : read_(std::move(read)) {
  for (const std::string& file : files) add(file);
  // In one order for all runs: the one that has the last of those that are wanted by several gets the rest too.
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& a, const Entry& b) { return whole(a.file) < whole(b.file); });
  for (Entry& entry : entries_) entry.lock = std::make_unique<FileLock>(entry.file);
  n_named_ = static_cast<std::ptrdiff_t>(entries_.size());
}

Drafts::~Drafts() {
  for (const Entry& entry : entries_)
    if (!entry.draft.empty()) forget(entry.draft);
}

void Drafts::add(const std::string& file) {
  std::error_code unseen;
  const fs::file_status status = fs::status(file, unseen);
  require_input(!fs::exists(status) || fs::is_regular_file(status), "cannot write '", file,
                "': this is no plain file");
  const std::string ending = fs::path(file).extension().string();
  require_input(ending != ".toml" && ending != ".msh" && ending != ".geo" && ending != ".inp" &&
                    whole(file) != whole(read_),
                "cannot write '", file,
                "': results do not replace scenes and meshes, take another name");
  for (const Entry& other : entries_)
    require_input(whole(other.file) != whole(file), "cannot write '", file,
                  "' twice: give every result a file of its own");
  entries_.push_back({file});
}

fs::path Drafts::unused(const fs::path& beside) const {
  const auto taken = [this](const fs::path& name) {
    std::error_code unseen;
    return fs::exists(fs::symlink_status(name, unseen)) ||
           std::any_of(entries_.begin(), entries_.end(),
                       [&](const Entry& entry) { return whole(entry.file) == whole(name); });
  };
  for (int number = 1;; ++number) {
    fs::path name = beside;
    name += text(".draft", number);
    if (!taken(name)) return name;
  }
}

fs::path Drafts::begin(const std::string& file) {
  auto entry = std::find_if(entries_.begin(), entries_.end(),
                            [&](const Entry& one) { return one.file == file; });
  if (entry == entries_.end()) {
    add(file);
    entry = std::prev(entries_.end());
    entry->lock = std::make_unique<FileLock>(file);
  }
  return entry->draft = unused(entry->file);
}

std::string Drafts::in_words(std::string message) const {
  for (const Entry& entry : entries_)
    if (const std::size_t at = message.find(entry.draft.string());
        !entry.draft.empty() && at != std::string::npos)
      message.replace(at, entry.draft.string().size(), entry.file.string());
  return message;
}

void Drafts::take_back() {
  for (const Entry& entry : entries_) {
    std::error_code ignored;
    if (entry.published) fs::remove(entry.file, ignored);
    if (entry.before.empty()) continue;
    fs::rename(entry.before, entry.file, ignored);
    forget(entry.before);  // renamed onto itself, a link stays
  }
}

void Drafts::publish(const std::function<void()>& write) {
  try {
    write();
  } catch (const ProblemError& error) {  // of a draft, which nobody has asked for by this name
    throw ProblemError(in_words(error.what()));
  }
  for (Entry& entry : entries_) {
    if (entry.draft.empty()) continue;
    std::error_code unseen, failed;
    if (fs::is_regular_file(fs::status(entry.file, unseen))) {
      const fs::path before = unused(entry.file);
      fs::create_hard_link(entry.file, before,
                           failed);  // so that there is a file of this name all the time
      if (failed) fs::rename(entry.file, before, failed);
      if (!failed) entry.before = before;
    }
    if (!failed) fs::rename(entry.draft, entry.file, failed);
    entry.published = !failed;
    if (failed) take_back();
    require_input(!failed, "cannot write '", entry.file.string(), "' (", failed.message(), ')');
  }
  for (Entry& done : entries_) {
    if (!done.before.empty()) forget(done.before);
    done.draft.clear();
    done.before.clear();
    done.published = false;
  }
  entries_.erase(entries_.begin() + n_named_, entries_.end());
}

}  // namespace command_line
