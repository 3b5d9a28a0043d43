#pragma once

/// Defined where a sanitizer is compiled in that brings its own malloc and more addresses than a limited process gets.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ARTCAL_IS_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ARTCAL_IS_SANITIZED
#endif

namespace artcal::testing {

#ifdef ARTCAL_IS_SANITIZED
inline constexpr bool is_sanitized = true;
#else
inline constexpr bool is_sanitized = false;
#endif

}  // namespace artcal::testing
