/// \file
/// Chapter 17: an exhibit of the museum in tests/hard is one file, a scene or a problem, with statements in the comment
/// lines at its top.
#pragma once
#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "addons/text/text_reader.hpp"
#include "signorini/core/errors.hpp"

namespace museum {

/// A figure that the answer must have.
struct Bound {
  std::string quantity;  ///< name as in `quantity()`
  double value = 0;      ///< what it must be
  double within = 0;     ///< relative to the value; if that is 0, in its unit
};

/// What a method without safeguards makes of it.
struct NaiveClaim {
  std::string method;  ///< name as in `naive_answer()`
  std::string
      gives;  ///< "wrong": claims a solution and is refuted; "stuck": says itself that it has none
};

/// One exhibit.
struct Exhibit {
  std::filesystem::path file;      ///< where it lies
  std::string room;                ///< name of its folder
  std::string content;             ///< all of the file
  std::string symptom;             ///< what one sees
  std::string cause;               ///< why
  std::string source;              ///< where it comes from
  std::string command;             ///< "solve", "lcp", "qp" or "friction"
  std::string status;              ///< "refused", or a status in words
  std::vector<std::string> words;  ///< that the refusal or the notes must say
  std::vector<NaiveClaim> naive;   ///< one or more; none if nothing is posed that it could be given
  std::vector<Bound> bounds;       ///< of a solution one or more, else of what is known
  /// \return its name
  [[nodiscard]] std::string name() const { return file.stem().string(); }
};

/// Reads the statements of an exhibit.
/// \param file     where it lies
/// \param content  of it, `# key: value` lines first
/// \return the exhibit
/// \throws signorini::ProblemError if a statement is missing, unknown or cannot be read
inline Exhibit read_exhibit(const std::filesystem::path& file, std::string content) {
  using signorini::require_input;
  Exhibit exhibit;
  exhibit.file = file;
  exhibit.room = file.parent_path().filename().string();
  exhibit.content = std::move(content);
  std::istringstream lines(exhibit.content);
  for (std::string line; std::getline(lines, line) && line.rfind("# ", 0) == 0;) {
    const std::size_t colon = line.find(": ");
    const std::string key = line.substr(2, colon == std::string::npos ? colon : colon - 2);
    const std::string value = colon == std::string::npos ? "" : line.substr(colon + 2);
    const auto part = [&](const std::string& mark) {  // before and after a mark
      const std::size_t at = value.find(mark);
      require_input(at != std::string::npos, file.string(), ": expected '", mark, "' in '", line,
                    "'");
      return std::pair(value.substr(0, at), value.substr(at + mark.size()));
    };
    if (key == "symptom") {
      exhibit.symptom = value;
    } else if (key == "cause") {
      exhibit.cause = value;
    } else if (key == "source") {
      exhibit.source = value;
    } else if (key == "command") {
      std::istringstream words(value);
      std::string program, path;
      words >> program >> exhibit.command >> path;
      require_input(path == "tests/hard/" + exhibit.room + "/" + file.filename().string(),
                    file.string(), ": its command is about ", path);
    } else if (key == "naive") {
      if (value.rfind("none, ", 0) != 0)
        exhibit.naive.push_back({part(" -> ").first, part(" -> ").second});
    } else if (key == "ours") {
      exhibit.status = value.substr(0, value.find(" \""));
      for (std::size_t at = value.find('"'); at != std::string::npos;) {
        const std::size_t end = value.find('"', at + 1);
        require_input(end != std::string::npos, file.string(), ": a quotation has no end in '",
                      line, "'");
        exhibit.words.push_back(value.substr(at + 1, end - at - 1));
        at = value.find('"', end + 1);
      }
    } else if (key == "bound") {
      const auto [quantity, rest] = part(" = ");
      Bound bound{quantity};
      std::string within;
      std::istringstream numbers(rest);
      numbers >> bound.value >> within >> bound.within;
      require_input(numbers && within == "within", file.string(),
                    ": expected NUMBER within NUMBER in '", line, "'");
      exhibit.bounds.push_back(bound);
    } else {
      throw signorini::ProblemError(file.string() + ": unknown statement '" + key + "'");
    }
  }
  require_input(!exhibit.symptom.empty() && !exhibit.cause.empty() && !exhibit.source.empty() &&
                    !exhibit.command.empty() && !exhibit.status.empty(),
                file.string(), ": symptom, cause, ours, source and command must be stated");
  require_input(exhibit.status != "solved" || !exhibit.bounds.empty(), file.string(),
                ": what is solved has a bound");
  return exhibit;
}

/// The rooms in the order of a visit.
/// \return names of folders of tests/hard
inline const std::vector<std::string>& rooms() {
  static const std::vector<std::string> names = {
      "conditioning", "degeneracy", "dependence", "impossibility", "geometry", "friction", "files"};
  return names;
}

/// All exhibits of a room, by name.
/// \param museum  the folder tests/hard
/// \param room    of rooms()
/// \return the exhibits
/// \throws signorini::ProblemError as read_exhibit()
inline std::vector<Exhibit> exhibits(const std::filesystem::path& museum, const std::string& room) {
  std::vector<Exhibit> all;
  for (const auto& entry : std::filesystem::directory_iterator(museum / room))
    all.push_back(
        read_exhibit(entry.path(), signorini::file_content(entry.path(), std::size_t{1} << 20)));
  std::sort(all.begin(), all.end(),
            [](const Exhibit& a, const Exhibit& b) { return a.file < b.file; });
  return all;
}

}  // namespace museum
