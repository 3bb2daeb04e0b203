// Which motions contact holds, whatever the motions are measured in.
#include <string>
#include <vector>

#include "catch_compat.hpp"
#include "signorini/scene/bodies.hpp"

using namespace signorini;

TEST_CASE("a motion is held or not in whatever unit it is written", "[scene][floating][units]") {
  // Three motions of three unknowns; the contacts feel the first two.
  const Eigen::SparseMatrix<double, Eigen::RowMajor> A =
      Eigen::MatrixXd(Eigen::MatrixXd::Identity(2, 3)).sparseView();
  for (const double unit : {1.0, 1e-20}) {
    std::vector<FreeMotion> modes(3);
    for (int k = 0; k < 3; ++k) {
      modes[static_cast<std::size_t>(k)].sentence = std::to_string(k);
      modes[static_cast<std::size_t>(k)].shape = Eigen::Vector3d::Unit(k);
    }
    modes[1].shape *= unit;
    CHECK(motions_without_contact(A, modes) == std::vector<std::string>{"2"});
  }
}
