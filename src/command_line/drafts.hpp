// Files that are complete from the moment they have their names.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace command_line {

/// Files that appear all together or not at all.
class Drafts {
 public:
  /// \param files  that will appear
  /// \param read   what the run was read from
  /// \throws signorini::ProblemError if two of them are the same, or one is a folder or a device, or what the run was
  ///   read from, or ends like a scene or a mesh
  Drafts(const std::vector<std::string>& files, const std::string& read);
  ~Drafts();
  Drafts(const Drafts&) = delete;
  Drafts& operator=(const Drafts&) = delete;
  Drafts(Drafts&&) = delete;
  Drafts& operator=(Drafts&&) = delete;
  /// \param file  one of them \return what to write it as until it appears; nothing has this name
  std::filesystem::path begin(const std::string& file);
  /// Has all files written and gives them their names; what they replace is there until then.
  /// \param write  begins and writes each
  /// \throws signorini::ProblemError of `write`, in the words of people who know no drafts, or naming the first file that
  ///   cannot have its name; then all is as it was before
  void publish(const std::function<void()>& write);

 private:
  struct Entry {
    std::filesystem::path file;
    std::filesystem::path draft = {};  // empty until it is begun
    std::filesystem::path before =
        {};  // what the file of this name is called meanwhile; empty if there is none
    bool published = false;
  };
  [[nodiscard]] std::string in_words(std::string message) const;
  [[nodiscard]] std::filesystem::path unused(const std::filesystem::path& beside) const;
  void take_back();

  std::vector<Entry> entries_;
};

}  // namespace command_line
