#include "addons/files/gmsh_groups.hpp"

#include <algorithm>

#include "addons/text/letters.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"

namespace signorini {
namespace {

using Whole = std::int64_t;
constexpr Whole largest_group = INT32_MAX;
/// No mesh needs more groups for one entity; without a limit a short file could fill the memory.
constexpr std::size_t most_groups = 16;

}  // namespace

std::string_view GmshText::first_word(const char* things, Whole done, Whole count) {
  const bool more = next_line();
  const std::string_view first = word();
  if (!more || first.front() == '$')
    fail(text("expected ", count, ' ', things, ", got ", done, again));
  return first;
}

Whole GmshText::next(const char* what, Whole least, Whole most) {
  return whole(word(), what, least, most);
}

std::vector<Whole> GmshText::counts(const std::vector<const char*>& what) {
  next_line();
  std::vector<Whole> result;
  result.reserve(what.size());
  for (const char* one : what) result.push_back(next(one));
  expect_end_of_line(text("the ", what.back()));
  return result;
}

void GmshGroups::read_names(GmshText& in) {
  const Whole count = in.counts({"number of physical names"}).front();
  for (Whole k = 0; k < count; ++k) {
    const std::string_view first = in.first_word("physical names", k, count);
    const auto dimension = static_cast<int>(in.whole(first, "dimension", 0, 3));
    const Whole tag = in.next("physical tag", 0, largest_group);
    std::string_view name = in.rest_of_line();
    if (name.size() < 3 || name.front() != '"' || name.back() != '"')
      in.fail("a name in quotation marks", name);
    name = name.substr(1, name.size() - 2);
    if (name.size() > 127 || has_control_characters(name))
      in.fail("a name of at most 127 printed characters", name);
    if (!names_.emplace(Key{dimension, tag}, name).second)
      in.fail(text("physical group ", tag, " of dimension ", dimension, " is named twice"));
  }
}

void GmshGroups::read_entities(GmshText& in) {
  has_entities_ = true;
  const char* const things[] = {"points", "curves", "surfaces", "volumes"};
  const std::vector<Whole> counts = in.counts(
      {"number of points", "number of curves", "number of surfaces", "number of volumes"});
  for (int dimension = 0; dimension < 4; ++dimension) {
    const Whole count = counts[at(dimension)];
    for (Whole k = 0; k < count; ++k)
      read_entity(in, dimension, in.first_word(things[dimension], k, count));
  }
}

void GmshGroups::read_entity(GmshText& in, int dimension, std::string_view first) {
  constexpr Whole any = GmshText::largest_tag;
  const Whole tag = in.whole(first, "entity tag", -any, any);
  for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k)  // its bounds, which nobody asks for
    if (in.word().empty()) in.fail("the bounds of the entity", "");
  std::vector<Whole> groups;
  for (Whole left = in.next("number of physical tags"); left > 0; --left) {
    groups.push_back(in.next("physical tag", -largest_group, largest_group));
    if (groups.size() > most_groups)
      in.fail(text("expected an entity in at most ", most_groups, " physical groups"));
  }
  if (dimension > 0)
    for (Whole left = in.next("number of bounding entities"); left > 0; --left)
      in.next("tag of a bounding entity", -any, any);
  in.expect_end_of_line("the entity");
  if (!entities_.emplace(Key{dimension, tag}, set_of(std::move(groups))).second)
    in.fail(text("entity ", tag, " of dimension ", dimension, " comes twice"));
}

Whole GmshGroups::add(int dimension, const std::string& name) {
  names_.emplace(Key{dimension, ++added_}, name);
  return added_;
}

std::size_t GmshGroups::set_of(const GmshText& in, int dimension, Whole tag) const {
  const auto found = entities_.find({dimension, tag});
  if (found != entities_.end()) return found->second;
  if (has_entities_)
    in.fail(text("entity ", tag, " of dimension ", dimension, " is not in '$Entities'",
                 GmshText::again));
  return 0;
}

std::size_t GmshGroups::set_of(std::vector<Whole> tags) {
  for (Whole& tag : tags) tag = tag < 0 ? -tag : tag;
  std::sort(tags.begin(), tags.end());
  tags.erase(std::unique(tags.begin(), tags.end()), tags.end());
  if (!tags.empty() && tags.front() == 0) tags.erase(tags.begin());
  if (tags.empty()) return 0;
  const auto [place, is_new] = numbers_.emplace(tags, sets_.size());
  if (is_new) sets_.push_back(std::move(tags));
  return place->second;
}

std::string GmshGroups::name(int dimension, Whole tag) const {
  const auto found = names_.find({dimension, tag});
  if (found != names_.end()) return found->second;
  return text(dimension == 1 ? "curve " : "surface ", tag);
}

}  // namespace signorini
