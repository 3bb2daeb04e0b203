/// \file
/// Exercise 5.6 - every load at once. Do not change this file.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace ex5_6 {

/// A body in contact under a load that grows from 0: gap = initial_gap - t response + compliance * force.
struct Loaded {
  Eigen::MatrixXd compliance;   ///< G `n_c x n_c`, symmetric positive definite [length/force]
  Eigen::VectorXd initial_gap;  ///< g `n_c` > 0 [length]
  Eigen::VectorXd
      response;  ///< r `n_c`: what a unit of load closes each gap by, if nothing touches [length/load]
};

/// A change of the closed pairs.
struct Event {
  double load;        ///< t
  Eigen::Index pair;  ///< which
  bool closes;        ///< or opens
};

/// All loads up to one.
struct Path {
  std::vector<Event> events;  ///< in the order of their loads
  Eigen::VectorXd force;      ///< lambda `n_c` >= 0 at the last load
};

/// Follows the contact forces while the load grows.
/// \param body   no two of its pairs change at the same load
/// \param until  the last load, not negative
/// \return all changes at loads below `until`, and the forces there
/// \throws std::invalid_argument if the sizes do not fit or an initial gap is not positive
[[nodiscard]] Path load_path(const Loaded& body, double until);

}  // namespace ex5_6
