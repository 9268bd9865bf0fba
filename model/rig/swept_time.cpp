#include "model/rig/swept_time.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "model/pipeline/scan_gathering.h"
#include "model/pipeline/scan_times.h"

namespace remount::rig {
namespace {

std::optional<drive::SweepModel> sweep_in_use(const drive::Session& session, const pipeline::PipelineOutput& output,
                                              motion::SessionIndex place) {
  if (place >= output.session_uses_sweep.size() || !output.session_uses_sweep[place]) return {};
  return place < output.session_sweeps.size() ? output.session_sweeps[place] : session.sweep;
}

calibration::Sweep of_middle_scans(const drive::Session& session, const std::optional<drive::SweepModel>& sweep) {
  constexpr std::size_t kFew = 3;
  const std::size_t count = session.scans->size(), first = count / 2 - std::min(count / 2, kFew / 2);
  calibration::Sweep longest;
  for (std::size_t i = first; i < std::min(first + kFew, count); ++i) {
    try {
      const std::vector<float> times_s = pipeline::told_times(session, session.scans->load(i), sweep);
      if (times_s.empty()) continue;
      const auto [begin, end] = std::ranges::minmax(times_s);
      if (end - begin > longest.length_s()) longest = {begin, end};
    } catch (const Error&) {
      continue;  // it is named where it is used
    }
  }
  return longest;
}

}  // namespace

std::vector<calibration::Sweep> swept_times(const pipeline::PipelineInput& input,
                                            const pipeline::PipelineOutput& output) {
  std::vector<calibration::Sweep> sweeps(input.sessions.size());
  for (motion::SessionIndex s; s < sweeps.size(); ++s) {
    const drive::Session& session = *input.sessions[s];
    if (!session.scans || session.scans->size() == 0) continue;
    calibration::Sweep& swept = sweeps[s];
    if (input.settings.run.deskew != settings::DeskewMode::Off)
      swept = of_middle_scans(session, sweep_in_use(session, output, s));
    const motion::GatheredFrames frames{
        s < output.session_frames.size() ? static_cast<std::size_t>(std::max(output.session_frames[s], 1)) : 1};
    const double period_s = frames.count > 1 ? pipeline::scan_period_s(*session.scans) : 0.0;
    swept.from_s -= period_s * static_cast<double>(frames.before());
    swept.until_s += period_s * static_cast<double>(frames.after());
  }
  return sweeps;
}

}  // namespace remount::rig
