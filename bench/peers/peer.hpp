/// \file
/// Other people's solvers, and ours, behind one signature.
#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "signorini/problem/certificate.hpp"
#include "signorini/problem/problem.hpp"

namespace signorini::bench {

/// One solution of one programme. Whether it is one, only the certificate can tell.
struct Run {
  double seconds = 0;           ///< whole solve from K, p, A, g [s], see mean_seconds()
  double condensation = 0;      ///< what G and d alone take of it [s]
  Eigen::Index iterations = 0;  ///< as the solver counts them
  PrimalDual solution;          ///< u and lambda
  std::string failure;          ///< what the solver said instead of "solved", or empty
};

/// A solver.
struct Peer {
  std::string name;     ///< in tables
  std::string missing;  ///< what to install, or empty if it is there
  /// Solves a programme without equations `calls` times in a row.
  std::function<Run(const DenseProgramme& programme, int calls)> solve;
};

/// \return members of our family; the first is quasi_active_set, to which all others are compared
[[nodiscard]] std::vector<Peer> own_solvers();

/// The method of Goldfarb and Idnani as R's package quadprog has it: its compiled core, called without
/// the interpreter. [\ref GoldfarbIdnani1983]
/// \return the peer
[[nodiscard]] Peer quadprog();

/// Lemke's method and a Newton method of Siconos, on the condensed problem that we make for them.
/// \return two peers
[[nodiscard]] std::vector<Peer> siconos();

/// What any of the programs `python3` of the search path can import.
/// \param script  peers.py
/// \return one peer per package
[[nodiscard]] std::vector<Peer> python_packages(const std::filesystem::path& script);

/// Calls something several times.
/// \param calls  how often
/// \param call   what
/// \return mean processor time [s], of all threads: it does not depend on what else the machine does
[[nodiscard]] double mean_seconds(int calls, const std::function<void()>& call);

/// Solves a programme by way of its condensed problem, and times both parts.
/// \param programme  K, p, A, g
/// \param calls      how often
/// \param whole      finds lambda from G and d, and sets `iterations` and `failure`
/// \return time, and u from lambda
[[nodiscard]] Run by_condensation(
    const DenseProgramme& programme, int calls,
    const std::function<Eigen::VectorXd(ContactProblem problem, Run& run)>& whole);

}  // namespace signorini::bench
