#include "addons/checks/register.hpp"

#include "addons/checks/contact_warnings.hpp"
#include "addons/checks/fit_warnings.hpp"
#include "addons/checks/lost_digits.hpp"
#include "addons/checks/point_supports.hpp"
#include "addons/checks/shared_words.hpp"
#include "addons/checks/sliding_verdict.hpp"
#include "addons/checks/warnings.hpp"
#include "signorini/scene/checks.hpp"

namespace signorini {

void register_checks() {
  add_check({"warnings", mesh_warnings, load_warnings, contact_warnings,
             [](const Model& model, const Solution& solution) {
               return solution_warnings(model, solution);
             }});
  add_check({"point supports", nullptr, nullptr, nullptr, point_supports});
  add_check({"fits", nullptr, nullptr, sag_warning, closed_gap_warnings});
  add_check({"shared forces", nullptr, nullptr, nullptr, nullptr, note_shared_forces});
  add_check({"lost digits", nullptr, nullptr, nullptr, nullptr, check_lost_digits});
  add_check({"sliding", nullptr, nullptr, nullptr, nullptr, check_sliding});
}

}  // namespace signorini
