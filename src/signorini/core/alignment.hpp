/// \file
/// Programs that see the objects of Eigen otherwise than the library does are not linked. Every header with such objects
/// includes this one.
#pragma once
#include <Eigen/Core>

namespace signorini {

/// What flags of the compiler, such as `-march=native`, and macros make of the objects of Eigen: at which multiples of
/// bytes they lie on the heap and on the stack, and how many numbers one instruction takes. The library defines it for its
/// own alone. The linker says the name where a program has others, whose objects the two would lay out and free differently.
template <int heap, int stack, int packet>
void compile_with_the_march_that_signorini_was_built_with();

/// Asks the linker for that of this program.
#if defined(__has_cpp_attribute) && __has_cpp_attribute(gnu::retain)
[[gnu::retain]]
#endif
[[gnu::used]] inline void (*const alignment_of_eigen)() =
    compile_with_the_march_that_signorini_was_built_with<
        EIGEN_MAX_ALIGN_BYTES, EIGEN_MAX_STATIC_ALIGN_BYTES,
        Eigen::internal::packet_traits<double>::size>;

}  // namespace signorini
