#include "model/rig/swept_time.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "model/pipeline/scan_times.h"

namespace remount::rig {
namespace {

std::optional<drive::SweepModel> sweep_in_use(const drive::Session& session, const pipeline::PipelineOutput& output,
                                              motion::SessionIndex place) {
  if (place >= output.session_uses_sweep.size() || !output.session_uses_sweep[place]) return {};
  return place < output.session_sweeps.size() ? output.session_sweeps[place] : session.sweep;
}

SweptTime of_one_scan(const drive::Session& session, const std::optional<drive::SweepModel>& sweep) {
  constexpr std::size_t kFew = 5;  // one of them can be read
  for (std::size_t i = 0; i < std::min(kFew, session.scans->size()); ++i) {
    try {
      const std::vector<float> times_s = pipeline::told_times(session, session.scans->load(i), sweep);
      if (times_s.empty()) return {};
      const auto [first, last] = std::ranges::minmax(times_s);
      return {first, last};
    } catch (const Error&) {
      continue;
    }
  }
  return {};
}

double period_of(const drive::ScanSource& scans) {
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < scans.size(); ++i) steps_s.push_back(seconds(scans.stamp_ns(i) - scans.stamp_ns(i - 1)));
  return steps_s.empty() ? 0.0 : median_of(std::move(steps_s));
}

}  // namespace

SweptTime swept_time(const pipeline::PipelineInput& input, const pipeline::PipelineOutput& output) {
  SweptTime longest;
  for (motion::SessionIndex s; s < input.sessions.size(); ++s) {
    const drive::Session& session = *input.sessions[s];
    if (!session.scans || session.scans->size() == 0) continue;
    SweptTime swept;
    if (input.settings.run.deskew != settings::DeskewMode::Off)
      swept = of_one_scan(session, sweep_in_use(session, output, s));
    const motion::GatheredFrames frames{
        s < output.session_frames.size() ? static_cast<std::size_t>(std::max(output.session_frames[s], 1)) : 1};
    const double period_s = frames.count > 1 ? period_of(*session.scans) : 0.0;
    swept.from_s -= period_s * static_cast<double>(frames.before());
    swept.until_s += period_s * static_cast<double>(frames.after());
    if (swept.until_s - swept.from_s > longest.until_s - longest.from_s) longest = swept;
  }
  return longest;
}

}  // namespace remount::rig
