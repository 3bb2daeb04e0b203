#include "signorini/core/alignment.hpp"

namespace signorini {

template <int heap, int stack, int packet>
void compile_with_the_march_that_signorini_was_built_with() {}

template void compile_with_the_march_that_signorini_was_built_with<
    EIGEN_MAX_ALIGN_BYTES, EIGEN_MAX_STATIC_ALIGN_BYTES,
    Eigen::internal::packet_traits<double>::size>();

}  // namespace signorini
