// A folder that exists as long as a test needs it.
#pragma once
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

namespace signorini_test {

class Folder {
 public:
  Folder() {
    const std::filesystem::path parent = std::filesystem::temp_directory_path();
    // Tests run side by side: the first free number is ours, because making a folder is one step.
    for (int k = 0; path_.empty(); ++k) {
      const std::filesystem::path candidate = parent / ("signorini_test_" + std::to_string(k));
      if (std::filesystem::create_directory(candidate)) path_ = candidate;
    }
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  Folder(Folder&&) = delete;
  Folder& operator=(Folder&&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// How many files and folders lie in it.
  [[nodiscard]] long entries() const {
    return static_cast<long>(std::distance(std::filesystem::directory_iterator(path_), {}));
  }

 private:
  std::filesystem::path path_;
};

/// All of a text file; empty if there is none.
inline std::string content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream all;
  all << in.rdbuf();
  return all.str();
}

}  // namespace signorini_test
