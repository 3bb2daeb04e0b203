// # Numbers for viewers, to the last bit
//
// Numbers of a VTU file stand where they are named, as text, or all together behind the text, as the
// bytes that the machine has:
//
//     <DataArray type="Float64" Name="points" NumberOfComponents="3" format="appended" offset="0"/>
//     ...
//     <AppendedData encoding="raw">
//     _ numbers, byte by byte
//
// An array says at which byte behind the underscore it begins. There its size in bytes stands first,
// in eight bytes, and then its numbers. For nine points with three coordinates that is
// 8 + 9 * 3 * 8 = 224 bytes. As text a number takes up to 24 bytes, and a viewer has to make a number
// of it again. Whoever wants to look at numbers, or to compare files line by line, asks for text. Both
// hold the same bits: 17 digits give back every double.

#include "addons/vtu/vtu_arrays.hpp"

#include <iomanip>
#include <limits>

namespace signorini {
namespace {

// What an array holds, in the words of VTK.
const char* type_of(double) { return "Float64"; }
const char* type_of(std::int64_t) { return "Int64"; }
const char* type_of(std::uint8_t) { return "UInt8"; }

}  // namespace

VtuArrays::VtuArrays(VtuNumbers numbers) : binary_(numbers == VtuNumbers::Binary) {
  text_ << std::setprecision(std::numeric_limits<double>::max_digits10);
}

// A number goes behind the others as it lies in memory, with no blank between.
template <typename Number>
void VtuArrays::append(Number value) {
  appended_.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// As text, a row of numbers is a line, so that a file can be compared with another. The plus sign makes
// a number of what would be printed as a letter.
template <typename Number>
void VtuArrays::write(const char* name, const std::string& more, const Number* values,
                      std::size_t rows, std::size_t columns) {
  text_ << "        <DataArray type=\"" << type_of(Number()) << "\" Name=\"" << name << '"' << more;
  if (binary_) {
    text_ << " format=\"appended\" offset=\"" << appended_.size() << "\"/>\n";
    append(static_cast<std::uint64_t>(sizeof(Number) * rows * columns));
    for (std::size_t k = 0; k < rows * columns; ++k) append(values[k]);
    return;
  }
  text_ << " format=\"ascii\">\n";
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t k = 0; k < columns; ++k)
      text_ << +values[row * columns + k] << (k + 1 < columns ? ' ' : '\n');
  text_ << "        </DataArray>\n";
}

// VTK knows vectors of three numbers only, so those of the plane get a zero.
void VtuArrays::reals(const char* name, const FieldRows& values, Eigen::Index components,
                      const std::vector<const char*>& parts) {
  std::string more = signorini::text(" NumberOfComponents=\"", components, '"');
  for (std::size_t k = 0; k < parts.size(); ++k)
    more += signorini::text(" ComponentName", k, "=\"", parts[k], '"');
  FieldRows all = FieldRows::Zero(values.rows(), components);
  all.leftCols(values.cols()) = values;
  write(name, more, all.data(), static_cast<std::size_t>(all.rows()),
        static_cast<std::size_t>(components));
}

// Numbers of bodies, contacts and statuses are kept as doubles here, and written as what they are: a
// viewer makes no colours between two of them.
void VtuArrays::wholes(const char* name, const FieldRows& values) {
  const std::vector<std::int64_t> all(values.data(), values.data() + values.size());
  write(name, " NumberOfComponents=\"1\"", all.data(), all.size(), 1);
}

// The lists of cells have one number each and no components.
void VtuArrays::list(const char* name, const std::vector<std::int64_t>& values) {
  write(name, "", values.data(), values.size(), 1);
}

void VtuArrays::list(const char* name, const std::vector<std::uint8_t>& values) {
  write(name, "", values.data(), values.size(), 1);
}

// Some readers cut the bytes at the last line end before the tag that closes them, so there is one.
std::string VtuArrays::content() const {
  if (!binary_) return text_.str() + "</VTKFile>\n";
  return text_.str() + "  <AppendedData encoding=\"raw\">\n_" + appended_ +
         "\n  </AppendedData>\n</VTKFile>\n";
}

// In the number 1 of two bytes, the first one is 1 if the lowest byte comes first.
const char* byte_order() {
  const std::uint16_t one = 1;
  return *reinterpret_cast<const unsigned char*>(&one) == 1 ? "LittleEndian" : "BigEndian";
}

}  // namespace signorini
