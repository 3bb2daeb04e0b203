#include "exercise.hpp"

namespace ex17_1 {

Fault fault_of(const signorini::ContactProblem& problem, const Eigen::VectorXd& force,
               const Eigen::VectorXd& gap) {
  const Eigen::ArrayXd root = problem.compliance.diagonal().array().sqrt();
  const Eigen::ArrayXd f = force.array() * root;  // both in one unit
  const Eigen::ArrayXd g = gap.array() / root;
  const Eigen::VectorXd made = problem.free_gap + problem.compliance * force;
  const Eigen::VectorXd terms =
      problem.free_gap.cwiseAbs() + problem.compliance.cwiseAbs() * force.cwiseAbs();
  const double size = (terms.array() / root).maxCoeff();
  const double most = 1e-9 * size;
  // Asked for what is right: no comparison with what is no number is true.
  const Eigen::ArrayXd wrong = (made - gap).array().abs() / root;
  if (!f.allFinite() || !g.allFinite() || !(wrong <= most).all()) return Fault::Movement;
  if (!(g >= -most).all()) return Fault::Overlap;
  if (!(f >= -most).all()) return Fault::Tension;
  if (!(g.min(f) <= most).all()) return Fault::AcrossAGap;
  return Fault::None;
}

}  // namespace ex17_1
