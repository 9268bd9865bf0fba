#include "model/pipeline/hold_out.h"

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/pairwise/pair_judgement.h"
#include "algorithms/core/places_of_rest.h"
#include "messages/stages.h"
#include "model/results/result_file.h"

namespace remount::pipeline {
namespace {

PipelineInput input_of_session(const PipelineInput& input, motion::SessionIndex session) {
  PipelineInput alone = input;
  alone.sessions = {input.sessions[session]};
  alone.settings.measured = {};
  return alone;
}

PipelineOutput output_of_session(const PipelineOutput& output, motion::SessionIndex session) {
  PipelineOutput alone;
  alone.initial_ins_from_lidar = output.initial_ins_from_lidar;
  alone.nominal_known = output.nominal_known;
  alone.initial_known = output.initial_known;
  alone.up_in_lidar = output.up_in_lidar;
  alone.clock_told = output.clock_told;
  alone.clock_is_unknown = output.clock_is_unknown;
  alone.sweep_doubts = output.sweep_doubts;
  const calibration::TimeOffset& clock = output.result.time_offset;
  if (clock.applied && session < output.result.session_time_offset_s.size()) {
    alone.result.time_offset = clock;
    alone.result.session_time_offset_s = {output.result.session_time_offset_s[session]};
    if (session < output.result.session_time_offset_sigma_s.size())
      alone.result.session_time_offset_sigma_s = {output.result.session_time_offset_sigma_s[session]};
    alone.result.time_offset.offset_s = output.result.session_time_offset_s[session];
  }
  const calibration::CalibrationResult& whole = output.result;
  if (whole.position_lag_applied && session < whole.session_position_lag_s.size()) {
    alone.result.position_lag_applied = true;
    alone.result.session_position_lag_s = {whole.session_position_lag_s[session]};
    alone.result.session_position_lag_sigma_s = {whole.session_position_lag_sigma_s.at(session)};
  }
  const auto place = places_of_rest<motion::KeyframeIndex>(
      output.keyframes.size(), [&](motion::KeyframeIndex k) { return output.keyframes[k].session == session; });
  for (motion::KeyframeIndex k; k < output.keyframes.size(); ++k) {
    if (!place[k]) continue;
    alone.keyframes.push_back(output.keyframes[k]);
    alone.keyframes.back().session = motion::SessionIndex{0};
  }
  for (const motion::Pair& pair : output.pairs) {
    const std::optional<motion::KeyframeIndex> a = place[pair.keyframe_a], b = place[pair.keyframe_b];
    if (!a || !b) continue;
    alone.pairs.push_back(pair);
    alone.pairs.back().keyframe_a = *a;
    alone.pairs.back().keyframe_b = *b;
  }
  return alone;
}

ResidualRms residual_rms(const std::vector<search::MotionPair>& pairs, const RigidTransform& ins_from_lidar) {
  if (pairs.empty()) return {};
  double rotation2 = 0.0, translation2 = 0.0;
  for (const search::MotionPair& pair : pairs) {
    const Vector6d residual = difference(pair.lidar_b_from_lidar_a,
                                         calibration::predicted_lidar_motion(pair.ins_b_from_ins_a, ins_from_lidar));
    translation2 += residual.head<3>().squaredNorm();
    rotation2 += residual.tail<3>().squaredNorm();
  }
  const auto count = static_cast<double>(pairs.size());
  return {std::sqrt(rotation2 / count), std::sqrt(translation2 / count)};
}

/// The pairs of a session under the X of `solved`, which takes what it does not observe from the session's own. Where
/// the session has none, an incomplete X has no residual.
ResidualRms score(const calibration::CalibrationResult& solved, const SessionAlone& session,
                  const std::vector<search::MotionPair>& pairs) {
  const bool has_own = calibration::is_usable(session.result);
  if (!calibration::is_usable(solved) || (!has_own && !solved.observed().is_all())) return {};
  return residual_rms(pairs, calibration::with_kept(solved.mounting.ins_from_lidar(),
                                                    session.result.mounting.ins_from_lidar(), ~solved.observed()));
}

}  // namespace

HoldOut check_hold_out(const PipelineInput& input, const PipelineOutput& output, Progress& progress) {
  HoldOut out;
  const std::size_t count = input.sessions.size();
  if (count < 2) return out;
  std::vector<std::vector<search::MotionPair>> pairs;
  for (motion::SessionIndex s; s < count; ++s) {
    progress.report(say::stage_solving_every_session_alone, s, count);
    PipelineOutput alone = output_of_session(output, s);
    const std::vector<search::MotionPair> accepted_by_all = calibration::accepted_motions(alone.pairs);
    if (!solve_again(input_of_session(input, s), alone, progress)) return {};
    SessionAlone session{std::move(alone.result), 0, {}, {}};
    session.result.candidates.clear();
    pairs.push_back(calibration::is_usable(session.result) ? calibration::accepted_motions(alone.pairs)
                                                           : accepted_by_all);
    session.pairs = static_cast<int>(pairs.back().size());
    session.own = score(session.result, session, pairs.back());
    session.common = score(output.result, session, pairs.back());
    out.sessions.push_back(std::move(session));
  }
  for (motion::SessionIndex a; a < count; ++a)
    for (motion::SessionIndex b; b < count; ++b) {
      if (a == b) continue;
      HeldOutScore held{a, b, {}, {}};
      held.residual = score(out.sessions[a].result, out.sessions[b], pairs[b]);
      held.lent = ~out.sessions[a].result.observed();
      out.scores.push_back(held);
      if (a < b)
        out.differences.push_back({calibration::difference_of(out.sessions[a].result, out.sessions[b].result), a, b});
    }
  return out;
}

}  // namespace remount::pipeline
