// Detection of sanitizer builds.
#pragma once

namespace lightwalk {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif
#else
constexpr bool sanitized = false;
#endif

/// Factor on time limits.
constexpr double slower = sanitized ? 20 : 1;

}  // namespace lightwalk
