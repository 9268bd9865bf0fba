#include "model/methods/settled_sweeps.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>

#include "model/methods/sweep_trial.h"
#include "model/pipeline/solve_stage.h"
#include "model/scan_times.h"

namespace remount {
namespace {

std::string sweep_words(const SweepGuess& guess) {
  if (!guess) return "used as they are";
  if (guess->by_times)
    return guess->by_times == TimesCount::Backwards ? "compensated by the times of their points, counted backwards"
                                                    : "compensated by the times of their points as they are";
  char text[120];
  if (guess->by_order)
    std::snprintf(text, sizeof text, "compensated by the order of their points, over %.3f s", guess->period_s);
  else
    std::snprintf(text, sizeof text, "compensated as turns of %.3f s, %s", guess->period_s,
                  guess->clockwise ? "clockwise" : "counter-clockwise");
  return text;
}

Finding proved_finding(const Session& session, const SweepTrial& trial) {
  char gain[80];
  std::snprintf(gain, sizeof gain, " That leaves %.0f %% less between scans than the next of what was tried.",
                100.0 * trial.gain);
  if (trial.best && trial.best->by_times)
    return {Severity::Warning, "point-times-backwards", session.name,
            "The times of the points count backwards, as the time since a point was measured does; told by the scans "
            "themselves. They are taken so." +
                std::string(gain)};
  const bool turned =
      session.scan_timing == ScanTiming::SweepAzimuth && trial.best && trial.best->clockwise != session.sweep.clockwise;
  if (turned)
    return {Severity::Warning, "sweep-reversed", session.name,
            std::string("The sensor turns ") + (trial.best->clockwise ? "clockwise" : "counter-clockwise") +
                ", not as is usual in this format: the scans are " + sweep_words(trial.best) + "." + gain};
  return {Severity::Note, trial.best ? "deskew-on" : "deskew-off", session.name,
          "The format does not say how its scans are bent by motion; told by the scans themselves they are " +
              sweep_words(trial.best) + "." + gain};
}

Finding open_finding(const Session& session, const SweepTrial& trial) {
  return {Severity::Warning, "sweep-open", session.name,
          "How the scans are bent by motion is not known, and they do not tell clearly: they are " +
              sweep_words(trial.best) +
              ". The sigmas include what another way would make of the mounting; no clock offset is estimated."};
}

std::shared_ptr<Session> swept(const Session& session, const SweepGuess& guess) {
  auto copy = std::make_shared<Session>(session);
  if (guess && guess->by_times) {
    copy->times_count = *guess->by_times;
    return copy;
  }
  copy->scan_timing = guess ? ScanTiming::SweepAzimuth : ScanTiming::Instant;
  if (guess) copy->sweep = *guess;
  copy->sweep.certain = copy->sweep.direction_known = true;
  return copy;
}

/// What else the scans of a session may be: the way that is taken as well, for its clock is open too.
std::vector<std::shared_ptr<const Session>> alternatives_of(const Session& session, const SweepTrial& trial) {
  std::vector<std::shared_ptr<const Session>> out{swept(session, trial.best)};
  for (const SweepGuess& other : trial.others) out.push_back(swept(session, other));
  return out;
}

/// A trial of each session that needs one; those of one format are recorded by one LiDAR and judged together.
std::vector<std::optional<SweepTrial>> try_all(const PipelineInput& input, Progress& progress) {
  std::vector<std::optional<SweepTrial>> trials(input.sessions.size());
  std::map<std::string, std::vector<SweepTrial*>> of_format;
  for (std::size_t s = 0; s < input.sessions.size() && !progress.cancelled(); ++s) {
    const Session& session = *input.sessions[s];
    if (!needs_sweep_trial(session, input.settings.run.deskew)) continue;
    trials[s] = try_sweeps(session, input.settings, input.threads, progress);
    of_format[session.format].push_back(&*trials[s]);
  }
  for (const auto& [format, alike] : of_format) prove_together(alike);
  return trials;
}

}  // namespace

SettledSweeps settle_sweeps(const PipelineInput& input, Progress& progress) {
  SettledSweeps settled{input, {}};
  std::vector<std::vector<std::shared_ptr<const Session>>> alternatives(input.sessions.size());
  std::size_t most = 0;
  const std::vector<std::optional<SweepTrial>> trials = try_all(input, progress);
  for (std::size_t s = 0; s < input.sessions.size() && !progress.cancelled(); ++s) {
    if (!trials[s]) continue;
    const Session& session = *input.sessions[s];
    const SweepTrial& trial = *trials[s];
    const std::shared_ptr<Session> copy = swept(session, trial.best);
    // Nothing is to be said of times that are what they seem.
    const bool as_told = trial.proved && trial.best && trial.best->by_times == TimesCount::Forwards;
    if (!as_told)
      copy->findings.push_back(trial.proved ? proved_finding(session, trial) : open_finding(session, trial));
    copy->scan_timing_open = !trial.proved;
    settled.input.sessions[s] = copy;
    if (trial.proved) continue;
    alternatives[s] = alternatives_of(session, trial);
    most = std::max(most, alternatives[s].size());
  }
  for (std::size_t k = 0; k < most; ++k) {
    PipelineInput& other = settled.others.emplace_back(settled.input);
    other.settings.solve.apply_time_offset = ClockOffsetUse::Yes;
    other.settings.run.map_check = false;
    for (std::size_t s = 0; s < alternatives.size(); ++s)
      if (!alternatives[s].empty()) other.sessions[s] = alternatives[s][std::min(k, alternatives[s].size() - 1)];
  }
  return settled;
}

void add_sweep_doubts(const SettledSweeps& settled, PipelineOutput (*run)(const PipelineInput&, Progress&),
                      PipelineOutput& output, Progress& progress) {
  CalibrationResult& result = output.result;
  for (const PipelineInput& other : settled.others) {
    if (!is_usable(result)) break;
    const PipelineOutput answer = run(other, progress);
    if (progress.cancelled()) {
      result.status = Status::Cancelled;
      result.message = "Cancelled.";
      return;
    }
    // What contradicts itself under another way is no other way.
    if (!is_usable(answer.result) || answer.result.reference_frame != result.reference_frame) continue;
    output.sweep_doubts.push_back(difference(result.ins_from_lidar, answer.result.ins_from_lidar));
  }
  doubt_sweeps(output.sweep_doubts, settled.input.settings.solve, result);
}

}  // namespace remount
