// A program that is linked with this folder has what it registers before its main(). Nobody calls the name below, so the linker
// is asked for it.
#include "addons/steps/histories.hpp"

extern "C" {
extern const bool signorini_steps_registered;
const bool signorini_steps_registered = (signorini::register_load_steps(), true);
}
