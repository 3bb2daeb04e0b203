#include "support/chosen.hpp"

#include <cstdlib>
#include <iostream>

#include "addons/frontal/backend.hpp"
#include "papers/solver_table.hpp"
#include "signorini/contact/gap_operators.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/scene/effects.hpp"

namespace signorini_test {
namespace {

using namespace signorini;

std::string name_or_exit() {
  const char* given = std::getenv("SIGNORINI_CONFORMANCE");
  const std::string name = given == nullptr ? "" : given;
  bool known = name.empty();
  std::string list;
  const auto look = [&](const char* what, const auto& family) {
    list += what;
    for (const auto& member : family) {
      known = known || member.name == name;
      list += std::string(" '") + member.name + '\'';
    }
    list += '\n';
  };
  look("elements:", elements());
  look("gap operators:", gap_operators());
  look("solvers:", all_solvers());
  look("effects:", effects());
  look("back ends:", backends());
  if (known) return name;
  std::cerr << "no member '" << name << "'; there are\n" << list;
  std::exit(2);
}

}  // namespace

const std::string& chosen_name() {
  static const std::string name = name_or_exit();
  return name;
}

}  // namespace signorini_test
