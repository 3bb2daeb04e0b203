// Two stacked blocks under uniform pressure, the contact patch test: any gap operator, any two meshes.
#pragma once
#include <Eigen/Core>
#include <string>

#include "signorini/contact/gap_operators.hpp"

namespace signorini_test {

/// The upper block is the source, the lower one the target.
struct TwoBlocks {
  Eigen::Index source_edges = 8;
  Eigen::Index target_edges = 11;
  double inclination = 0;           ///< of the interface against the x axis [degrees]
  double stiffness_ratio = 1;       ///< Young's modulus of the source over that of the target
  std::string element = "q4";       ///< of both blocks, or of the source
  std::string target_element = {};  ///< of the target if it has another
  bool mixed = false;               ///< every second quadrilateral is cut into two triangles
};

/// What the contact pressure of two blocks came to.
struct PatchResult {
  signorini::Pairs pairs;
  Eigen::VectorXd pressure;  ///< force / weight of each pair
  double exact;              ///< the uniform pressure it should be
  double deviation;          ///< largest |pressure / exact - 1|
};

/// Both blocks stand under the pressure `exact` all around; the lower one stands on rollers, and of the upper
/// one a single node is held sideways: contact alone holds it up and keeps it from turning. The state
/// sigma = -exact I, without shear, is an equilibrium whatever the inclination and the materials, and every
/// element has it in its displacements.
PatchResult press_blocks(const signorini::GapOperator& gap_operator,
                         const signorini::GapOptions& options, const TwoBlocks& blocks);

/// The deviation alone.
double patch_test(const signorini::GapOperator& gap_operator, const signorini::GapOptions& options,
                  Eigen::Index source_edges, Eigen::Index target_edges, double inclination = 0,
                  double stiffness_ratio = 1, const std::string& element = "q4");

}  // namespace signorini_test
