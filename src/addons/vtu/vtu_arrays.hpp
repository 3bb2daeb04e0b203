// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The arrays of a VTU file, as text or as bytes.
#pragma once
#include <cstdint>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "addons/vtu/vtu.hpp"
#include "signorini/report/nodal_fields.hpp"

namespace signorini {

/// A VTU file while it is written: its text, and the bytes of numbers that will stand behind it.
class VtuArrays {
 public:
  /// \param numbers  how arrays are written
  explicit VtuArrays(VtuNumbers numbers);

  /// \return the text so far, to go on with
  std::ostream& text() { return text_; }
  /// Writes an array of a row for each node or cell.
  /// \param name        of the array
  /// \param values      its rows
  /// \param components  of each row in the file, those that are missing are 0
  /// \param parts       names of the components; none by default
  void reals(const char* name, const FieldRows& values, Eigen::Index components,
             const std::vector<const char*>& parts = {});
  /// The same of whole numbers, one each. \param name  of the array \param values  `n x 1`
  void wholes(const char* name, const FieldRows& values);
  /// Writes a list of numbers. \param name  of the array \param values  the list
  void list(const char* name, const std::vector<std::int64_t>& values);
  /// Writes a list of small numbers. \param name  of the array \param values  the list
  void list(const char* name, const std::vector<std::uint8_t>& values);
  /// \return the whole file, when its text goes up to the last tag but that of the file
  [[nodiscard]] std::string content() const;

 private:
  template <typename Number>
  void write(const char* name, const std::string& more, const Number* values, std::size_t rows,
             std::size_t columns);
  template <typename Number>
  void append(Number value);

  bool binary_;
  std::ostringstream text_;
  std::string appended_;
};

/// \return which byte of a number comes first on this machine, in the words of VTK
[[nodiscard]] const char* byte_order();

}  // namespace signorini
