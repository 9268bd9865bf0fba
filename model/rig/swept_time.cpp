#include "model/rig/swept_time.h"

#include <algorithm>

#include "model/pipeline/scan_gathering.h"
#include "model/pipeline/scan_times.h"

namespace remount::rig {
namespace {

std::optional<drive::SweepModel> sweep_in_use(const drive::Session& session, const pipeline::PipelineOutput& output,
                                              motion::SessionIndex place) {
  if (place >= output.session_uses_sweep.size() || !output.session_uses_sweep[place]) return {};
  return place < output.session_sweeps.size() ? output.session_sweeps[place] : session.sweep;
}

}  // namespace

std::vector<motion::Sweep> swept_times(const pipeline::PipelineInput& input, const pipeline::PipelineOutput& output) {
  std::vector<motion::Sweep> sweeps(input.sessions.size());
  for (motion::SessionIndex s; s < sweeps.size(); ++s) {
    const drive::Session& session = *input.sessions[s];
    if (!session.scans || session.scans->size() == 0) continue;
    motion::Sweep& swept = sweeps[s];
    if (input.settings.run.deskew != settings::DeskewMode::Off)
      swept = pipeline::usual_sweep(session, sweep_in_use(session, output, s));
    const motion::GatheredFrames frames{
        s < output.session_frames.size() ? static_cast<std::size_t>(std::max(output.session_frames[s], 1)) : 1};
    const double period_s = frames.count > 1 ? pipeline::scan_period_s(*session.scans) : 0.0;
    swept.from_s -= period_s * static_cast<double>(frames.before());
    swept.until_s += period_s * static_cast<double>(frames.after());
  }
  return sweeps;
}

}  // namespace remount::rig
