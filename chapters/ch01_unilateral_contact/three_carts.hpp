// Chapter 1 - Three carts and their stops, for the programs that solve and draw them.
#pragma once
#include "signorini/problem/problem.hpp"

namespace ch01 {

using namespace signorini;
using Eigen::Vector3d;

/// A wall and three carts in a row, joined by springs of 1 N/mm; 4 N pull at the last cart.
// [carts]
inline DenseProgramme three_carts() {
  DenseProgramme carts;
  carts.stiffness.resize(3, 3);
  carts.stiffness << 2, -1, 0, /**/ -1, 2, -1, /**/ 0, -1, 1;  // K [N/mm]
  carts.load = Vector3d(0, 0, 4);                              // p [N]
  carts.A = Eigen::Matrix3d::Identity();                       // each cart has its own stop
  carts.initial_gap = Vector3d(2, 7, 9);                       // g [mm]
  return carts;
}
// [carts]

}  // namespace ch01
