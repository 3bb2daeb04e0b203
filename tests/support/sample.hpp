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

/// Every how manieth. Under the sanitizers one of them takes ten to twenty times its time; what they find, reads and writes
/// that are out of place, a few show as well as all.
constexpr int sample_step = sanitized ? 7 : 1;

}  // namespace signorini_test
