#include "model/sweeps/settled_sweeps.h"

#include <algorithm>
#include <map>
#include <optional>

#include "messages/methods.h"
#include "model/pipeline/scan_times.h"
#include "model/pipeline/solve_stage.h"
#include "model/sweeps/sweep_trial.h"

namespace remount::sweeps {
namespace {

Message sweep_words(const SweepGuess& guess) {
  if (!guess) return say::sweep_none();
  if (guess->by_times)
    return guess->by_times == drive::TimesCount::Backwards ? say::sweep_times_backwards() : say::sweep_times_forwards();
  const Duration period{guess->period_s};
  if (guess->by_order) return say::sweep_by_order(period);
  return guess->clockwise ? say::sweep_clockwise(period) : say::sweep_counter_clockwise(period);
}

drive::Finding proved_finding(const drive::Session& session, const SweepTrial& trial) {
  const Share gain{trial.gain};
  if (trial.best && trial.best->by_times)
    return {drive::Severity::Warning, "point-times-backwards", session.name, say::sweep_proved_backwards(gain)};
  const bool turned = session.scan_timing == drive::ScanTiming::SweepAzimuth && trial.best &&
                      trial.best->clockwise != session.sweep.clockwise;
  if (turned)
    return {drive::Severity::Warning, "sweep-reversed", session.name,
            trial.best->clockwise ? say::sweep_proved_clockwise(sweep_words(trial.best), gain)
                                  : say::sweep_proved_counter_clockwise(sweep_words(trial.best), gain)};
  return {drive::Severity::Note, trial.best ? "deskew-on" : "deskew-off", session.name,
          say::sweep_proved(sweep_words(trial.best), gain)};
}

drive::Finding open_finding(const drive::Session& session, const SweepTrial& trial) {
  return {drive::Severity::Warning, "sweep-open", session.name, say::sweep_open(sweep_words(trial.best))};
}

std::shared_ptr<drive::Session> with_sweep(const drive::Session& session, const SweepGuess& guess) {
  auto copy = std::make_shared<drive::Session>(session);
  if (guess && guess->by_times) {
    copy->times_count = *guess->by_times;
    return copy;
  }
  copy->scan_timing = guess ? drive::ScanTiming::SweepAzimuth : drive::ScanTiming::Instant;
  if (guess) copy->sweep = *guess;
  copy->sweep.certain = copy->sweep.direction_known = true;
  return copy;
}

/// What else the scans of a session may be: the way that is taken as well, for its clock is open too.
std::vector<std::shared_ptr<const drive::Session>> alternatives_of(const drive::Session& session,
                                                                   const SweepTrial& trial) {
  std::vector<std::shared_ptr<const drive::Session>> out{with_sweep(session, trial.best)};
  for (const SweepGuess& other : trial.others) out.push_back(with_sweep(session, other));
  return out;
}

/// A trial of each session that needs one; those of one format are recorded by one LiDAR and judged together.
std::vector<std::optional<SweepTrial>> try_all(const pipeline::PipelineInput& input, Progress& progress) {
  std::vector<std::optional<SweepTrial>> trials(input.sessions.size());
  std::map<std::string, std::vector<SweepTrial*>> of_format;
  for (std::size_t s = 0; s < input.sessions.size() && !progress.cancelled(); ++s) {
    const drive::Session& session = *input.sessions[s];
    if (!needs_sweep_trial(session, input.settings.run.deskew)) continue;
    trials[s] = try_sweeps(session, input.settings, input.threads, progress);
    of_format[session.format].push_back(&*trials[s]);
  }
  for (const auto& [format, alike] : of_format) prove_together(alike);
  return trials;
}

}  // namespace

SettledSweeps settle_sweeps(const pipeline::PipelineInput& input, Progress& progress) {
  SettledSweeps settled{input, {}};
  std::vector<std::vector<std::shared_ptr<const drive::Session>>> alternatives(input.sessions.size());
  std::size_t most = 0;
  const std::vector<std::optional<SweepTrial>> trials = try_all(input, progress);
  for (std::size_t s = 0; s < input.sessions.size() && !progress.cancelled(); ++s) {
    if (!trials[s]) continue;
    const drive::Session& session = *input.sessions[s];
    const SweepTrial& trial = *trials[s];
    const std::shared_ptr<drive::Session> copy = with_sweep(session, trial.best);
    // Nothing is to be said of times that are what they seem.
    const bool as_told = trial.proved && trial.best && trial.best->by_times == drive::TimesCount::Forwards;
    if (!as_told)
      copy->findings.push_back(trial.proved ? proved_finding(session, trial) : open_finding(session, trial));
    copy->scan_timing_open = !trial.proved;
    settled.input.sessions[s] = copy;
    if (trial.proved) continue;
    alternatives[s] = alternatives_of(session, trial);
    most = std::max(most, alternatives[s].size());
  }
  for (std::size_t k = 0; k < most; ++k) {
    pipeline::PipelineInput& other = settled.others.emplace_back(settled.input);
    other.settings.solve.apply_time_offset = calibration::ClockOffsetUse::Yes;
    other.settings.run.map_check = false;
    for (std::size_t s = 0; s < alternatives.size(); ++s)
      if (!alternatives[s].empty()) other.sessions[s] = alternatives[s][std::min(k, alternatives[s].size() - 1)];
  }
  return settled;
}

void add_sweep_doubts(const SettledSweeps& settled,
                      pipeline::PipelineOutput (*run)(const pipeline::PipelineInput&, Progress&),
                      pipeline::PipelineOutput& output, Progress& progress) {
  calibration::CalibrationResult& result = output.result;
  for (const pipeline::PipelineInput& other : settled.others) {
    if (!calibration::is_usable(result)) break;
    const pipeline::PipelineOutput answer = run(other, progress);
    if (progress.cancelled()) {
      result.conclude(calibration::Status::Cancelled, say::method_cancelled());
      return;
    }
    // What contradicts itself under another way is no other way.
    if (!calibration::is_usable(answer.result) || answer.result.mounting.frames() != result.mounting.frames()) continue;
    output.sweep_doubts.push_back(calibration::mounting_difference(result.mounting, answer.result.mounting));
  }
  pipeline::doubt_sweeps(output.sweep_doubts, settled.input.settings.solve, result);
}

}  // namespace remount::sweeps
