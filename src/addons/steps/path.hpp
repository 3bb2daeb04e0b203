/// \file
/// Load steps as a scene asks for them, and the parts that the loads of a model are made of.
#pragma once
#include <string>
#include <vector>

#include "signorini/fem/assembly.hpp"

namespace signorini {

/// A number that depends on time: straight between the rows of a table, constant before and behind it.
struct History {
  std::string name;            ///< that loads, temperatures, supports and interferences refer to
  std::vector<double> times;   ///< increasing [time]
  std::vector<double> values;  ///< as many: what the entry of the scene is multiplied by then [-]

  /// \param time  any [time] \return the value then [-]
  [[nodiscard]] double at(double time) const;
};

/// Refuses a history that is none. \param history  any
/// \throws ProblemError unless its times are finite and increase and it has as many finite values
void check_history(const History& history);

/// \param name  of the history \return 0 at time 0, 1 at time 1, straight between
[[nodiscard]] History proportional(const std::string& name);

/// \param steps  how many, at least 1 \param end  time of the last one, > 0 [time]
/// \return `steps` times at equal distances, the last one `end` [time]
[[nodiscard]] std::vector<double> equal_steps(int steps, double end = 1);

/// Load steps. What names no history is there in full from the first step on.
///
/// Time only orders the steps. At time 0, before the first, nothing has slipped.
struct Path {
  std::vector<double> times;       ///< of the steps, increasing, the first > 0 [time]
  std::vector<History> histories;  ///< with names of their own
  int halvings = 6;  ///< how often in a row a step that fails is halved before the path ends
};

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

/// \param path  with all histories \param part  of its loads \param time  any [time]
/// \return what the part is multiplied by then [-]
/// \throws ProblemError if the path has no such history
[[nodiscard]] double factor_of(const Path& path, const LoadPart& part, double time);

}  // namespace signorini
