// A program that is linked with this folder has what it registers before its main(). Nobody calls the name below, so the linker
// is asked for it.
#include "addons/frontal/backend.hpp"

extern "C" {
extern const bool signorini_frontal_registered;
const bool signorini_frontal_registered = (signorini::register_backends(), true);
}
