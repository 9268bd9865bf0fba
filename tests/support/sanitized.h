// What limits of time and memory allow for a build with sanitizers, which says nothing about either.
#pragma once

namespace remount::testing {

#ifdef REMOUNT_SANITIZED
/// Times longer that anything may take: the longest measured, the last steps of a cancelled calibration under the
/// thread sanitizer, took thirteen times the limit.
inline constexpr double kSanitizerSlowdown = 20.0;
/// Of what was freed the address sanitizer keeps 256 MB, to notice its use.
inline constexpr double kSanitizerKeeps_mb = 300.0;
/// What takes many drives to be known, such as a sigma, is for the release tests: a sanitizer has seen all in a few.
inline constexpr bool kSanitized = true;
#else
inline constexpr double kSanitizerSlowdown = 1.0;
inline constexpr double kSanitizerKeeps_mb = 0.0;
inline constexpr bool kSanitized = false;
#endif

}  // namespace remount::testing
