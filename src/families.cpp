// Fills the families of a program that is linked with all of the library, signorini::signorini, before its main(): whatever a
// scene file can ask for is then known. A program that is linked with some folders only calls the functions of those it wants.
#include "addons/checks/register.hpp"
#include "addons/effects/register.hpp"
#include "addons/frontal/backend.hpp"
#include "addons/steps/histories.hpp"

namespace {

bool fill_families() {
  signorini::register_backends();
  signorini::register_checks();
  signorini::register_effects();
  signorini::register_load_steps();
  return true;
}

}  // namespace

// The linker is asked for this name: nobody calls it.
extern "C" {
extern const bool signorini_families;
const bool signorini_families = fill_families();
}
