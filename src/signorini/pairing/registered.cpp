// # What a program gets by being linked
//
// Two bodies need a gap operator, and a rigid obstacle needs none. A program that is linked with
// this folder has the operators before its main() begins; one that is not does not carry them.
//
// Nobody calls the name below, so the linker is asked for it.

#include "signorini/pairing/register.hpp"

extern "C" {
extern const bool signorini_pairing_registered;
const bool signorini_pairing_registered = (signorini::register_gap_operators(), true);
}
