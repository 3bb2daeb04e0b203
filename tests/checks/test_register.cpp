// The family of checks: who is registered is asked, once for each thing that there is to look at.
#include "addons/checks/register.hpp"
#include "catch_compat.hpp"
#include "signorini/scene/checks.hpp"
#include "support/cantilever.hpp"

using namespace signorini;

TEST_CASE("a check of a program's own is asked of every body, contact and solution", "[checks]") {
  static int meshes = 0, loads = 0, contacts = 0, solutions = 0;
  static Eigen::Index pairs_seen = 0;
  const Check counting = {"counting",
                          [](const Scene& /*scene*/, const BodyModel& /*body*/) {
                            ++meshes;
                            return Check::Notes{};
                          },
                          [](const Body& /*body*/) {
                            ++loads;
                            return Check::Notes{};
                          },
                          [](const ContactSpec& /*contact*/,
                             const std::vector<BodyModel>& /*bodies*/, const Pairs& pairs) {
                            ++contacts;
                            pairs_seen = pairs.initial_gap.size();
                            return Check::Notes{};
                          },
                          [](const Model& /*model*/, const Solution& /*solution*/) {
                            ++solutions;
                            return Check::Notes{};
                          }};
  add_check(counting);
  const std::size_t members = checks().size();
  add_check(counting);
  register_checks();
  CHECK(checks().size() == members);
  const Solution solution = solve(signorini_test::cantilever("q4_incompatible", 12, 2));
  REQUIRE(solution.contact.report.status == SolveStatus::Solved);
  CHECK(pairs_seen == 13);  // supports have taken none yet
  CHECK((meshes == 1 && loads == 1 && contacts == 1 && solutions == 1));
  Check idle;
  idle.name = "idle";
  add_check(idle);  // it asks nothing
  CHECK(plan(signorini_test::cantilever("q4_incompatible", 12, 2)).notes.empty());
  CHECK(contacts == 2);
}
