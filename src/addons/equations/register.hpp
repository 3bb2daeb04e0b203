// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The effect of this add-on.
#pragma once

namespace signorini {

/// Adds the effect equations, and the check that measures them. A program whose scenes have bonds calls it before it plans one;
/// a program that is linked with all of the library, signorini::signorini, need not.
void register_equations();

}  // namespace signorini
