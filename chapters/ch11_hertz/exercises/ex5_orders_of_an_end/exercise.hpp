/// \file
/// Exercise 11.5 - which orders an end of contact allows. Do not change this file.
#pragma once

namespace ex11_5 {

/// Powers of the size of cells that are all alike; factors ln(1/h) do not count.
struct Orders {
  double energy = 0;    ///< of displacements in the norm of the strain energy [-]
  double pressure = 0;  ///< of the pressure in L2 along the surface [-]; 0 if it has no order, or no L2 norm
  double integral = 0;  ///< of an integral of the pressure, such as a second moment [-]
};

/// \param power      alpha: displacements have a part like r^alpha at the distance r from the end, and are smooth elsewhere [-], > 0
/// \param influence  beta: the same of the solution that says how the integral depends on errors [-], > 0
/// \param degree     p of the elements, at least 1
/// \return the orders
/// \throws std::invalid_argument if a power is not positive or not finite, or the degree is below 1
[[nodiscard]] Orders orders(double power, double influence, int degree);

/// \param part   of the error that is to be left [-], above 0, at most 1
/// \param order  with which it falls [-], > 0
/// \return how many times more cells that takes, in the plane [-]
/// \throws std::invalid_argument if one of them is out of range
[[nodiscard]] double times_more_cells(double part, double order);

}  // namespace ex11_5
