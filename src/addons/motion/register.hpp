/// \file
/// The effects of this add-on.
#pragma once

namespace signorini {

/// Adds moving geometry and finite strain to effects(). A program whose scenes have them calls this before it plans one; a
/// program that is linked with all of the library, signorini::signorini, need not.
void register_motion();

/// Adds the laws of finite strain to strain_laws(), and their effect. register_motion() does so.
void register_finite_strain();

}  // namespace signorini
