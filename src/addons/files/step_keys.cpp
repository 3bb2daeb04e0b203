#include <algorithm>
#include <set>
#include <utility>

#include "addons/files/scene_keys.hpp"
#include "addons/steps/histories.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/table.hpp"

namespace signorini {
namespace {

constexpr std::size_t most_steps = 1000000;

/// The number of a history; that of the last and one more if there is none of this name.
std::size_t number_of(const std::string& name, const std::vector<History>& histories) {
  const auto found = std::find_if(histories.begin(), histories.end(),
                                  [&](const History& history) { return history.name == name; });
  return at(found - histories.begin());
}

/// The times of some steps, the first of which begins at a time.
void add_times(const Value& item, const StepsDraft& steps, double begin,
               std::vector<double>& times) {
  const Value* const until = item.find("until");
  const Value& place = until ? *until : item;
  const double end = *steps.until;
  if (!(end > begin))
    place.fail("load steps of size zero: they must end after time ", shortest(begin),
               times.empty() ? ", where steps begin" : ", where those before end", ", got ",
               shortest(end));
  if (times.size() + at(steps.count) > most_steps)
    item.fail("at most ", most_steps, " load steps are taken");
  double last = begin;
  for (const double share : equal_steps(steps.count)) {
    times.push_back(share == 1 ? end : begin + share * (end - begin));
    if (!(times.back() > last))
      place.fail("load steps of size zero: ", steps.count, " of them do not fit between time ",
                 shortest(begin), " and ", shortest(end));
    last = times.back();
  }
}

/// What histories without a table reach at the end of some steps. \param tables  how many have one
void add_values(const StepsDraft& steps, double begin, std::size_t tables, SceneDraft& draft) {
  std::vector<History>& histories = draft.histories;
  std::vector<double> reached;
  for (const History& history : histories) reached.push_back(history.values.back());
  if (steps.values != nullptr)
    for (const Value& value : steps.values->items) {
      const std::size_t k = number_of(value.name, histories);
      if (value.name.empty()) value.fail("a history needs a name that loads can refer to");
      if (k < tables)
        value.fail("the history ", in_quotes(value.name), " has its values in line ",
                   draft.places[k]->line, ": leave one of them out");
      if (k == histories.size()) {
        histories.push_back({value.name, {0}, {0}});
        if (begin > 0) {
          histories.back().times.push_back(begin);
          histories.back().values.push_back(0);
        }
        draft.places.push_back(&value);
        reached.push_back(0);
      }
      take(value, reached[k]);
    }
  for (std::size_t k = tables; k < histories.size(); ++k) {
    histories[k].times.push_back(*steps.until);
    histories[k].values.push_back(reached[k]);
  }
}

/// Calls a function with every text that names a history.
template <typename Each>
void each_name(const Value& value, const Each& each) {
  for (const Value& item : value.items) {
    if (item.name == "history" && item.kind == Value::Kind::Text) each(item);
    each_name(item, each);
  }
}

/// \param value  that needs load steps
[[noreturn]] void fail_without_steps(const Value& value) {
  value.fail(
      "has no meaning without [[steps]]: give the scene some, such as [[steps]] with until = 1 and "
      "count = 10, or leave it out");
}

}  // namespace

const Keys<History>& history_keys() {
  static const Keys<History> keys = [] {
    const History usual = proportional("");
    Keys<History> made = {
        required(key("name", &History::name, "", "that loads refer to by history = \"NAME\"")),
        key("times", &History::times, "time", "increasing"),
        key("values", &History::values, "",
            "what loads are multiplied by at these times; straight between, constant beyond")};
    made[1].standard = written(usual.times);
    made[2].standard = written(usual.values);
    return made;
  }();
  return keys;
}

const Keys<StepsDraft>& steps_keys() {
  static const Keys<StepsDraft> keys = {
      {{"until", type_name<double>(Bound::Positive), "time", "1 after those before",
        "when they end; the first begin at time 0"},
       [](const Value& value, StepsDraft& steps) { take(value, steps.until, Bound::Positive); }},
      key("count", &StepsDraft::count, "", "how many of equal size", Bound::Positive),
      {{"values", "table of history = number", "", "",
        "what loads are multiplied by at the end, as { drag = 1 }; straight from where they were, "
        "0 "
        "at first; what is not named stays"},
       [](const Value& value, StepsDraft& steps) {
         if (value.kind != Value::Kind::Table)
           value.fail("expected a table of histories such as { drag = 1 }, got ", value.shown());
         steps.values = &value;
       }}};
  return keys;
}

const std::vector<KeyInfo>& growing_keys() {
  static const std::vector<KeyInfo> keys = {
      {"value", "number or [x, y]", "", "", "as it would be by itself, also one that varies", true},
      {"history", "text", "", "", "what it is multiplied by, a name of [[steps]] or [[history]]",
       true}};
  return keys;
}

void read_histories(const Value& value, SceneDraft& draft) {
  for (const Value* item : value.one_or_several()) {
    History history = proportional("");
    read_members(*item, history_keys(), history);
    if ((item->find("times") == nullptr) != (item->find("values") == nullptr))
      item->fail("give both times and values, or neither");
    item->explain([&] { check_history(history); });
    if (const std::size_t k = number_of(history.name, draft.histories); k < draft.histories.size())
      item->fail("the history of line ", draft.places[k]->line, " is called ",
                 in_quotes(history.name), " too: give every history a name of its own");
    draft.histories.push_back(std::move(history));
    draft.places.push_back(item);
  }
}

void read_steps(const Value& value, SceneDraft& draft) {
  Path& path = draft.file.scene.path.emplace();
  const std::size_t tables = draft.histories.size();
  double begin = 0;
  std::set<std::string> known;
  for (const History& history : draft.histories) known.insert(history.name);
  each_name(*draft.root, [&](const Value& name) { known.insert(name.text); });
  for (const Value* item : value.one_or_several()) {
    StepsDraft steps;
    check_members(*item, infos(steps_keys()), [&](const std::string& name) {
      return known.count(name) == 0 ? "" : text("it is a history: values = { ", name, " = ... }");
    });
    fill(*item, steps_keys(), steps);
    if (!steps.until) steps.until = begin + 1;
    add_times(*item, steps, begin, path.times);
    add_values(steps, begin, tables, draft);
    begin = *steps.until;
  }
  if (path.times.empty()) value.fail("expected one [[steps]] or more");
  path.histories = draft.histories;
}

void check_histories(const SceneDraft& draft) {
  std::vector<std::string> known;
  for (const History& history : draft.histories) known.push_back(history.name);
  std::set<std::string> used;
  each_name(*draft.root, [&](const Value& name) {
    if (!draft.file.scene.path) fail_without_steps(name);
    if (std::find(known.begin(), known.end(), name.text) == known.end())
      name.fail("no history is called ", in_quotes(name.text), suggestion(name.text, known));
    used.insert(name.text);
  });
  for (std::size_t k = 0; k < known.size(); ++k) {
    if (!draft.file.scene.path) fail_without_steps(*draft.places[k]);
    if (used.count(known[k]) == 0)
      draft.places[k]->fail("nothing follows the history ", in_quotes(known[k]),
                            ": give a load history = \"", clipped(known[k]), "\", or leave it out",
                            used.empty() ? "" : suggestion(known[k], {used.begin(), used.end()}));
  }
}

}  // namespace signorini
