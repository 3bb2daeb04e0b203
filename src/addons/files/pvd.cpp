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
#include <iterator>
#include <sstream>
#include <utility>

#include "signorini/report/results.hpp"

namespace signorini {
namespace {

/// Characters that XML has for itself, and what stands for them.
constexpr std::pair<char, const char*> entities[] = {
    {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};

// A text between quotation marks of XML.
// The name of a file may hold a quote or an ampersand, which mean something else in XML.
std::string in_xml(const std::string& text) {
  std::string result;
  for (const char c : text) {
    std::string word(1, c);
    for (const auto& [letter, entity] : entities)
      if (c == letter) word = entity;
    result += word;
  }
  return result;
}

// The value of an attribute of a tag, back from XML; empty without it.
// To undo it, the ampersand has to come last: otherwise one that was followed by `lt;` would end as
// a bracket.
std::string attribute(const std::string& tag, const std::string& name) {
  const std::size_t at = tag.find(' ' + name + "=\"");
  if (at == std::string::npos) return {};
  const std::size_t begin = at + name.size() + 3;
  std::string value = tag.substr(begin, tag.find('"', begin) - begin);
  for (std::size_t k = std::size(entities); k-- > 0;)
    for (std::size_t from = 0; (from = value.find(entities[k].second, from)) != std::string::npos;
         ++from)
      value.replace(from, std::char_traits<char>::length(entities[k].second), 1, entities[k].first);
  return value;
}

}  // namespace

// Times are written with 17 digits, so that they are read back as they were. The order of the list
// is the order of the film.
void write_pvd(const std::filesystem::path& file, const std::vector<TimedFile>& files) {
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
