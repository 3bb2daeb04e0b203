// What every solver should find easy.
#include <algorithm>

#include "addons/programme/dense_programme.hpp"
#include "signorini/core/errors.hpp"
#include "support/classes/classes.hpp"
#include "support/problems.hpp"

namespace signorini_test {

using namespace signorini;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

Instance backwards(std::string name, const MatrixXd& G, const VectorXd& force,
                   const VectorXd& gap) {
  Instance made{std::move(name), {G, gap - G * force}};
  made.gap = gap;
  return made;
}

Instance from_programme(std::string name, const DenseProgramme& programme) {
  const DenseCondensed condensed = condense(programme);
  Instance made{std::move(name), condensed.problem};
  made.programme = programme;
  return made;
}

DenseProgramme projection(const MatrixXd& A, const VectorXd& point, const VectorXd& g) {
  return {MatrixXd::Identity(A.cols(), A.cols()), point, A, g, 0};
}

Instances empty_problem() {
  Instance nothing{"no pair", {MatrixXd(0, 0), VectorXd(0)}};
  nothing.programme = projection(MatrixXd(0, 3), VectorXd::Zero(3), VectorXd(0));
  return {nothing};
}

Instances one_pair() {
  Instances made;
  for (const double d :
       {-9.8, 0.0, 3.0, -1e60, -1e-60, 1e60}) {  // closed form: force = max(0, -d/G)
    Instance pair{text("d = ", d), {MatrixXd::Constant(1, 1, 2), VectorXd::Constant(1, d)}};
    pair.force = VectorXd::Constant(1, std::max(0.0, -d / 2));
    pair.gap = VectorXd::Constant(1, std::max(0.0, d));
    pair.accuracy = 1e-15;
    made.push_back(pair);
  }
  return made;
}

Instances two_pairs() {
  Eigen::Matrix2d G;
  G << 2, 1, 1, 2;
  struct Case {
    Vector2d free_gap, force, gap;
  };
  const Case cases[] = {{{1, 2}, {0, 0}, {1, 2}},     // both open
                        {{-4, 3}, {2, 0}, {0, 5}},    // only the first
                        {{-4, -1}, {2, 0}, {0, 1}},   // the first one opens the second
                        {{1, -6}, {0, 3}, {4, 0}},    // only the second
                        {{-5, -4}, {2, 1}, {0, 0}},   // both closed
                        {{-4, -2}, {2, 0}, {0, 0}}};  // the second just touches
  Instances made;
  for (const Case& known : cases) {
    Instance pairs{text("d = ", known.free_gap.transpose()), {G, known.free_gap}};
    pairs.force = known.force;
    pairs.gap = known.gap;
    pairs.accuracy = 1e-14;
    made.push_back(pairs);
  }
  return made;
}

Instances none_active() {
  Random random(1);
  Instances made;
  for (const Index n : {3, 8, 40, 120}) {
    ContactProblem problem = random_problem(random, n);
    problem.free_gap = problem.free_gap.cwiseAbs();
    Instance open{text(n, " pairs"), problem};
    open.force = VectorXd::Zero(n);
    open.gap = problem.free_gap;
    open.accuracy = 1e-15;
    made.push_back(open);
  }
  return made;
}

Instances all_active() {
  Random random(2);
  Instances made;
  for (const Index n : {3, 8, 12, 40, 120}) {
    VectorXd force(n);
    for (Index i = 0; i < n; ++i) force(i) = random.uniform(0.5, 2);
    made.push_back(backwards(text(n, " pairs"), random_problem(random, n).compliance, force,
                             VectorXd::Zero(n)));
    made.back().force = force;  // rounding times the condition, up to 1e5
  }
  return made;
}

Instances built_backwards() {
  Random random(8);
  Instances made;
  for (int sample = 0; sample < 60; ++sample) {
    const Index n = sample < 50 ? random.whole(2, 9) : 30 + 10 * (sample - 50);
    const MatrixXd G = random_problem(random, n).compliance;
    VectorXd force = VectorXd::Zero(n);
    VectorXd gap = VectorXd::Zero(n);
    for (Index i = 0; i < n; ++i)
      (random.whole(0, 1) == 0 ? force : gap)(i) = random.uniform(0.1, 1);
    made.push_back(backwards(text("sample ", sample, ", ", n, " pairs"), G, force, gap));
    made.back().force = force;
  }
  return made;
}

}  // namespace signorini_test
