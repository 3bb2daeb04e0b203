// # One view of Eigen's objects
//
// A matrix of Eigen lies in memory at a multiple of 16, 32 or 64 bytes, as the flags of the
// compiler allow. If a program is compiled with `-march=native` and the library is not, the two
// disagree, and a matrix that one makes is freed wrongly by the other: the program crashes far from
// the cause. Here the linker finds it. The library defines one function whose name contains three
// numbers of this view; every program that includes a header with such objects asks for the
// function with its own three numbers.

#include "signorini/core/alignment.hpp"

namespace signorini {

template <int heap, int stack, int packet>
void compile_with_the_march_that_signorini_was_built_with() {}

template void compile_with_the_march_that_signorini_was_built_with<
    EIGEN_MAX_ALIGN_BYTES, EIGEN_MAX_STATIC_ALIGN_BYTES,
    Eigen::internal::packet_traits<double>::size>();

}  // namespace signorini
