#include "bench/yardsticks.hpp"

#include <dlfcn.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <filesystem>
#include <iostream>
#include <limits>

#include "bench/mumps.hpp"
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
  return {{"SimplicialLLT", simplicial, {}},
#ifdef SIGNORINI_CHOLMOD
          {"CHOLMOD", supernodal, {}}
#endif
  };
}

std::vector<Yardstick> all_yardsticks() {
  std::vector<Yardstick> all = yardsticks();
  const std::string missing = mumps_missing();
  if (missing.empty())
    all.push_back({"MUMPS", mumps_solve, mumps_compliance});
  else
    std::cout << "MUMPS: " << missing << std::endl;
  return all;
}

std::string dense_kernels() {
  Dl_info found{};
  void* kernel = dlsym(RTLD_DEFAULT, "dgemm_");
  if (kernel == nullptr || dladdr(kernel, &found) == 0) return "none";
  std::error_code unknown;
  const std::filesystem::path file = std::filesystem::canonical(found.dli_fname, unknown);
  return unknown ? found.dli_fname : file.string();
}

}  // namespace signorini::bench
