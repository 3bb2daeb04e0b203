// How much of a random sample is looked at.
#pragma once

namespace signorini_test {

#ifdef __SANITIZE_ADDRESS__  // as g++ says it
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer);
#else
constexpr bool sanitized = false;
#endif

/// From one member that is looked at to the next. Under the sanitizers each takes ten to twenty times as long, and errors of memory
/// are found by a few of them.
constexpr int sample_step = sanitized ? 7 : 1;

}  // namespace signorini_test
