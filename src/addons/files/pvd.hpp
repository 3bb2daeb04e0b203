// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// A film of load steps.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace signorini {

/// A file of the fields at one time.
struct TimedFile {
  double time = 0;   ///< of the load step [time]
  std::string file;  ///< its name, in the folder of the collection
};

/// Writes which files belong to which times: a PVD collection, which ParaView opens as one animation.
/// \param file   to be written, in a folder that exists
/// \param files  in the order of their times
/// \throws ProblemError if the file cannot be written, or XML cannot hold one of the names
void write_pvd(const std::filesystem::path& file, const std::vector<TimedFile>& files);

/// \param content  of a file that write_pvd() wrote \return its files; none of another content
[[nodiscard]] std::vector<TimedFile> read_pvd(const std::string& content);

}  // namespace signorini
