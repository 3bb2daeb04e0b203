#include <dlfcn.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/peers/peer.hpp"

namespace signorini::bench {
namespace {

/// Least 1/2 x^T D x - d^T x with A^T x >= b. D and d are overwritten.
using Core = void (*)(double* D, double* d, int* leading, int* n, double* x, double* multipliers,
                      double* value, double* A, double* b, int* rows_of_A, int* q, int* equations,
                      int* active, int* active_count, int* iterations, double* work, int* error);

/// What a command of the shell prints.
std::string answer(const char* command) {
  std::string said;
  if (FILE* pipe = popen(command, "r")) {
    for (int letter = std::fgetc(pipe); letter != EOF; letter = std::fgetc(pipe))
      said += static_cast<char>(letter);
    pclose(pipe);
  }
  return said;
}

Run solve(Core core, const DenseProgramme& programme, int calls) {
  int n = static_cast<int>(programme.load.size());
  int q = static_cast<int>(programme.initial_gap.size());
  const int r = std::min(n, q);
  Eigen::MatrixXd D(n, n);
  Eigen::VectorXd d(n);
  Eigen::MatrixXd A = -programme.A.transpose();  // its layout; not overwritten, so not timed
  Eigen::VectorXd b = -programme.initial_gap;
  Eigen::VectorXd work(2 * n + r * (r + 5) / 2 + 2 * q + 1);
  std::vector<int> active(static_cast<std::size_t>(q));
  Run run;
  run.solution.displacement.resize(n);
  run.solution.force.resize(q);
  int iterations[2] = {0, 0};
  int error = 0;
  run.seconds = mean_seconds(calls, [&] {
    D = programme.stiffness;
    d = programme.load;
    int equations = 0;
    int active_count = 0;
    double value = 0;
    error = 0;  // that is: D is not a factor yet
    core(D.data(), d.data(), &n, &n, run.solution.displacement.data(), run.solution.force.data(),
         &value, A.data(), b.data(), &n, &q, &equations, active.data(), &active_count, iterations,
         work.data(), &error);
  });
  run.iterations = iterations[0];
  if (error != 0) run.failure = error == 1 ? "infeasible" : "K is not positive definite";
  return run;
}

}  // namespace

Peer quadprog() {
  Peer peer{"R quadprog", "not installed (Debian package r-cran-quadprog)", {}};
  const std::string library = answer(
      "Rscript -e 'cat(system.file(\"libs\", \"quadprog.so\", package = \"quadprog\"))' "
      "2>/dev/null");
  void* handle = library.empty() ? nullptr : dlopen(library.c_str(), RTLD_NOW);
  const auto core = handle == nullptr ? nullptr : reinterpret_cast<Core>(dlsym(handle, "qpgen2_"));
  if (core == nullptr) return peer;
  peer.missing.clear();
  peer.solve = [core](const DenseProgramme& programme, int calls) {
    return solve(core, programme, calls);
  };
  return peer;
}

}  // namespace signorini::bench
