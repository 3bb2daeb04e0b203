// The right to write a file, which one run has at a time.
#pragma once
#include <filesystem>

namespace command_line {

/// Keeps other runs from writing a file: a lock of the system on an empty file beside it, `.NAME.lock`. The system takes
/// it back when a run ends, however it ends, so an empty file that a killed run has left stops no other run.
class FileLock {
 public:
  /// \param file  that will be written
  /// \throws signorini::ProblemError if another run writes it, or nothing can be written beside it
  explicit FileLock(const std::filesystem::path& file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  FileLock(FileLock&&) = delete;
  FileLock& operator=(FileLock&&) = delete;

 private:
  std::filesystem::path name_;
  int descriptor_;
};

}  // namespace command_line
