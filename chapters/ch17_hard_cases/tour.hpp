/// \file
/// Chapter 17: everybody is asked about everything, and a solver that lies.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "naive.hpp"
#include "signorini/report/results.hpp"

namespace museum {

/// Who is asked about every exhibit.
/// \return the library as it is, then members and methods by name
inline const std::vector<std::string>& visitors() {
  static const std::vector<std::string> names = {"ours",
                                                 "small_library",
                                                 "lemke",
                                                 "fischer_burmeister",
                                                 "quasi_active_set_literal",
                                                 "q4",
                                                 "node_to_segment",
                                                 "trial_and_error",
                                                 "penalty",
                                                 "soft_springs",
                                                 "uncoupled",
                                                 "lenient_reader"};
  return names;
}

/// \param verdict  any \return a sign that needs no colour
inline const char* icon(Verdict verdict) {
  return verdict == Verdict::Solved    ? "●"
         : verdict == Verdict::Honest  ? "○"
         : verdict == Verdict::Refuted ? "✕"
                                       : "–";
}

/// What became of the exhibits of a room.
struct Tally {
  int exhibits = 0;  ///< in it
  int solved = 0;    ///< by the library
  int alone = 0;     ///< by the library without the add-on certified
  int honest = 0;    ///< refused, or with a status that claims nothing
  int claims = 0;    ///< of a solution, by all others
  int refuted = 0;   ///< of these
};

/// What the tour found.
struct Tour {
  signorini::Table everything;         ///< a row per exhibit, an icon per visitor
  signorini::Table points;             ///< the same in numbers, for the figure
  std::map<std::string, Tally> rooms;  ///< by name, and their sum as ""
};

/// Asks everybody about everything.
/// \param all  exhibits
/// \return verdicts
/// \throws signorini::NotSolved if the library does not end as an exhibit states
inline Tour tour(const std::vector<Case>& all) {
  using signorini::number;
  std::vector<std::string> head = {"room", "exhibit"};
  head.insert(head.end(), visitors().begin(), visitors().end());
  Tour found{signorini::Table(head), signorini::Table({"exhibit", "visitor", "verdict"}), {}};
  int place = 0;
  for (const Case& given : all) {
    Tally tally;
    tally.exhibits = 1;
    std::vector<std::string> row = {given.exhibit.room, given.exhibit.name()};
    int column = 0;
    for (const std::string& visitor : visitors()) {
      const Answer said = column == 0 ? ours(given) : naive_answer(visitor, given);
      const Verdict verdict = judge(given.exhibit, said);
      if (column == 0) {
        if (said.said != given.exhibit.status)
          throw signorini::NotSolved(signorini::text(given.exhibit.file.string(), ": ends as '",
                                                     said.said, "', but the exhibit states '",
                                                     given.exhibit.status, "'"));
        (verdict == Verdict::Solved ? tally.solved : tally.honest) = 1;
      } else if (visitor == "small_library") {
        tally.alone = verdict == Verdict::Solved ? 1 : 0;
      } else if (verdict == Verdict::Solved || verdict == Verdict::Refuted) {
        ++tally.claims;
        tally.refuted += verdict == Verdict::Refuted ? 1 : 0;
      }
      row.emplace_back(icon(verdict));
      found.points.row({number(place), number(column++), number(static_cast<int>(verdict))});
    }
    ++place;
    found.everything.row(row);
    for (Tally* sum : {&found.rooms[given.exhibit.room], &found.rooms[""]}) {
      sum->exhibits += tally.exhibits;
      sum->solved += tally.solved;
      sum->alone += tally.alone;
      sum->honest += tally.honest;
      sum->claims += tally.claims;
      sum->refuted += tally.refuted;
    }
  }
  return found;
}

/// How many lies of a size the certificate sees.
struct Lies {
  int told = 0;      ///< solutions with one force changed
  int caught = 0;    ///< of these
  int failures = 0;  ///< ends without a solution, called solved
  int unmasked = 0;  ///< of these
};

// [lies]
/// A solver that lies, as the control of the certificate.
/// \param all    exhibits; where nothing was posed, nothing can be claimed
/// \param share  of the largest force, by which that force is changed
/// \return what the certificate says of it
inline Lies lie(const std::vector<Case>& all, double share) {
  Lies lies;
  for (const Case& given : all) {
    if (!given.posed) continue;
    const Answer said = ours(given);
    const bool seen = !forged(*given.posed, said, share).holds(accepted);
    (said.solved() ? lies.told : lies.failures) += 1;
    (said.solved() ? lies.caught : lies.unmasked) += seen ? 1 : 0;
  }
  return lies;
}
// [lies]

}  // namespace museum
