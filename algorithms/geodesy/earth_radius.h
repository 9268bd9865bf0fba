// The size of the earth, where a sphere is near enough.
#pragma once

namespace remount::geodesy {

/// Mean radius. For lengths of some metres between fixes, corrections and plausibility: within 0.4 per cent of any
/// direction at any place. Positions go through geodesy.h.
inline constexpr double kEarthRadius_m = 6371000.0;

}  // namespace remount::geodesy
