// What rows of A can do to a method: touch without force, repeat each other, nearly repeat each other.
#include <cmath>

#include "signorini/core/errors.hpp"
#include "support/classes/classes.hpp"
#include "support/problems.hpp"

namespace signorini_test {
namespace {

using namespace signorini;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd whole_rows(Random& random, Index rows, Index cols) {
  MatrixXd A(rows, cols);
  for (Index k = 0; k < A.size(); ++k) A.data()[k] = random.whole(-3, 3);
  return A;
}

VectorXd whole_vector(Random& random, Index n, int low, int high) {
  VectorXd v(n);
  for (Index i = 0; i < n; ++i) v(i) = random.whole(low, high);
  return v;
}

}  // namespace

MatrixXd random_rows(Random& random, Index rows, Index cols) {
  MatrixXd A(rows, cols);
  for (Index k = 0; k < A.size(); ++k) A.data()[k] = random.uniform(-1, 1);
  return A;
}

Instance closest_point(std::string name, const MatrixXd& A, const VectorXd& u,
                       const VectorXd& force, const VectorXd& gap) {
  Instance made =
      from_programme(std::move(name), projection(A, u + A.transpose() * force, A * u + gap));
  made.displacement = u;
  made.gap = gap;
  return made;
}

Instances weakly_active() {
  Random random(9);
  Instances made;
  for (int sample = 0; sample < 60; ++sample) {
    const Index n = sample < 40 ? random.whole(3, 9) : 60;
    const MatrixXd G = random_problem(random, n).compliance;
    VectorXd force = VectorXd::Zero(n);
    VectorXd gap = VectorXd::Zero(n);
    for (Index i = 0; i < n; ++i) {  // in a third of the pairs gap and force are both zero
      const int kind = random.whole(0, 2);
      if (kind > 0) (kind == 1 ? force : gap)(i) = random.uniform(0.25, 2);
    }
    made.push_back(backwards(text("sample ", sample, ", ", n, " pairs"), G, force, gap));
    made.back().force = force;
  }
  return made;
}

Instances half_zero() {
  Random random(10);
  Instances made;
  for (int sample = 0; sample < 40; ++sample) {
    const Index n = sample < 30 ? random.whole(2, 10) : 80;
    ContactProblem problem = random_problem(random, n);
    for (Index i = 0; i < n; i += 2) problem.free_gap(i) = 0;
    made.push_back({text("sample ", sample, ", ", n, " pairs"), problem});
  }
  return made;
}

Instances duplicated_rows() {
  Instances made;
  for (std::uint64_t seed = 1; seed <= 40;
       ++seed) {  // whole numbers: copies are exact in G as well
    Random random(seed);
    const Index n = random.whole(2, 6);
    const MatrixXd once = whole_rows(random, n, n + 1);
    MatrixXd A(2 * n, n + 1);
    VectorXd force = VectorXd::Zero(2 * n);
    VectorXd gap = VectorXd::Zero(2 * n);
    for (Index i = 0; i < n; ++i) {
      A.row(2 * i) = A.row(2 * i + 1) = once.row(i);
      const int size = random.whole(1, 4);
      if (random.whole(0, 2) > 0)
        force(2 * i) = size;
      else
        gap(2 * i) = gap(2 * i + 1) = size;
    }
    made.push_back(closest_point(text("seed ", seed, ", ", 2 * n, " rows"), A,
                                 whole_vector(random, n + 1, -4, 4), force, gap));
  }
  return made;
}

Instances redundant_rows() {
  Instances made;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {  // each further row is a sum of two others
    Random random(seed);
    const Index n = random.whole(2, 5);
    MatrixXd A(2 * n, n + 1);
    A.topRows(n) = whole_rows(random, n, n + 1);
    VectorXd force = VectorXd::Zero(2 * n);
    VectorXd gap = VectorXd::Zero(2 * n);
    for (Index i = 0; i < n; ++i) (random.whole(0, 2) > 0 ? force : gap)(i) = random.whole(1, 4);
    for (Index i = 0; i < n; ++i) {
      const Index other = (i + 1) % n;
      A.row(n + i) = A.row(i) + 2 * A.row(other);
      gap(n + i) = gap(i) + 2 * gap(other);  // implied by the two, no tighter and no looser
    }
    made.push_back(closest_point(text("seed ", seed, ", ", 2 * n, " rows"), A,
                                 whole_vector(random, n + 1, -4, 4), force, gap));
  }
  return made;
}

Instances rounded_dependent_rows() {
  Random random(31);
  Instances made;
  for (int sample = 0; sample < 100; ++sample) {  // singular but for the rounding of G
    const Index n = random.whole(3, 8);
    MatrixXd A = random_rows(random, n, n - random.whole(1, 2));
    for (Index i = 0; i < n;
         ++i)  // one direction opens all gaps: rounding cannot contradict itself
      if (A.row(i).sum() < 0) A.row(i) *= -1;
    VectorXd force = VectorXd::Zero(n);
    VectorXd gap = VectorXd::Zero(n);
    for (Index i = 0; i < n; ++i)
      (random.whole(0, 2) > 0 ? force : gap)(i) = random.uniform(0.1, 1);
    made.push_back(closest_point(text("sample ", sample, ", ", n, " rows"), A,
                                 random_rows(random, A.cols(), 1), force, gap));
    made.back().accuracy = 1e-9;
  }
  return made;
}

}  // namespace signorini_test
