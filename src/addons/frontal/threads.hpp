// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The fronts of a tree on several threads.
///
/// What lies below a front does not touch what lies below its neighbour, so that whole subtrees can be worked through at the
/// same time. A front itself waits for those below it, and takes what they hand on in their order: so every sum is the one of
/// a single thread, bit for bit.
#pragma once
#include <functional>
#include <vector>

#include "addons/frontal/fronts.hpp"

namespace signorini {

/// What is done with a part. It gets the number of the part, and one of 0 to threads() - 1 that no other part has at the
/// same time, for room of its own.
using PartWork = std::function<void(int part, int worker)>;

/// Does every part after those below it, on threads(). The last one, which is above the others, comes when they are done, so
/// that it may do its own work in parts.
/// \param parts  of Fronts
/// \param work   writes nothing that other parts read, unless they are above
/// \throws what a part throws; of several the one with the least number, as on one thread
void up_the_tree(const std::vector<TreePart>& parts, const PartWork& work);

/// Does every part after the one above it, on threads().
/// \param parts  of Fronts
/// \param work   writes nothing that other parts read, unless they are below
/// \throws what a part throws
void down_the_tree(const std::vector<TreePart>& parts, const PartWork& work);

}  // namespace signorini
