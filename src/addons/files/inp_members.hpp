// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// What the sets of an input file hold.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "addons/files/inp_records.hpp"
#include "signorini/core/errors.hpp"

namespace signorini {

/// Places in a list.
using InpPlaces = std::vector<std::size_t>;

/// Where in a list the numbers of a file stand.
class InpNumbers {
 public:
  /// \param number  of the file
  /// \param place   where in the list it stands
  void add(std::int64_t number, std::size_t place) { order_.emplace_back(number, place); }
  /// Sorts them, after the last has been added.
  /// \param file     for messages
  /// \param what     has the numbers, for messages
  /// \param line_of  gives the line of a place
  /// \throws ProblemError if two have one number
  template <typename LineOf>
  void end(const std::string& file, const char* what, const LineOf& line_of) {
    std::sort(order_.begin(), order_.end());
    for (std::size_t k = 1; k < order_.size(); ++k)
      require_input(order_[k].first != order_[k - 1].first, file, ":", line_of(order_[k].second),
                    ": ", what, ' ', order_[k].first, " stands here and in line ",
                    line_of(order_[k - 1].second), "; give each its own number");
  }
  /// \param number  of the file
  /// \return where it stands, if it does
  [[nodiscard]] std::optional<std::size_t> find(std::int64_t number) const {
    const auto place = from(number);
    if (place == order_.end() || place->first != number) return {};
    return place->second;
  }
  /// Adds the places of those that an entry of a set means.
  /// \param entry  with numbers
  /// \param into   gets them
  void put(const InpEntry& entry, InpPlaces& into) const {
    for (auto at = from(entry.first); at != order_.end() && at->first <= entry.last; ++at)
      if ((at->first - entry.first) % entry.step == 0) into.push_back(at->second);
  }

 private:
  using Order = std::vector<std::pair<std::int64_t, std::size_t>>;
  [[nodiscard]] Order::const_iterator from(std::int64_t number) const {
    return std::lower_bound(order_.begin(), order_.end(),
                            std::pair<std::int64_t, std::size_t>{number, 0});
  }
  Order order_;
};

/// What sets hold, looked up once each.
class InpMembers {
 public:
  /// \param sets     that are looked up; must outlive this
  /// \param numbers  of what the sets hold; must outlive it too
  InpMembers(const InpSets& sets, const InpNumbers& numbers) : sets_(&sets), numbers_(&numbers) {}
  /// \param key  of a set
  /// \return places, increasing, each once
  const InpPlaces& of(const std::string& key) {
    const auto [known, is_new] = known_.emplace(key, InpPlaces{});
    if (!is_new) return known->second;
    InpPlaces all;
    for (const InpEntry& entry : sets_->at(key).entries) put(entry, all);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return known->second = std::move(all);
  }
  /// Adds what an entry holds.
  /// \param entry  of a set
  /// \param into   gets its places
  void put(const InpEntry& entry, InpPlaces& into) {
    if (entry.set.empty()) return numbers_->put(entry, into);
    const InpPlaces& other = of(entry.set);
    into.insert(into.end(), other.begin(), other.end());
  }

 private:
  const InpSets* sets_;
  const InpNumbers* numbers_;
  std::map<std::string, InpPlaces> known_;
};

}  // namespace signorini
