// Every kind of contact problem that a solver may meet, with the right answer, and the judge of what a
// solver says about it. A new class is one function and one line of the table in problem_classes.cpp;
// a new solver meets all classes without further edits.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "papers/examples.hpp"
#include "signorini/solvers/solvers.hpp"

namespace signorini_test {

/// One problem and what must come out. What is not unique or not known is left empty: the certificate
/// is then the only judge.
struct Instance {
  std::string name;                   ///< sizes and seed, for messages
  signorini::ContactProblem problem;  ///< G and d, or any M and q
  /// Or Infeasible; or Breakdown, where nothing solves the problem and no proof of it is asked for
  signorini::SolveStatus expected = signorini::SolveStatus::Solved;
  Eigen::VectorXd force = {};  ///< the only forces that solve it
  Eigen::VectorXd gap = {};    ///< the only gaps
  double accuracy = 1e-10;     ///< allowed error of both, relative to the largest entry
  bool may_be_ray = false;     ///< no theorem says that a method along a ray finds the solution
  std::optional<signorini::DenseProgramme> programme = {};  ///< where G and d come from
  Eigen::VectorXd displacement = {};                        ///< the only u of the programme
  Eigen::VectorXd friction = {};                            ///< the only friction forces
  std::vector<signorini::ContactStatus> contact_status =
      {};                          ///< the only motions of frictional pairs
  Eigen::VectorXd amplitude = {};  ///< the only amplitudes of rigid modes
  /// The forces of all solutions, normal ones first: one of them must come out, and if there are more than one,
  /// no member may say that there is but one.
  std::vector<Eigen::VectorXd> solutions = {};
};

/// Problems that are hard, or easy, for one reason.
struct ProblemClass {
  const char* name;                      ///< of its test: class/NAME
  std::vector<signorini::Trait> traits;  ///< who lists none of these must give the right answer
  std::vector<Instance> (*instances)();  ///< the same on every call
};

/// \return all classes
const std::vector<ProblemClass>& problem_classes();

/// Problems with more pairs than this are not given to solvers that list Trait::Slow.
inline constexpr Eigen::Index large = 200;

/// Whether a solver takes part: it takes friction or its absence, accepts the size, and is quick enough if the
/// problem is large. Rigid modes are no reason not to: springs hold them for who does not take them.
bool takes_part(const signorini::Solver& solver, const Instance& instance);

/// Judges everything that a solver says about one problem, in each form that the problem has.
/// \param solver    a member of the family, or one that would like to be
/// \param traits    of the class
/// \param instance  one that the solver takes part in
/// \return empty, or what is wrong in words
std::string complaint(const signorini::Solver& solver, const std::vector<signorini::Trait>& traits,
                      const Instance& instance);

/// As many complaints are shown at once.
inline constexpr std::size_t most_complaints = 4;

/// What is wrong with one solver, for those who write one: empty if it conforms.
/// \param solver  its table line
/// \return the worst complaint of each class, a line with solver, class and instance: wrong answers before honest ends, small problems
///   before large ones; at most so many lines as above, and one that counts the rest
std::string complaints(const signorini::Solver& solver);

// Makers of instances.

/// A problem built backwards: d = gap - G force, and gap is what must come out.
/// \param name   for messages
/// \param G      compliance
/// \param force  not negative, 0 where the pair is open
/// \param gap    not negative, 0 where the pair is closed
Instance backwards(std::string name, const Eigen::MatrixXd& G, const Eigen::VectorXd& force,
                   const Eigen::VectorXd& gap);

/// The contact problem of a dense programme, which is solved in that form as well.
Instance from_programme(std::string name, const signorini::DenseProgramme& programme);

/// Rows of a programme with K = I: G = A A^T, d = g - A p.
signorini::DenseProgramme projection(const Eigen::MatrixXd& A, const Eigen::VectorXd& point,
                                     const Eigen::VectorXd& g);

}  // namespace signorini_test
