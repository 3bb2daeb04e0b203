// The museum of hard cases: what every exhibit states of itself is so.
#include <set>

#include "../chapters/ch17_hard_cases/naive.hpp"
#include "catch_compat.hpp"
#include "signorini/report/results.hpp"
#include "support/message.hpp"

using namespace museum;

namespace {

const std::filesystem::path folder = SIGNORINI_HARD_CASES;

const char* word_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::Solved:
      return "solved";
    case Verdict::Honest:
      return "stuck";
    case Verdict::Refuted:
      return "wrong";
    case Verdict::NotFor:
      return "not for it";
  }
  return "";
}

/// "Infeasible" has a proof, too: weights of gaps whose sum is negative and which no force makes larger, or a free motion that
/// opens no gap, and along which the load works.
void check_proof(const Posed& posed, const ContactState& state) {
  const ContactProblem& problem = posed.small;
  const Index pairs = problem.free_gap.size();
  if (state.unbounded_direction.size() > 0) {
    const VectorXd moved = problem.rigid * state.unbounded_direction;
    const double size = moved.cwiseAbs().maxCoeff();
    CHECK(moved.head(pairs).minCoeff() >= -1e-12 * size);
    CHECK(problem.resultant.dot(state.unbounded_direction) < 0);
  } else {
    REQUIRE(state.farkas_certificate.size() == pairs);
    const VectorXd& y = state.farkas_certificate;
    const MatrixXd F = problem.compliance.transpose();
    const VectorXd moved = F * y;
    CHECK(y.minCoeff() >= 0);
    CHECK(moved.maxCoeff() <= 1e-12 * (F.cwiseAbs() * y).maxCoeff());
    if (is_symmetric(problem)) CHECK(moved.minCoeff() >= -1e-12 * (F.cwiseAbs() * y).maxCoeff());
    CHECK(problem.free_gap.dot(y) < -1e-12 * problem.free_gap.cwiseAbs().dot(y));
  }
}

/// What the library says, and that a second time it says the same to the last bit.
void check_ours(const Case& given, const Answer& said) {
  const Exhibit& exhibit = given.exhibit;
  CHECK(said.said == exhibit.status);
  for (const std::string& word : exhibit.words) CHECK_THAT(said.message, ContainsSubstring(word));
  if (exhibit.status == "solved") CHECK(said.certificate.holds(accepted));
  CHECK(broken_bound(exhibit, said).empty());
  for (const Bound& bound : exhibit.bounds) CHECK(std::isfinite(quantity(bound.quantity, said)));
  if (exhibit.status == "infeasible") check_proof(*given.posed, said.contact);
  const Answer again = ours(open(exhibit));
  CHECK(again.message == said.message);
  CHECK(again.contact.force == said.contact.force);
  CHECK(again.unknowns == said.unknowns);
}

void check_room(const std::string& room) {
  const std::vector<Exhibit> all = exhibits(folder, room);
  CHECK(all.size() >= 12);
  for (const Exhibit& exhibit : all) {
    CAPTURE(room, exhibit.name());
    const Case given = open(exhibit);
    const Answer said = ours(given);
    check_ours(given, said);
    CHECK((!exhibit.naive.empty() || !given.posed || given.posed->form));
    for (const NaiveClaim& claim : exhibit.naive) {
      CAPTURE(claim.method);
      CHECK(word_of(judge(exhibit, naive_answer(claim.method, given))) == claim.gives);
    }
    // The control: one force changed in the ninth digit, or a failure that is called a solution.
    if (given.posed) CHECK_FALSE(forged(*given.posed, said, 1e-9).holds(accepted));
    if (given.posed) CHECK((!said.solved() || forged(*given.posed, said, 0).holds(accepted)));
  }
}

}  // namespace

TEST_CASE("conditioning", "[hard]") { check_room("conditioning"); }
TEST_CASE("degeneracy", "[hard]") { check_room("degeneracy"); }
TEST_CASE("dependence", "[hard]") { check_room("dependence"); }
TEST_CASE("impossibility", "[hard]") { check_room("impossibility"); }
TEST_CASE("geometry", "[hard]") { check_room("geometry"); }
TEST_CASE("friction", "[hard]") { check_room("friction"); }
TEST_CASE("files", "[hard]") { check_room("files"); }

TEST_CASE("nothing in the museum is left out", "[hard]") {
  std::set<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_directory()) found.insert(entry.path().filename().string());
  CHECK(found == std::set<std::string>(rooms().begin(), rooms().end()));
}

// A statement that is not understood is an error, not a statement that is not checked.
TEST_CASE("statements that cannot be read are refused", "[hard]") {
  const std::string good =
      "# symptom: s\n# cause: c\n# naive: penalty -> wrong\n# ours: solved\n"
      "# bound: force 0 = 1 within 0.1 (exact)\n# source: s\n# command: signorini lcp "
      "tests/hard/files/x.txt\n"
      "n 1\nM\n1\nq\n-1\n";
  const auto message = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    if (!from.empty()) text.replace(text.find(from), from.size(), to);
    return signorini_test::problem_message(
        [&] { static_cast<void>(read_exhibit("tests/hard/files/x.txt", text)); });
  };
  CHECK(message("", "").empty());
  CHECK_THAT(message("# cause: c\n", ""), ContainsSubstring("must be stated"));
  CHECK_THAT(message("# bound: force 0 = 1 within 0.1 (exact)\n", ""),
             ContainsSubstring("has a bound"));
  CHECK_THAT(message("within", "about"), ContainsSubstring("NUMBER within NUMBER"));
  CHECK_THAT(message("cause: c", "reason: c"), ContainsSubstring("unknown statement 'reason'"));
  CHECK_THAT(message("files/x", "files/y"), ContainsSubstring("its command is about"));
  CHECK_THAT(message(" -> wrong", ""), ContainsSubstring("expected ' -> '"));
}
