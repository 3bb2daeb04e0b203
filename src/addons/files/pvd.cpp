// # A film of load steps
//
// Each load step has a file of its own. A PVD file lists them with their times, and ParaView opens
// the list as one film:
//
//     <DataSet timestep="0.5" part="0" file="press_1.vtu"/>
//
// A run that goes on where another one ended adds its steps to the list. So the list is read as
// well as written: only what this program writes, a file per line.

#include "addons/files/pvd.hpp"

#include <charconv>
#include <iomanip>
#include <sstream>
#include <utility>

#include "addons/vtu/xml.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/report/results.hpp"

namespace signorini {
namespace {

// The value of an attribute of a tag; empty without it.
std::string attribute(const std::string& tag, const std::string& name) {
  const std::size_t at = tag.find(' ' + name + "=\"");
  if (at == std::string::npos) return {};
  const std::size_t begin = at + name.size() + 3;
  return from_xml(tag.substr(begin, tag.find('"', begin) - begin));
}

}  // namespace

// Times are written with 17 digits, so that they are read back as they were. The order of the list
// is the order of the film.
void write_pvd(const std::filesystem::path& file, const std::vector<TimedFile>& files) {
  for (const TimedFile& one : files)
    require_input(from_xml(in_xml(one.file)) == one.file, "cannot list ", in_quotes(one.file),
                  " in ", in_quotes(file.string()),
                  ": no file of XML can hold this name; take one in UTF-8");
  std::ostringstream out;
  out << std::setprecision(17)
      << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
         "byte_order=\"LittleEndian\">\n  <Collection>\n";
  for (const TimedFile& one : files)
    out << "    <DataSet timestep=\"" << one.time << "\" part=\"0\" file=\"" << in_xml(one.file)
        << "\"/>\n";
  out << "  </Collection>\n</VTKFile>\n";
  write_file(file, out.str());
}

// A line that is not understood is passed over. A list that somebody has changed by hand then has
// fewer steps, and no wrong ones.
std::vector<TimedFile> read_pvd(const std::string& content) {
  std::vector<TimedFile> files;
  std::istringstream lines(content);
  for (std::string tag; std::getline(lines, tag);) {
    const std::string time = attribute(tag, "timestep");
    TimedFile file{0, attribute(tag, "file")};
    const char* const end = time.data() + time.size();
    const auto [rest, failed] = std::from_chars(time.data(), end, file.time);
    if (failed == std::errc() && rest == end && !file.file.empty()) files.push_back(file);
  }
  return files;
}

}  // namespace signorini
