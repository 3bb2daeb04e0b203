/// \file
/// The effects of this add-on.
#pragma once

namespace signorini {

/// Adds axial symmetry, layers, temperatures, springs, adjusted gaps and interferences to effects(), each where it is asked. A
/// program whose scenes have one of them calls it before it plans one; a program that is linked with all of the library,
/// signorini::signorini, need not.
void register_effects();

}  // namespace signorini
