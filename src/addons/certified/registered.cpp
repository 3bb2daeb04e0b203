// A program that is linked with this folder has what it registers before its main(). Nobody calls the name below, so the linker
// is asked for it.
#include "addons/certified/certified_scene.hpp"

extern "C" {
extern const bool signorini_certified_registered;
const bool signorini_certified_registered = (signorini::register_certified(), true);
}
