// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The checks of this add-on.
#pragma once

namespace signorini {

/// Adds what a user should be told of meshes, loads, contacts and solutions to checks(). A program that wants these notes calls
/// it before it plans a scene; a program that is linked with all of the library, signorini::signorini, need not.
void register_checks();

}  // namespace signorini
