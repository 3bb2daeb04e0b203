/// \file
/// Load steps as a scene asks for them, and the parts that the loads of a model are made of. The add-on steps solves them.
///
/// Friction depends on the order in which loads come, so a scene may say how they grow. Each load, given displacement or
/// interference names a history \f$ h_k(t) \f$, and the model has one load \f$ p_k \f$ per history:
/// \f[ p(t) = p_0 + \sum_k h_k(t)\, p_k. \f]
/// and likewise one share of g. K and A do not depend on time. So all steps share one factor of K and one compliance.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "signorini/fem/assembly.hpp"

namespace signorini {

/// A number that depends on time: straight between the rows of a table, constant before and behind it.
///
/// With the rows (1, 0) and (2, 4) it is 0 at time 0.5, 2 at time 1.5 and 4 at time 5.
struct History {
  std::string name;            ///< that loads, temperatures, supports and interferences refer to
  std::vector<double> times;   ///< increasing [time]
  std::vector<double> values;  ///< as many: what the entry of the scene is multiplied by then [-]

  /// \param time  any [time] \return the value then [-]
  [[nodiscard]] double at(double time) const;
};

inline double History::at(double time) const {
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  if (after == times.begin()) return values.front();
  const std::size_t k = static_cast<std::size_t>(after - times.begin()) - 1;
  if (time == times[k] || after == times.end()) return values[k];
  return values[k] + (values[k + 1] - values[k]) * ((time - times[k]) / (times[k + 1] - times[k]));
}

/// Load steps. What names no history is there in full from the first step on.
///
/// Time only orders the steps. At time 0, before the first, nothing has slipped.
struct Path {
  std::vector<double> times;       ///< of the steps, increasing, the first > 0 [time]
  std::vector<History> histories;  ///< with names of their own
  int halvings = 6;  ///< how often in a row a step that fails is halved before the path ends
};

/// \param histories  of a path \param name  of one, or empty: of what is always there \param time  any [time]
/// \return what loads of that history are multiplied by then; 1 of one that is not there, which a plan refuses [-]
[[nodiscard]] inline double factor_of(const std::vector<History>& histories, const std::string& name,
                                      double time) {
  for (const History& history : histories)
    if (history.name == name) return history.at(time);
  return 1;
}

/// What grows with one history: the entries of a scene that name it, and what they do where it is 1.
struct LoadPart {
  std::string history;                   ///< empty: of what is always there
  std::vector<Loads> loads;              ///< of each body
  std::vector<Eigenstrain> eigenstrain;  ///< of each body, none if empty
  std::vector<NodeArray> held;   ///< `n_nodes x 2` given displacements of each body [length]
  Eigen::VectorXd interference;  ///< `n_c` [length]
  Eigen::VectorXd load;          ///< its share of p `n` [force]
  Eigen::VectorXd movement;      ///< its share of g `n_c + n_s`: gaps, then slips [length]
};

}  // namespace signorini
