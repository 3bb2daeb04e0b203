#include "signorini/core/alignment.hpp"

namespace signorini {

template <int heap, int stack>
void compile_with_the_march_and_EIGEN_MAX_ALIGN_BYTES_that_signorini_was_built_with() {}

template void compile_with_the_march_and_EIGEN_MAX_ALIGN_BYTES_that_signorini_was_built_with<
    EIGEN_MAX_ALIGN_BYTES, EIGEN_MAX_STATIC_ALIGN_BYTES>();

}  // namespace signorini
