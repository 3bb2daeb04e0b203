#include <algorithm>
#include <cmath>

#include "catch_compat.hpp"
#include "exercise.hpp"
#include "signorini/core/random.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"
#include "signorini/pairing/mortar.hpp"
#include "support/equal_within.hpp"

using Eigen::Index;
using Eigen::VectorXd;

namespace {

VectorXd random_nodes(signorini::Random& random, Index n) {
  VectorXd x(n);
  for (double& at : x) at = random.uniform(0, 3);
  x(0) = 0;
  x(1) = 3;
  std::sort(x.begin(), x.end());
  return x;
}

}  // namespace

TEST_CASE("ex10.2 held out: a straight gap is the gap at the node", "[ex10.2]") {
  signorini::Random random(1);
  for (int sample = 0; sample < 50; ++sample) {
    const VectorXd source = random_nodes(random, 3 + sample % 7);
    const VectorXd target = random_nodes(random, 2 + sample % 5);
    CAPTURE(sample);
    const Eigen::MatrixXd P = ex10_2::projection(source, target);
    CHECK(equal_within(P * VectorXd::Ones(target.size()), VectorXd::Ones(source.size()), 1e-12));
    CHECK(equal_within(P * target, source, 1e-10));  // edges may be short: 1 / length rounds
  }
}

TEST_CASE("ex10.2 held out: the same as the mortar operator of the library", "[ex10.2]") {
  using namespace signorini;
  for (const auto& [above, below] : {std::pair(8, 11), std::pair(11, 8), std::pair(7, 15)}) {
    BlockSpec spec;
    spec.cells_x = below;
    const Mesh lower = make_block(spec);
    spec.cells_x = above;
    const Mesh upper = moved(make_block(spec), {0, 1});
    GapOptions options;
    options.n_nodes = upper.n_nodes() + lower.n_nodes();
    const Pairs pairs = mortar({upper, "bottom", 0}, {lower, "top", upper.n_nodes()}, options);
    const Eigen::MatrixXd P = ex10_2::projection(VectorXd::LinSpaced(above + 1, 0, 1),
                                                 VectorXd::LinSpaced(below + 1, 0, 1));
    const Eigen::MatrixXd opening(pairs.opening);
    for (Index i = 0; i <= above; ++i)
      for (const Index node : boundary_nodes(lower, "top")) {
        const Index j = static_cast<Index>(std::lround(lower.nodes(node, 0) * below));
        CAPTURE(above, below, i, j);
        CHECK(std::abs(opening(i, 2 * (upper.n_nodes() + node) + 1) + P(i, j)) < 1e-12);
      }
  }
}
