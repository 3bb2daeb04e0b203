// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The effects of this add-on.
#pragma once

namespace signorini {

/// Adds moving geometry to effects(). A program whose scenes have it calls this before it plans one; a program that is linked
/// with all of the library, signorini::signorini, need not.
void register_motion();

}  // namespace signorini
