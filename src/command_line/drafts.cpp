#include "command_line/drafts.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <system_error>
#include <utility>

#include "addons/text/letters.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/wording.hpp"

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

/// What a name stands for: itself, or where that link leads to, link by link, whether there is something or not.
fs::path end_of_links(const fs::path& file) {
  constexpr int most = 40;  // links, as of the system
  fs::path place = file;
  std::error_code failed;
  for (int links = 0; fs::is_symlink(fs::symlink_status(place, failed)); ++links) {
    const fs::path next = fs::read_symlink(place, failed);
    require_input(!failed && links < most, "cannot write '", file.string(),
                  "': this link leads in a circle or cannot be read");
    place = place.parent_path() / next;
  }
  return place;
}

/// Whether a name ends like a scene or a mesh, in small letters or in capital ones.
bool ends_like_input(const fs::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending == ".toml" || ending == ".msh" || ending == ".geo" || ending == ".inp";
}

/// Whether a file is what the run has as its standard input, or prints to.
bool is_open_as(int descriptor, const fs::path& file) {
  struct stat here = {}, there = {};
  return stat(file.c_str(), &here) == 0 && fstat(descriptor, &there) == 0 &&
         here.st_dev == there.st_dev && here.st_ino == there.st_ino;
}

void forget(const fs::path& file) {
  std::error_code ignored;
  fs::remove(file, ignored);
}

}  // namespace

Drafts::Drafts(const std::vector<std::string>& files, std::vector<fs::path> read)
    : read_(std::move(read)) {
  for (const std::string& file : files) add(file);
  // In one order for all runs: the one that has the last of those that are wanted by several gets the rest too.
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& a, const Entry& b) { return whole(a.place) < whole(b.place); });
  for (Entry& entry : entries_) entry.lock = std::make_unique<FileLock>(entry.place);
  n_named_ = static_cast<std::ptrdiff_t>(entries_.size());
}

Drafts::~Drafts() {
  for (const Entry& entry : entries_)
    if (!entry.draft.empty()) forget(entry.draft);
}

void Drafts::add(const std::string& file) {
  require_input(!has_control_characters(file), "cannot write ", in_quotes(file),
                ": this name has control characters, such as the end of a line; take another name");
  std::error_code unseen;
  const fs::file_status status = fs::status(file, unseen);
  require_input(!fs::exists(status) || fs::is_regular_file(status), "cannot write '", file,
                "': this is no plain file");
  require_input(!fs::exists(status) || access(file.c_str(), W_OK) == 0, "cannot write '", file,
                "': this file may not be written to; change its mode, or take another name");
  const fs::path place = end_of_links(file);
  require_input(!is_open_as(STDOUT_FILENO, place) && !is_open_as(STDERR_FILENO, place),
                "cannot write '", file,
                "': what is printed goes to this file; give results a file of their own");
  require_input(!ends_like_input(file) && !ends_like_input(place), "cannot write '", file,
                "': results do not replace scenes and meshes, take another name");
  for (const fs::path& read : read_)
    require_input(read == "-" ? !is_open_as(STDIN_FILENO, place) : whole(read) != whole(place),
                  "cannot write '", file, "': results do not replace what they are made from, and ",
                  read == "-" ? "the standard input" : "'" + read.string() + "'",
                  " is read; take another name");
  for (const Entry& other : entries_)
    require_input(whole(other.place) != whole(place), "cannot write '", file,
                  "' twice: give every result a file of its own");
  entries_.push_back({file, place});
}

fs::path Drafts::unused(const fs::path& beside) const {
  const auto taken = [this](const fs::path& name) {
    std::error_code unseen;
    return fs::exists(fs::symlink_status(name, unseen)) ||
           std::any_of(entries_.begin(), entries_.end(),
                       [&](const Entry& entry) { return whole(entry.place) == whole(name); });
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
    entry->lock = std::make_unique<FileLock>(entry->place);
  }
  entry->draft = unused(entry->place);
  // Others may not read what replaces a file before it has the mode of that file.
  std::error_code unseen;
  if (fs::exists(entry->place, unseen))
    close(open(entry->draft.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, S_IRUSR | S_IWUSR));
  return entry->draft;
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
    if (entry.published) fs::remove(entry.place, ignored);
    if (entry.before.empty()) continue;
    fs::rename(entry.before, entry.place, ignored);
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
    const fs::file_status status = fs::status(entry.place, unseen);
    if (fs::is_regular_file(status)) {
      fs::permissions(entry.draft, status.permissions(), unseen);
      const fs::path before = unused(entry.place);
      fs::create_hard_link(entry.place, before,
                           failed);  // so that there is a file of this name all the time
      if (failed) fs::rename(entry.place, before, failed);
      if (!failed) entry.before = before;
    }
    if (!failed) fs::rename(entry.draft, entry.place, failed);
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
