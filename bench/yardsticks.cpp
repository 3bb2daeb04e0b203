#include "bench/yardsticks.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <limits>
#ifdef SIGNORINI_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

namespace signorini::bench {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Eigen::VectorXd;

template <class Solver>  // both of them
VectorXd solved(Solver& solver, const Matrix& K, const VectorXd& p) {
  solver.compute(K);
  if (solver.info() != Eigen::Success)
    return VectorXd::Constant(p.size(), std::numeric_limits<double>::quiet_NaN());
  return solver.solve(p);
}

VectorXd simplicial(const Matrix& K, const VectorXd& p) {
  Eigen::SimplicialLLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<int>> solver;
  return solved(solver, K, p);
}

#ifdef SIGNORINI_CHOLMOD
VectorXd supernodal(const Matrix& K, const VectorXd& p) {
  Eigen::CholmodSupernodalLLT<Matrix, Eigen::Lower> solver;
  solver.cholmod().nmethods = 1;  // else it also tries the ordering of METIS
  solver.cholmod().method[0].ordering = CHOLMOD_AMD;
  return solved(solver, K, p);
}
#endif

}  // namespace

std::vector<Yardstick> yardsticks() {
  return {{"SimplicialLLT", simplicial},
#ifdef SIGNORINI_CHOLMOD
          {"CHOLMOD", supernodal}
#endif
  };
}

}  // namespace signorini::bench
