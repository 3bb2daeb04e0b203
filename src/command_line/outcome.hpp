// What the solvers make of a problem from a file, and whether that counts as solved.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "addons/files/problem_file.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/problem/shared_forces.hpp"
#include "signorini/solvers/solvers.hpp"

namespace command_line {

/// What one solver made of one problem.
struct Outcome {
  const signorini::Solver* solver = nullptr;  ///< which one
  bool ran = false;                           ///< whether it ended in the ordinary way
  std::string word;                           ///< its status, "not tried" or "refused"
  std::string why;                            ///< reason, if it did not run or solve; or empty
  signorini::SolveStatus status = signorini::SolveStatus::Breakdown;  ///< what it claims
  bool accepted = false;        ///< the certificate is good enough
  Eigen::Index iterations = 0;  ///< as it counts them
  double seconds = 0;           ///< wall time [s]
  signorini::Certificate certificate = signorini::uncertified();  ///< from the data of the file
  Eigen::VectorXd force;     ///< z, or one multiplier for each two-sided row
  Eigen::VectorXd gap;       ///< w of a complementarity problem
  Eigen::VectorXd friction;  ///< tangential forces of a friction problem
  Eigen::VectorXd slip;      ///< tangential movements of a friction problem
  std::vector<signorini::ContactStatus> contact_status;               ///< of its pairs
  signorini::Uniqueness uniqueness = signorini::Uniqueness::Unknown;  ///< of its solution
  signorini::UniquenessWarning uniqueness_warning = {};               ///< if that is doubtful
  std::vector<Eigen::Index> frictional_pairs = {};       ///< pairs of the friction forces
  std::vector<signorini::ForceRange> undetermined = {};  ///< forces that could as well be others
  Eigen::VectorXd unknowns;                              ///< x of a quadratic programme
  double objective = 0;                                  ///< of a quadratic programme
};

/// What kind of matrix a complementarity problem has.
enum class Matrix { PositiveDefinite, PositiveSemidefinite, Indefinite, Symmetric, Asymmetric };

/// \param problem  M and q, or one with friction
/// \return the kind, found from the eigenvalues of the equilibrated matrix; with friction, whose solutions it says
///   little about, only whether it is symmetric
Matrix kind_of(const signorini::ContactProblem& problem);
/// \param kind  any
/// \return in words
const char* to_string(Matrix kind);

/// Solves a complementarity problem, or one with friction, with the solvers that are asked for.
/// \param problem    M and q, or one with friction
/// \param kind       of its matrix
/// \param asked      name of a solver, "all", or empty: the first one that takes the problem, and where it breaks down the
///   next ones that promise to solve such problems, until one does not break down
/// \param tolerance  largest figure of a certificate that is accepted
/// \return one outcome for each solver
/// \throws signorini::ProblemError if there is no such solver
std::vector<Outcome> solve_all(const signorini::ContactProblem& problem, Matrix kind,
                               const std::string& asked, double tolerance);

/// Solves a quadratic programme with the solvers that are asked for.
/// \param programme  with two-sided rows
/// \param asked      as above
/// \param tolerance  as above
/// \return one outcome for each solver
/// \throws signorini::ProblemError if there is no such solver, the programme is not convex, or
///   its equations contradict each other
std::vector<Outcome> solve_all(const signorini::TwoSidedProgramme& programme,
                               const std::string& asked, double tolerance);

/// Whether the outcomes amount to a solution.
/// \param outcomes  of one problem
/// \param convex    whether "infeasible" is a proof, so that it contradicts a solution
/// \return an accepted solution exists, no method called solved what the certificate refutes, and
///   no method proved the contrary
bool is_solved(const std::vector<Outcome>& outcomes, bool convex);

/// \param outcomes  of one problem
/// \return the first accepted one, or null
const Outcome* best(const std::vector<Outcome>& outcomes);

}  // namespace command_line
