/// \file
/// Exercise 11.4 - fit of an order. Do not change this file.
#pragma once
#include <cstddef>
#include <vector>

namespace ex11_4 {

/// One mesh of a row.
struct Mesh {
  double h;      ///< size of its cells [length], > 0
  double error;  ///< computed less exact, with its sign; in any unit
};

/// The power of h behind a row of errors.
struct Fit {
  double order =
      0;  ///< slope of log|error| against log h, by least squares over the meshes used; 0 if none is
  std::size_t first = 0;  ///< number of the coarsest mesh used
  std::size_t count = 0;  ///< meshes used from there on, neighbours; 0 if the errors have no order
};

/// Fits a power where there is one.
///
/// Two neighbours have the order log(e_k / e_{k+1}) / log(h_k / h_{k+1}), if both errors have one sign and none is 0;
/// else they have none. Used is the longest row of neighbours, of three meshes or more, all of whose orders are positive and no
/// two of which differ by more than `spread`; of several of one length, the finest.
/// \param meshes  from coarse to fine: h falls
/// \param spread  largest difference of two orders [-], not negative
/// \return order and meshes
/// \throws std::invalid_argument if h does not fall or is not positive, a number is not finite, or the spread is negative
[[nodiscard]] Fit fit_of_order(const std::vector<Mesh>& meshes, double spread = 0.25);

}  // namespace ex11_4
