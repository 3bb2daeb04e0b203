// What a run says when it takes far longer than its forecast.
#include <unistd.h>

#include <array>
#include <cstdio>
#include <limits>
#include <string>

#include "catch_compat.hpp"
#include "command_line/overdue.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/solvers/lemke.hpp"

using namespace command_line;
using namespace signorini;

namespace {

/// What is written to standard error while something is done.
template <typename Action>
std::string heard(const Action& action) {
  std::FILE* const file = std::tmpfile();
  const int before = dup(STDERR_FILENO);
  dup2(fileno(file), STDERR_FILENO);
  action([file] { return lseek(fileno(file), 0, SEEK_CUR) > 0; });
  dup2(before, STDERR_FILENO);
  close(before);
  std::rewind(file);
  std::array<char, 200> content{};
  const std::size_t size = std::fread(content.data(), 1, content.size(), file);
  std::fclose(file);
  return {content.data(), size};
}

Prediction forecast(double contact, double iteration, double refinement) {
  const bool known = contact >= 0;
  Prediction prediction;
  const auto add = [&](const char* phase, const char* what, double amount, Certainty certainty) {
    prediction.figures.push_back({Frequency::Once, phase, what, amount, certainty});
  };
  add("assembly", "bytes", 3e6, Certainty::Exact);
  add("assembly", "seconds", 7, Certainty::Estimate);
  add("condensation", "stack bytes", 1e6, Certainty::Exact);
  if (known) {
    add("contact", "seconds", contact, Certainty::Estimate);
  } else {
    add("contact", "seconds of one iteration", iteration, Certainty::Estimate);
    add("contact", "seconds", std::numeric_limits<double>::quiet_NaN(), Certainty::Unknown);
  }
  add("refinement", "solves", 1000, Certainty::Estimate);
  add("refinement", "seconds", refinement, Certainty::Estimate);
  return prediction;
}

}  // namespace

TEST_CASE("a stage is overdue after ten times its forecast, and not within a moment", "[overdue]") {
  CHECK(overdue_after(solving(), forecast(3, 0, 2)) == Approx(50).epsilon(1e-14));
  CHECK(overdue_after(solving(), forecast(-1, 4, 2)) == Approx(60).epsilon(1e-14));
  CHECK(overdue_after(assembling(), forecast(3, 0, 2)) == Approx(70).epsilon(1e-14));
  const double moment = overdue_after(condensing(), forecast(3, 0, 2));
  CHECK(moment > 0);
  CHECK(overdue_after(solving(), forecast(1e-9, 0, 1e-9)) == moment);
}

TEST_CASE("what is overdue is named, with its forecast and what helps", "[overdue]") {
  Plan plan;
  plan.solver = lemke();
  const std::string known = overdue_words(solving(), plan, forecast(3, 0, 2));
  CHECK_THAT(known, StartsWith("signorini: contact and refinement has taken 50 s, more than 10 "
                               "times its forecast of 5 s. "));
  CHECK_THAT(known, ContainsSubstring("--solver NAME") &&
                        ContainsSubstring("primal_dual_active_set") &&
                        !ContainsSubstring("lemke") && !ContainsSubstring("springs"));
  plan.modes.resize(1);
  const std::string unknown = overdue_words(solving(), plan, forecast(-1, 4, 2));
  CHECK_THAT(unknown, ContainsSubstring("the 6 s that it takes with one iteration of contact") &&
                          ContainsSubstring("not known") && ContainsSubstring("springs"));
  const std::string assembly = overdue_words(assembling(), plan, forecast(3, 0, 2));
  CHECK_THAT(assembly, ContainsSubstring("assembly has taken 70 s") && ContainsSubstring("4 MB") &&
                           !ContainsSubstring("--solver"));
}

TEST_CASE("the line is written once while the work goes on, and not after it has ended",
          "[overdue]") {
  CHECK(heard([](const auto& written) {
          const Overdue overdue(1e-3, "late");
          while (!written()) continue;  // the work, which never ends without the line
        }) == "late\n");
  CHECK(heard([](const auto&) { const Overdue overdue(1e6, "early"); }).empty());
  CHECK(heard([](const auto& written) {
          { const Overdue first(1e6, "of the stage before"); }
          const Overdue second(1e-3, "late");
          while (!written()) continue;
        }) == "late\n");
}
