// The stages of a calibration from pairs, as Progress names them: what reports them and what tells them apart agree.
#pragma once

#include <string_view>

namespace remount::stage {

inline constexpr std::string_view kFindingMounting = "finding the mounting", kFindingObjects = "finding objects",
                                  kRegisteringPairs = "registering pairs", kSolving = "solving",
                                  kAligningAllClouds = "aligning all clouds", kCheckingMap = "checking the map",
                                  kTryingSweeps = "trying how scans were swept";

}  // namespace remount::stage
