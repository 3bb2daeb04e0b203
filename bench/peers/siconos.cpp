#include "bench/peers/peer.hpp"

#ifdef SIGNORINI_SICONOS
#include <LCP_Solvers.h>
#include <LinearComplementarityProblem.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <SolverOptions.h>
#include <lcp_cst.h>
#endif

namespace signorini::bench {

#ifdef SIGNORINI_SICONOS
namespace {

Eigen::VectorXd force_by(int solver, ContactProblem problem, Run& run) {
  const int size = static_cast<int>(problem.free_gap.size());
  NumericsMatrix matrix;
  NM_null(&matrix);
  NM_fill(&matrix, NM_DENSE, size, size, problem.compliance.data());
  ::LinearComplementarityProblem lcp{size, &matrix, problem.free_gap.data()};
  Eigen::VectorXd force = Eigen::VectorXd::Zero(size);
  Eigen::VectorXd gap = Eigen::VectorXd::Zero(size);
  ::SolverOptions* options = solver_options_create(solver);
  options->iparam[SICONOS_IPARAM_MAX_ITER] = 100 * size + 1000;
  const int info = linearComplementarity_driver(&lcp, force.data(), gap.data(), options);
  run.iterations = options->iparam[SICONOS_IPARAM_ITER_DONE];
  run.failure = info == 0 ? "" : "no solution, code " + std::to_string(info);
  solver_options_delete(options);
  delete options;
  return force;
}

Peer member(const char* name, int solver) {
  return {name, "", [solver](const DenseProgramme& programme, int calls) {
            return by_condensation(programme, calls, [solver](ContactProblem problem, Run& run) {
              return force_by(solver, std::move(problem), run);
            });
          }};
}

}  // namespace

std::vector<Peer> siconos() {
  return {member("Siconos Lemke", SICONOS_LCP_LEMKE),
          member("Siconos Fischer-Burmeister", SICONOS_LCP_NEWTON_FB_FBLSA)};
}
#else
std::vector<Peer> siconos() {
  return {{"Siconos", "not installed (Debian package libsiconos-numerics-dev)", {}}};
}
#endif

}  // namespace signorini::bench
