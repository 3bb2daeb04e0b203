// Linked with signorini::scene and what that stands on, with no family filled: the library solves by itself, and names the
// function to call for what an add-on does.
// Run:  library_alone     Prints nothing if all is as it should be.
#include <iostream>

#include "signorini/core/errors.hpp"
#include "support/cantilever.hpp"

namespace {

using namespace signorini;

int failures = 0;

void expect(bool right, const std::string& what) {
  if (right) return;
  std::cerr << "library_alone: " << what << '\n';
  ++failures;
}

/// Whether planning a scene is refused with a word. \param call  the word
void expect_refused(const Scene& scene, const std::string& call) {
  try {
    static_cast<void>(plan(scene));
    expect(false, "nobody asks for " + call);
  } catch (const ProblemError& error) {
    expect(std::string(error.what()).find(call) != std::string::npos, error.what());
  }
}

}  // namespace

int main() {
  const Scene scene = signorini_test::cantilever("q4_incompatible", 40, 4);
  expect(backends().empty() && default_backend().name == std::string("sparse_cholesky"),
         "the back end is not the plain one");
  const Solution solution = solve(scene);
  expect(solution.contact.report.status == SolveStatus::Solved && solution.certificate.holds(),
         "the cantilever is not solved");
  Scene other = scene;
  other.path = Path{{1}, {}};
  expect_refused(other, "register_load_steps()");
  try {
    static_cast<void>(solve(other));
    expect(false, "load steps are solved in one");
  } catch (const ProblemError& error) {
    expect(std::string(error.what()).find("solve_steps()") != std::string::npos, error.what());
  }
  other = scene;
  other.bodies[0].springs = {{"top", {1, 1}}};
  expect_refused(other, "register_effects()");
  return failures;
}
