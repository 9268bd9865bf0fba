#include "model/rig/swept_time.h"

#include <algorithm>

#include "model/pipeline/scan_times.h"

namespace remount::rig {

motion::Sweep averaged_time(const motion::Sweep& swept, double fitted_s) {
  constexpr double kOfBoth = 0.2;  // tests/model/rig/averaged_noise_test.cpp measures it
  const double half_s = 0.5 * (std::max(swept.length_s(), fitted_s) + kOfBoth * std::min(swept.length_s(), fitted_s));
  return {swept.middle_s() - half_s, swept.middle_s() + half_s};
}

std::vector<motion::Sweep> averaged_times(const pipeline::DriveMotion& motion, const pipeline::PipelineOutput& output) {
  std::vector<motion::Sweep> averaged(motion.session_count());
  for (motion::SessionIndex s; s < averaged.size(); ++s) {
    motion::Sweep& time = averaged[s];
    if (s < output.session_swept.size()) time = output.session_swept[s];
    const motion::GatheredFrames frames{
        s < output.session_frames.size() ? static_cast<std::size_t>(std::max(output.session_frames[s], 1)) : 1};
    const drive::ScanSource* scans = motion.session(s).scans.get();
    const double period_s = scans && frames.count > 1 ? pipeline::scan_period_s(*scans) : 0.0;
    time.from_s -= period_s * static_cast<double>(frames.before());
    time.until_s += period_s * static_cast<double>(frames.after());
    time = averaged_time(time, motion.track(s).averaged_s());
  }
  return averaged;
}

}  // namespace remount::rig
