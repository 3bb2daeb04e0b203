// Three pairs by hand, whose sums and tables are known.
#pragma once
#include <sstream>
#include <string>
#include <vector>

#include "addons/steps/steps.hpp"

namespace signorini_test {

/// Three pairs with slanted normals, the first two closed.
inline signorini::Pairs three_pairs() {
  using namespace signorini;
  Pairs gaps;
  gaps.initial_gap.setZero(3);
  gaps.weight = Eigen::Vector3d(0.5, 1, 0.5);
  gaps.position.resize(3, 2);
  gaps.position << 0, 1, 2, 0, 4, -1;
  gaps.normal.resize(3, 2);
  gaps.normal << 0.6, 0.8, 0, 1, 1, 0;
  gaps.moment = gaps.target_moment = NodeArray::Zero(3, 2);
  gaps.node = {7, 8, 9};
  return gaps;
}

inline signorini::Model three_gaps() {
  using namespace signorini;
  Model model;
  model.pairs = three_pairs();
  model.contacts = {"stone.rim on half plane"};
  model.contact_of = {0, 0, 0};
  return model;
}

inline signorini::Solution three_forces() {
  using namespace signorini;
  Solution solution;
  solution.contact.report.status = SolveStatus::Solved;
  solution.contact.force = Eigen::Vector3d(10, 3, 0);
  solution.contact.gap = Eigen::Vector3d(0, 0, 0.25);
  solution.contact.contact_status = {ContactStatus::Stick, ContactStatus::Stick,
                                     ContactStatus::Open};
  solution.pressure = Eigen::Vector3d(20, 3, 0);
  return solution;
}

/// The first pair slides forward, the second sticks but for rounding, the third is open.
inline signorini::Solution three_forces_with_friction() {
  using namespace signorini;
  Solution solution = three_forces();
  solution.contact.frictional_pairs = {0, 1, 2};
  solution.contact.friction = Eigen::Vector3d(-5, 2, 0);
  solution.contact.slip = Eigen::Vector3d(0.5, 1e-20, -0.125);
  solution.contact.contact_status = {ContactStatus::SlipForward, ContactStatus::Stick,
                                     ContactStatus::Open};
  return solution;
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace signorini_test
