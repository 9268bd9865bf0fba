#include "model/pipeline/without_session.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/places_of_rest.h"
#include "algorithms/messages/message.h"

namespace remount::pipeline {
namespace {

/// Of one that comes after a session that was taken out.
motion::SessionIndex without(motion::SessionIndex gone, motion::SessionIndex session) {
  return session > gone ? motion::SessionIndex(session - 1) : session;
}

motion::SessionIndex session_of_pair(const PipelineOutput& output, const motion::Pair& pair) {
  return output.keyframes.at(pair.keyframe_a).session;
}

bool rests_on(const PipelineOutput& output, motion::SessionIndex session) {
  if (output.method != calibration::kPairwise || !calibration::is_usable(output.result) || output.ground) return true;
  return std::any_of(output.pairs.begin(), output.pairs.end(), [&](const motion::Pair& pair) {
    return pair.state == motion::PairState::Accepted && session_of_pair(output, pair) == session;
  });
}

/// The pairs that a mounting was made of.
std::vector<motion::PairIndex*> pairs_of(calibration::MountingSource& source) {
  if (source.kind == calibration::MountingSource::OnePair) return {&source.first};
  if (source.kind == calibration::MountingSource::TwoPairs) return {&source.first, &source.second};
  return {};
}

/// Candidates have the numbers that their pairs have now; those of pairs that are gone go as well.
void renumber(const std::vector<std::optional<motion::PairIndex>>& places,
              std::vector<calibration::Candidate>& candidates) {
  std::vector<calibration::Candidate> left;
  for (calibration::Candidate& candidate : candidates) {
    bool gone = false;
    for (motion::PairIndex* pair : pairs_of(candidate.source)) {
      if (*pair >= places.size()) continue;
      gone = gone || !places[*pair];
      *pair = places[*pair].value_or(*pair);
    }
    if (!gone) left.push_back(std::move(candidate));
  }
  candidates = std::move(left);
}

void take_out_pairs(motion::SessionIndex session, PipelineOutput& output) {
  const auto pairs = places_of_rest<motion::PairIndex>(
      output.pairs.size(), [&](motion::PairIndex i) { return session_of_pair(output, output.pairs[i]) != session; });
  const auto keyframes = places_of_rest<motion::KeyframeIndex>(
      output.keyframes.size(), [&](motion::KeyframeIndex i) { return output.keyframes[i].session != session; });
  std::erase_if(output.pairs, [&](const motion::Pair& pair) { return session_of_pair(output, pair) == session; });
  std::erase_if(output.keyframes, [&](const motion::Keyframe& keyframe) { return keyframe.session == session; });
  for (motion::Keyframe& keyframe : output.keyframes) keyframe.session = without(session, keyframe.session);
  for (motion::Pair& pair : output.pairs) {
    pair.keyframe_a = keyframes[pair.keyframe_a].value();
    pair.keyframe_b = keyframes[pair.keyframe_b].value();
  }
  renumber(pairs, output.result.candidates);
  calibration::CalibrationResult& result = output.result;
  result.pairs_proposed = static_cast<int>(output.pairs.size());
  result.pairs_rejected =
      static_cast<int>(std::count_if(output.pairs.begin(), output.pairs.end(), [](const motion::Pair& pair) {
        return pair.state == motion::PairState::Rejected;
      }));
}

/// Of what is told of each session, that of one; lists that do not tell it stay.
template <class Value>
void take_out(motion::SessionIndex session, std::vector<Value>& of_sessions) {
  if (session < of_sessions.size()) of_sessions.erase(of_sessions.begin() + signed_of(session));
}

void take_out_clock(motion::SessionIndex session, calibration::CalibrationResult& result) {
  for (std::vector<double>* lags_s : {&result.session_position_lag_s, &result.session_position_lag_sigma_s})
    take_out(session, *lags_s);
  std::vector<double>&offsets_s = result.session_time_offset_s, &sigmas_s = result.session_time_offset_sigma_s;
  if (session >= offsets_s.size()) return;
  take_out(session, offsets_s);
  take_out(session, sigmas_s);
  if (offsets_s.empty()) return;
  const calibration::TimeOffset mean = calibration::mean_time_offset(offsets_s, sigmas_s);
  result.time_offset.offset_s = mean.offset_s;
  if (std::isfinite(mean.sigma_s)) result.time_offset.sigma_s = mean.sigma_s;
}

/// Sessions as advice names them, counted as users do: "2 (tuesday)". Codes of the catalogue, and their place.
constexpr std::string_view kSessionNumber = "session-number", kSessionNamed = "session-named", kNumber = "number";

bool names_a_session(const Message& message) {
  return message.code() == kSessionNumber || message.code() == kSessionNamed;
}

bool names_session(const Message& message, std::int64_t number) {
  return std::ranges::any_of(message.arguments(), [&](const Argument& argument) {
    if (const auto* part = std::get_if<Message>(&argument.value)) return names_session(*part, number);
    if (const auto* parts = std::get_if<std::vector<Message>>(&argument.value))
      return std::ranges::any_of(*parts, [&](const Message& one) { return names_session(one, number); });
    const auto* count = std::get_if<std::int64_t>(&argument.value);
    return names_a_session(message) && argument.name == kNumber && count != nullptr && *count == number;
  });
}

/// The same with the sessions after `number` counted one lower.
Message without_number(const Message& message, std::int64_t number) {
  std::vector<Argument> arguments = message.arguments();
  for (Argument& argument : arguments) {
    if (auto* part = std::get_if<Message>(&argument.value))
      *part = without_number(*part, number);
    else if (auto* parts = std::get_if<std::vector<Message>>(&argument.value))
      std::ranges::transform(*parts, parts->begin(), [&](const Message& one) { return without_number(one, number); });
    else if (auto* count = std::get_if<std::int64_t>(&argument.value);
             count != nullptr && names_a_session(message) && argument.name == kNumber && *count > number)
      --*count;
  }
  return {message.code(), std::move(arguments)};
}

void take_out_advice(motion::SessionIndex session, std::vector<Message>& advice) {
  const std::int64_t number = signed_of(session) + 1;
  std::erase_if(advice, [&](const Message& line) { return names_session(line, number); });
  for (Message& line : advice) line = without_number(line, number);
}

void take_out_findings(const std::vector<std::shared_ptr<const drive::Session>>& sessions, motion::SessionIndex session,
                       std::vector<drive::Finding>& findings) {
  const auto tells = [](const drive::Session& of, const drive::Finding& finding) {
    return finding.where == of.name ||
           std::any_of(of.findings.begin(), of.findings.end(), [&](const drive::Finding& own) {
             return own.code == finding.code && own.where == finding.where && own.explanation == finding.explanation;
           });
  };
  std::erase_if(findings, [&](const drive::Finding& finding) {
    if (!tells(*sessions[session], finding)) return false;
    for (motion::SessionIndex other; other < sessions.size(); ++other)
      if (other != session && tells(*sessions[other], finding)) return false;
    return true;
  });
}

}  // namespace

PipelineInput input_without_session(PipelineInput input, motion::SessionIndex session) {
  take_out(session, input.sessions);
  std::erase_if(input.verdicts, [&](const PairVerdict& verdict) { return verdict.session == session; });
  for (PairVerdict& verdict : input.verdicts) verdict.session = without(session, verdict.session);
  return input;
}

std::optional<PipelineOutput> without_session(const PipelineInput& input, const PipelineOutput& output,
                                              motion::SessionIndex session) {
  if (rests_on(output, session)) return std::nullopt;
  PipelineOutput left = output;
  take_out_pairs(session, left);
  take_out_clock(session, left.result);
  take_out_advice(session, left.result.advice);
  take_out_findings(input.sessions, session, left.findings);
  take_out(session, left.session_uses_sweep);
  take_out(session, left.session_sweeps);
  take_out(session, left.session_swept);
  take_out(session, left.session_frames);
  return left;
}

}  // namespace remount::pipeline
