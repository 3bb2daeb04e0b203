// A program that is linked with this folder has what it registers before its main(). Nobody calls the name below, so the linker
// is asked for it.
#include "addons/equations/register.hpp"

extern "C" {
extern const bool signorini_equations_registered;
const bool signorini_equations_registered = (signorini::register_equations(), true);
}
