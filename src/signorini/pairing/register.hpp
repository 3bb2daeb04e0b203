// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The gap operators of the library.
#pragma once

namespace signorini {

/// Adds the gap operators of this folder to gap_operators(). A program that is linked with signorini::pairing need not call it.
void register_gap_operators();

}  // namespace signorini
