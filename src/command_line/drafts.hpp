// Files that are complete from the moment they have their names.
#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "command_line/file_lock.hpp"

namespace command_line {

/// Files that appear all together or not at all, and that no other run writes while this lives.
class Drafts {
 public:
  /// \param files  that will appear; of a link, what it leads to
  /// \param read   all files that the run was read from
  /// \throws signorini::ProblemError if two of them are the same, or one is a folder or a device, or what the run was
  ///   read from, or where it prints to, or may not be written to, or ends like a scene or a mesh, or has control characters in
  ///   its name, or as FileLock
  Drafts(const std::vector<std::string>& files, std::vector<std::filesystem::path> read);
  ~Drafts();
  Drafts(const Drafts&) = delete;
  Drafts& operator=(const Drafts&) = delete;
  Drafts(Drafts&&) = delete;
  Drafts& operator=(Drafts&&) = delete;
  /// \param file  one of them, or one more that appears with them \return what to write it as until it appears; nothing
  ///   has this name \throws signorini::ProblemError as the constructor, for one more
  std::filesystem::path begin(const std::string& file);
  /// Has files written and gives them their names; what they replace is there until then. May be called again.
  /// \param write  begins and writes those that are to appear
  /// \throws signorini::ProblemError of `write`, in the words of people who know no drafts, or naming the first file that
  ///   cannot have its name; then all is as it was before
  void publish(const std::function<void()>& write);

 private:
  struct Entry {
    std::filesystem::path file;   // as it was asked for
    std::filesystem::path place;  // the same, or where that link leads to
    std::unique_ptr<FileLock> lock = {};
    std::filesystem::path draft = {};  // empty until it is begun
    std::filesystem::path before =
        {};  // what the file of this name is called meanwhile; empty if there is none
    bool published = false;
  };
  void add(const std::string& file);
  [[nodiscard]] std::string in_words(std::string message) const;
  [[nodiscard]] std::filesystem::path unused(const std::filesystem::path& beside) const;
  void take_back();

  std::vector<std::filesystem::path> read_;
  std::vector<Entry> entries_;
  std::ptrdiff_t n_named_ = 0;  // entries behind these appear once
};

}  // namespace command_line
