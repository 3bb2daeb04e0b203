// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Lines of a Gmsh file, and the physical groups that it names.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "addons/text/text_reader.hpp"

namespace signorini {

/// A Gmsh file, line by line. It has no comments but those in sections of their own.
class GmshText : public TextReader {
 public:
  /// \param content  the whole text; must outlive this
  /// \param name     of the file, for messages
  GmshText(std::string_view content, std::string name) : TextReader(content, std::move(name), "") {}

  /// Goes on to the next line, one of `count` that hold a thing each.
  /// \param things  what they hold, for messages
  /// \param done    how many of them were read
  /// \param count   how many the file announced
  /// \return the first word of the line
  /// \throws ProblemError if the text or the section ends here
  std::string_view first_word(const char* things, std::int64_t done, std::int64_t count);
  /// The next word of this line as a whole number.
  /// \param what   name of the number, for messages
  /// \param least  smallest number that makes sense
  /// \param most   largest number that makes sense
  /// \return the number
  /// \throws ProblemError if the word is anything else
  std::int64_t next(const char* what, std::int64_t least = 0, std::int64_t most = largest_tag);
  /// Goes on to the next line, which must hold counts and nothing else.
  /// \param what  names of the counts, for messages
  /// \return them
  /// \throws ProblemError if the line holds anything else
  std::vector<std::int64_t> counts(const std::vector<const char*>& what);

  /// Largest tag that is read.
  static constexpr std::int64_t largest_tag = INT64_MAX;
  /// Ends a message about a file that contradicts itself.
  static constexpr const char* again =
      "; the file is cut off or was changed: let Gmsh write it again";
};

/// Physical groups: which entities are in which, and what they are called.
class GmshGroups {
 public:
  /// Reads the lines of `$PhysicalNames`.
  /// \param in  at the head of the section
  /// \throws ProblemError if they are anything else, or a group has two names
  void read_names(GmshText& in);
  /// Reads the lines of `$Entities`.
  /// \param in  at the head of the section
  /// \throws ProblemError if they are anything else, or an entity comes twice
  void read_entities(GmshText& in);

  /// Adds a group. \param dimension  1 or 2 \param name  of the group \return its tag, above those that were added before
  std::int64_t add(int dimension, const std::string& name);

  /// The set of groups that an entity is in.
  /// \param in         for messages
  /// \param dimension  of the entity
  /// \param tag        of the entity
  /// \return number of the set; 0 if the file has no entities
  /// \throws ProblemError if the file has entities, but not this one
  [[nodiscard]] std::size_t set_of(const GmshText& in, int dimension, std::int64_t tag) const;
  /// Numbers a set of groups.
  /// \param tags  of physical groups; 0 is none, the sign tells a direction and is dropped
  /// \return number of the set, the same for the same groups; 0 if there are none
  std::size_t set_of(std::vector<std::int64_t> tags);
  /// \param set  its number
  /// \return the tags of its groups, increasing
  [[nodiscard]] const std::vector<std::int64_t>& tags(std::size_t set) const { return sets_[set]; }
  /// \param dimension  1 or 2
  /// \param tag        of a physical group
  /// \return its name; without one `curve TAG` or `surface TAG`
  [[nodiscard]] std::string name(int dimension, std::int64_t tag) const;

  /// Dimension and tag of an entity or of a physical group.
  using Key = std::pair<int, std::int64_t>;
  /// \return the groups that have a name
  [[nodiscard]] const std::map<Key, std::string>& names() const { return names_; }

 private:
  void read_entity(GmshText& in, int dimension, std::string_view first);

  bool has_entities_ = false;
  std::int64_t added_ = 0;
  std::map<Key, std::string> names_;
  std::map<Key, std::size_t> entities_;  // their sets
  std::vector<std::vector<std::int64_t>> sets_ = {{}};
  std::map<std::vector<std::int64_t>, std::size_t> numbers_;  // of the sets
};

}  // namespace signorini
