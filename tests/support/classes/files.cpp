// Problems of other collections, in tests/data/ with their sources.
#include <algorithm>
#include <initializer_list>

#include "addons/files/problem_file.hpp"
#include "signorini/core/errors.hpp"
#include "support/classes/classes.hpp"

namespace signorini_test {
namespace {

using namespace signorini;
using Eigen::VectorXd;

ProblemFile read(const std::string& name) {
  return read_problem(std::string(SIGNORINI_TEST_DATA) + "/" + name);
}

VectorXd vector(std::initializer_list<double> entries) {
  VectorXd v(static_cast<Eigen::Index>(entries.size()));
  std::copy(entries.begin(), entries.end(), v.begin());
  return v;
}

/// All complementarity problems of a file, with the answers that it gives.
Instances from_file(const std::string& name) {
  Instances made;
  const ProblemFile file = read(name);
  for (const FiledProblem& filed : std::get<std::vector<FiledProblem>>(file)) {
    made.push_back({text(name, ", line ", filed.line), filed.problem});
    made.back().force = filed.known_force;
    made.back().gap = filed.known_gap;
  }
  return made;
}

/// One problem of the collection of Siconos; forces come from elimination in fractions.
Instance siconos(const std::string& name, const VectorXd& force) {
  Instance made = from_file("siconos_lcp/lcp_" + name + ".dat").front();
  made.force = force;
  made.gap = made.problem.compliance * force + made.problem.free_gap;
  made.accuracy = 1e-12;
  return made;
}

/// The same where other forces leave the same gaps.
Instance siconos_gap(const std::string& name, const VectorXd& force) {
  Instance made = siconos(name, force);
  made.force = {};
  return made;
}

Instance maros_meszaros(const std::string& name, const VectorXd& x) {
  const auto file = std::get<TwoSidedProgramme>(read("maros_meszaros/" + name + ".txt"));
  Instance made = from_programme(name, one_sided(file).programme);
  made.displacement = x;
  return made;
}

}  // namespace

Instances generated_files() {
  Instances made = from_file("generated/fathi_spd_lemke_exponential.txt");
  for (const char* name : {"generated/quantecon768_lcp_n10.txt"})
    for (const Instance& one : from_file(name)) made.push_back(one);
  return made;
}

Instances siconos_regular() {
  VectorXd whole(9);  // 1, 1/2, ..., 1/9
  for (Eigen::Index i = 0; i < 9; ++i) whole(i) = 1 / static_cast<double>(i + 1);
  return {siconos("trivial", whole), siconos("deudeu", vector({4.0 / 3, 7.0 / 3}))};
}

Instances siconos_semidefinite() {
  return {siconos_gap("CPS_1", vector({0, 1})), siconos_gap("CPS_5", vector({0, 1}))};
}

Instances siconos_asymmetric() {
  return {siconos("exp_murty", VectorXd::Unit(6, 5)),
          siconos("exp_murty2", 64 * VectorXd::Unit(6, 5)), siconos("CPS_4", vector({2, 2, 2, 92})),
          siconos("CPS_4bis", vector({3, 3, 0, 83}))};
}

Instances siconos_singular() {
  Instances made = {siconos("CPS_2", vector({0, 1, 3})),
                    siconos("Pang_isolated_sol", vector({1, 0, 0})),
                    siconos_gap("inf_sol_perturbed", vector({1, 0, 1e-4}))};
  for (Instance& one : from_file("siconos_lcp/lcp_CPS_3.dat"))
    made.push_back(one);  // three solutions
  for (Instance& one : made) one.may_be_ray = true;
  return made;
}

Instances siconos_infeasible() {
  Instances made = from_file("siconos_lcp/lcp_Pang_isolated_sol_perturbed.dat");
  made.front().expected = SolveStatus::Infeasible;
  made.front().may_be_ray = true;
  return made;
}

Instances maros_meszaros_rows() {
  return {maros_meszaros("HS21", vector({2, 0})),
          maros_meszaros("HS268", vector({1, 2, -1, 3, -4})),
          maros_meszaros("HS35", vector({4.0 / 3, 7.0 / 9, 4.0 / 9})),
          maros_meszaros("QPTEST", vector({0.7625, 0.475}))};
}

Instances maros_meszaros_equations() {
  return {maros_meszaros("HS52", vector({-33, 11, 180, -158, 11}) / 349),
          maros_meszaros("TAME", vector({0.5, 0.5})), maros_meszaros("GENHS28", {}),
          maros_meszaros("DUALC1", {})};
}

}  // namespace signorini_test
