// Dense programmes, solved as such and as (G, d): random ones, ill-conditioned ones, some with equations.
#include <algorithm>
#include <cmath>

#include "signorini/core/errors.hpp"
#include "support/classes/classes.hpp"

namespace signorini_test {

using namespace signorini;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

Instances table_1(bool many) {
  struct Row {
    Index n, m[4];
  };
  Instances made;
  for (const Row& row :
       {Row{10, {5, 10, 20, 40}}, Row{20, {10, 20, 40, 80}}, Row{50, {25, 50, 100, 200}}})
    for (const Index m : row.m)
      for (std::uint64_t seed = 1; seed <= 10 && (m > row.n) == many; ++seed) {
        const KnownProgramme known = rosen_suzuki(row.n, m, seed);
        Instance instance =
            from_programme(text("n = ", row.n, ", m = ", m, ", seed ", seed), known.programme);
        instance.displacement = known.displacement;
        instance.force = known.force;
        instance.gap = known.programme.initial_gap - known.programme.A * known.displacement;
        made.push_back(instance);
      }
  return made;
}

/// A programme in whole numbers, so that u and the forces are exact whatever the condition of
/// K = [a matrix in whole numbers, condition about 10] * weight + 2^power w w^T with w of ones.
Instance whole_programme(int power, bool soft, std::uint64_t seed) {
  Random random(seed);
  const Index n = 12;
  const Index m = 8;
  DenseProgramme made;
  const MatrixXd ones = MatrixXd::Ones(n, n);
  const MatrixXd I = MatrixXd::Identity(n, n);
  made.A.resize(m, n);
  for (Index k = 0; k < made.A.size(); ++k) made.A.data()[k] = random.whole(-3, 3);
  // Stiff against the sum of all displacements, or soft against it alone.
  made.stiffness = soft
                       ? MatrixXd(std::ldexp(1, power) * (static_cast<double>(n) * I - ones) + ones)
                       : MatrixXd(8 * I + std::ldexp(1, power) * ones);
  VectorXd u(n);
  for (Index i = 0; i < n; ++i) u(i) = random.whole(-4, 4);
  const bool loaded =
      seed % 2 == 0;  // against the stiffness; else the sum of displacements is zero
  if (!loaded) u(0) -= u.sum();
  VectorXd force = VectorXd::Zero(m);
  VectorXd gap = VectorXd::Zero(m);
  for (Index i = 0; i < m; ++i) (random.whole(0, 1) == 0 ? force : gap)(i) = random.whole(1, 4);
  made.load = made.stiffness * u + made.A.transpose() * force;
  made.initial_gap = made.A * u + gap;
  Instance instance = from_programme(text("2^", power, ", seed ", seed), made);
  instance.displacement = u;
  // The certificate allows errors of rounding size relative to the load: 2^power larger in soft directions.
  if (loaded) instance.accuracy = std::max(1e-10, 1e-15 * std::ldexp(1, power));
  return instance;
}

}  // namespace

Instances small_programme() {  // by hand: u = (1, -1, 2), the first two rows closed
  DenseProgramme programme{MatrixXd(3, 3), VectorXd(3), MatrixXd(3, 3), VectorXd(3)};
  programme.stiffness << 4, 1, 0, 1, 3, 1, 0, 1, 2;
  programme.load << 5, 5, 6;
  programme.A << 1, 1, 0, 0, 1, 1, 1, 0, -1;
  programme.initial_gap << 0, 1, 3;
  Instance made = from_programme("three unknowns", programme);
  made.displacement = Eigen::Vector3d(1, -1, 2);
  made.force = Eigen::Vector3d(2, 3, 0);
  made.gap = Eigen::Vector3d(0, 0, 4);
  made.accuracy = 1e-12;
  return {made};
}

Instances rosen_suzuki_few() { return table_1(false); }
Instances rosen_suzuki_many() { return table_1(true); }

Instances stiff_mode() {
  Instances made;
  for (const int power : {19, 33, 43})
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
      made.push_back(whole_programme(power, false, seed));
  return made;
}

Instances soft_mode() {
  Instances made;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) made.push_back(whole_programme(20, true, seed));
  return made;
}

Instances equations() {
  Instances made;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {  // a quarter of them without inequalities
    Random random(seed);
    const Index n = random.whole(3, 8);
    const Index m = seed % 4 == 0 ? 2 : random.whole(3, 10);
    DenseProgramme programme = rosen_suzuki(n, m, seed).programme;
    programme.equations = 2;
    VectorXd u(n);
    for (Index i = 0; i < n; ++i) u(i) = random.uniform(-1, 1);
    VectorXd force = VectorXd::Zero(m);
    VectorXd gap = VectorXd::Zero(m);
    for (Index i = 0; i < m; ++i) (i < n ? force : gap)(i) = random.uniform(0.5, 2);
    force(0) *= -1;  // an equation may pull
    programme.load = programme.stiffness * u + programme.A.transpose() * force;
    programme.initial_gap = programme.A * u + gap;
    made.push_back(from_programme(text("seed ", seed, ", n = ", n, ", m = ", m), programme));
    made.back().displacement = u;
  }
  return made;
}

}  // namespace signorini_test
