#include "addons/checks/register.hpp"

#include "addons/checks/contact_warnings.hpp"
#include "addons/checks/fit_warnings.hpp"
#include "addons/checks/warnings.hpp"
#include "signorini/scene/checks.hpp"

namespace signorini {

void register_checks() {
  add_check({"warnings", mesh_warnings, load_warnings, contact_warnings,
             [](const Model& model, const Solution& solution) {
               return solution_warnings(model, solution);
             }});
  add_check({"fits", nullptr, nullptr, sag_warning, closed_gap_warnings});
}

}  // namespace signorini
