// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The values of a TOML text, each with the line that it stands in.
#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "signorini/core/errors.hpp"
#include "signorini/fem/mesh.hpp"

namespace signorini {

/// Where a text came from.
struct Origin {
  std::string name;              ///< of the file, for messages
  std::filesystem::path folder;  ///< in which files that it names are looked for
  /// Meshes of files that were read for one body and wait for theirs, so that a file is read once.
  mutable std::map<std::filesystem::path, std::vector<Mesh>> waiting = {};
  /// What a user should know of files that it names, each once.
  mutable std::set<std::string> notes = {};
  /// Files that it names and that were read.
  mutable std::set<std::filesystem::path> files = {};
};

/// One value of a TOML text.
struct Value {
  /// What it is.
  enum class Kind { Text, Number, Truth, Time, List, Table };
  Kind kind = Kind::Table;               ///< what it is
  std::string name;                      ///< its key; empty within a list
  std::string path;                      ///< what messages call it, such as `body.mesh.size`
  std::size_t line = 1;                  ///< where it stands, from 1
  std::shared_ptr<const Origin> origin;  ///< of the text
  std::string text = {};                 ///< of a text
  double number = 0;                     ///< of a number
  bool truth = false;                    ///< of true and false
  std::vector<Value> items = {};         ///< of a list, or of a table in the order of the text

  /// \param member  name of a key of this table
  /// \return its value, or null if there is none
  [[nodiscard]] const Value* find(std::string_view member) const;
  /// \return the values of a list, or this value alone
  [[nodiscard]] std::vector<const Value*> one_or_several() const;
  /// \return what a message may show of it, such as "the text 'left'" or "a list of 3"
  [[nodiscard]] std::string shown() const;

  /// Refuses the value. \param parts  of the message, without place
  /// \throws ProblemError `NAME:LINE: PATH: ...` always
  template <typename... Parts>
  [[noreturn]] void fail(const Parts&... parts) const {
    throw ProblemError(
        signorini::text(origin->name, ":", line, ": ", path, path.empty() ? "" : ": ", parts...));
  }
  /// Runs a step that takes what this value says, and puts its place before messages that have none.
  /// \param step  function without arguments
  /// \return what the step returns
  /// \throws ProblemError for a ProblemError or std::invalid_argument of the step
  template <typename Step>
  auto explain(const Step& step) const -> decltype(step()) {
    try {
      return step();
    } catch (const std::invalid_argument& error) {
      fail(error.what());
    } catch (const ProblemError& error) {
      if (std::string_view(error.what()).substr(0, origin->name.size() + 1) == origin->name + ":")
        throw;
      fail(error.what());
    }
  }
};

/// Reads a TOML text.
/// \param content  the text
/// \param origin   where it came from
/// \return the table of the whole text
/// \throws ProblemError `NAME:LINE: ...` if it is no TOML
[[nodiscard]] Value parse_toml(std::string_view content, Origin origin);

}  // namespace signorini
