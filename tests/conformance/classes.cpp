// Every solver on every problem class: one test per class, named after it, so that a new line in either
// table is a new test. Who fails is named with the class and the instance.
#include <utility>

#include "catch_compat.hpp"
#include "papers/solver_table.hpp"
#include "support/chosen.hpp"
#include "support/problem_classes.hpp"
#include "support/sample.hpp"

using namespace signorini;
using namespace signorini_test;

namespace {

template <std::size_t K>
void test_class() {
  const std::vector<Solver> members = chosen(all_solvers());
  if (members.empty()) return;
  const ProblemClass& group = problem_classes()[K];
  const std::vector<Instance> instances = group.instances();
  CHECK_FALSE(instances.empty());
  for (const Solver& solver : members) {
    std::string wrong;
    int count = 0;
    const std::size_t step = instances.size() > 20 ? sample_step : 1;  // few are no sample
    for (std::size_t i = 0; i < instances.size(); i += step) {
      const Instance& instance = instances[i];
      if (!takes_part(solver, instance)) continue;
      const std::string one = complaint(solver, group.traits, instance);
      if (one.empty()) continue;
      if (++count <= 5) wrong += "\n  " + instance.name + ": " + one;
    }
    INFO(solver.name << ", class '" << group.name << "', " << count << " of " << instances.size()
                     << " instances, the first ones:" << wrong);
    CHECK(count == 0);
  }
}

template <std::size_t K>
void add_class() {
  if (K >= problem_classes().size()) return;
  static const std::string name = std::string("class/") + problem_classes()[K].name;
  REGISTER_TEST_CASE(test_class<K>, name.c_str(), "[conformance][class]");
}

template <std::size_t... K>
bool add_classes(std::index_sequence<K...> /*all*/) {
  (add_class<K>(), ...);
  return true;
}

constexpr std::size_t most_classes = 64;
const bool added = add_classes(std::make_index_sequence<most_classes>());

}  // namespace

TEST_CASE("every class of the table has a test of its own", "[conformance]") {
  CHECK(added);
  CHECK(problem_classes().size() <= most_classes);
}
