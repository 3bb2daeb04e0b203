/// \file
/// Four choices of the quasi-active set, and how their runs end.
#pragma once
#include <algorithm>
#include <array>
#include <string>

#include "signorini/as_printed/quasi_active_set_literal.hpp"
#include "signorini/core/random.hpp"
#include "signorini/core/table.hpp"

namespace signorini {

struct Reading {
  QuasiActiveRows rows;
  const char* name;
};
inline constexpr std::array<Reading, 4> readings = {
    {{QuasiActiveRows::AllViolated, "all violated"},
     {QuasiActiveRows::IndependentByIndex, "independent, by number"},
     {QuasiActiveRows::IndependentByViolation, "independent, by overlap"},
     {QuasiActiveRows::MostViolated, "the most violated"}}};

/// Eight half-spaces and a point outside, K = I, in small whole numbers. As g >= 0, u = 0 is feasible.
inline ContactProblem whole_numbers(Random& random) {
  Eigen::Matrix<double, 8, 3> A;
  Eigen::Matrix<double, 8, 1> g;
  Eigen::Vector3d p;
  do {
    for (double& a : A.reshaped()) a = random.whole(-3, 3);
    for (double& gap : g) gap = random.whole(0, 3);
    for (double& load : p) load = random.whole(-6, 6);
  } while ((g - A * p).minCoeff() >= 0);
  return {A * A.transpose(), g - A * p};
}

/// Whether only the tolerance has ended the loop: before its last step the overlaps were nearly as small
/// as the tolerance, 1e-12 of those at u^0. A loop that ends at a point comes from larger ones.
inline bool went_to_limit(const QuasiActiveRun& run) {
  const auto& history = run.state.report.history;
  const auto last = static_cast<std::size_t>(run.outer_steps) - 1;
  return run.outer_steps > 1 && history[last].penetration < 1e-6 * history[0].penetration;
}

/// How many runs ended how.
struct Ends {
  double one = 0, two = 0, more = 0;    ///< after so many steps
  double optimal = 0, corrected = 0;    ///< of `two` and `more`: u^k, only the end of (35)
  double limit = 0, limit_optimal = 0;  ///< at a limit, and of these the end is optimal
  double stopped = 0;                   ///< did not end

  void add(const Ends& other) {
    one += other.one, two += other.two, more += other.more;
    optimal += other.optimal, corrected += other.corrected;
    limit += other.limit, limit_optimal += other.limit_optimal, stopped += other.stopped;
  }

  void count(const QuasiActiveRun& run) {
    const bool solved = run.state.report.status == Status::Solved;
    if (!solved && run.state.report.status != Status::Feasible) {
      ++stopped;
    } else if (went_to_limit(run)) {
      ++limit;
      limit_optimal += solved ? 1 : 0;
    } else if (run.outer_steps <= 1) {
      ++one;
    } else {
      ++(run.outer_steps == 2 ? two : more);
      optimal += run.optimal ? 1 : 0;
      corrected += solved && !run.optimal ? 1 : 0;
    }
  }
};

/// One run of each reading.
inline std::array<QuasiActiveRun, 4> run_readings(const ContactProblem& problem) {
  std::array<QuasiActiveRun, 4> runs;
  runs[1] = run_quasi_active_set_literal(problem, {}, readings[1].rows);
  const Status status = runs[1].state.report.status;
  const bool ended = status == Status::Solved || status == Status::Feasible;
  const bool took_all =
      std::all_of(runs[1].steps.begin(), runs[1].steps.end(),
                  [](const QuasiActiveStep& step) { return step.quasi_active == step.violated; });
  for (const std::size_t i : {0, 2, 3})  // where all violated rows are independent, three are one
    runs[i] = i < 3 && ended && took_all
                  ? runs[1]
                  : run_quasi_active_set_literal(problem, {}, readings[i].rows);
  return runs;
}

/// Of the four readings.
using Tally = std::array<Ends, 4>;

inline void add_rows(Table& table, const std::string& problems, const Tally& tally) {
  const auto whole = [](double count) { return number(count, "%.0f"); };
  for (std::size_t i = 0; i < 4; ++i) {
    const Ends& e = tally[i];
    table.row({problems, readings[i].name, whole(e.one), whole(e.two), whole(e.more),
               whole(e.optimal), whole(e.optimal + e.corrected), whole(e.limit),
               whole(e.limit_optimal), whole(e.stopped)});
  }
}

inline Table table_of_ends() {
  return Table({"problems", "QAS", "one step", "two", "more", "of these optimal", "after (35)",
                "limit", "of these optimal", "stopped"});
}

}  // namespace signorini
