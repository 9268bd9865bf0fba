// What limits of time and memory allow for a build with sanitizers, which says nothing about either.
#pragma once

namespace remount {

#ifdef REMOUNT_SANITIZED
/// Times longer that anything may take.
inline constexpr double kSanitizerSlowdown = 10.0;
/// Of what was freed the address sanitizer keeps 256 MB, to notice its use.
inline constexpr double kSanitizerKeeps_mb = 300.0;
#else
inline constexpr double kSanitizerSlowdown = 1.0;
inline constexpr double kSanitizerKeeps_mb = 0.0;
#endif

}  // namespace remount
