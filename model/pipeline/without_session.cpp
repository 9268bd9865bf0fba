#include "model/pipeline/without_session.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algorithms/messages/message.h"

namespace remount {
namespace {

/// The new number of each of `count` things of which some were taken out; -1 of those.
template <class Stays>
std::vector<int> numbers_of_rest(std::size_t count, const Stays& stays) {
  std::vector<int> numbers(count, -1);
  int next = 0;
  for (std::size_t i = 0; i < count; ++i)
    if (stays(i)) numbers[i] = next++;
  return numbers;
}

int session_of_pair(const PipelineOutput& output, const Pair& pair) {
  return output.keyframes.at(static_cast<std::size_t>(pair.keyframe_a)).session;
}

bool rests_on(const PipelineOutput& output, int session) {
  if (output.method != kPairwise || !is_usable(output.result) || output.ground) return true;
  return std::any_of(output.pairs.begin(), output.pairs.end(), [&](const Pair& pair) {
    return pair.state == PairState::Accepted && session_of_pair(output, pair) == session;
  });
}

/// With the numbers that its pairs have now.
MountingSource renumbered(MountingSource source, const std::vector<int>& numbers) {
  for (int* pair : {&source.first, &source.second})
    if (*pair >= 0 && *pair < static_cast<int>(numbers.size())) *pair = numbers[static_cast<std::size_t>(*pair)];
  return source;
}

void take_out_pairs(int session, PipelineOutput& output) {
  const std::vector<int> pairs = numbers_of_rest(
      output.pairs.size(), [&](std::size_t i) { return session_of_pair(output, output.pairs[i]) != session; });
  const std::vector<int> keyframes =
      numbers_of_rest(output.keyframes.size(), [&](std::size_t i) { return output.keyframes[i].session != session; });
  std::erase_if(output.pairs, [&](const Pair& pair) { return session_of_pair(output, pair) == session; });
  std::erase_if(output.keyframes, [&](const Keyframe& keyframe) { return keyframe.session == session; });
  for (Keyframe& keyframe : output.keyframes) keyframe.session -= keyframe.session > session ? 1 : 0;
  for (Pair& pair : output.pairs) {
    pair.keyframe_a = keyframes[static_cast<std::size_t>(pair.keyframe_a)];
    pair.keyframe_b = keyframes[static_cast<std::size_t>(pair.keyframe_b)];
  }
  for (Candidate& candidate : output.result.candidates) candidate.source = renumbered(candidate.source, pairs);
  CalibrationResult& result = output.result;
  result.pairs_proposed = static_cast<int>(output.pairs.size());
  result.pairs_rejected = static_cast<int>(std::count_if(
      output.pairs.begin(), output.pairs.end(), [](const Pair& pair) { return pair.state == PairState::Rejected; }));
}

void take_out_clock(int session, CalibrationResult& result) {
  for (std::vector<double>* lags_s : {&result.session_position_lag_s, &result.session_position_lag_sigma_s})
    if (static_cast<std::size_t>(session) < lags_s->size()) lags_s->erase(lags_s->begin() + session);
  std::vector<double>&offsets_s = result.session_time_offset_s, &sigmas_s = result.session_time_offset_sigma_s;
  if (static_cast<std::size_t>(session) >= offsets_s.size()) return;
  offsets_s.erase(offsets_s.begin() + session);
  if (static_cast<std::size_t>(session) < sigmas_s.size()) sigmas_s.erase(sigmas_s.begin() + session);
  // Of one that was applied the mean is that of the sessions, each alike; an estimate knows the accepted pairs alone.
  if (!result.time_offset.applied || offsets_s.empty()) return;
  const auto count = static_cast<double>(offsets_s.size());
  result.time_offset.offset_s = std::accumulate(offsets_s.begin(), offsets_s.end(), 0.0) / count;
  if (sigmas_s.size() == offsets_s.size())
    result.time_offset.sigma_s =
        std::sqrt(std::inner_product(sigmas_s.begin(), sigmas_s.end(), sigmas_s.begin(), 0.0)) / count;
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

void take_out_advice(int session, std::vector<Message>& advice) {
  const std::int64_t number = session + 1;
  std::erase_if(advice, [&](const Message& line) { return names_session(line, number); });
  for (Message& line : advice) line = without_number(line, number);
}

void take_out_findings(const std::vector<std::shared_ptr<const Session>>& sessions, int session,
                       std::vector<Finding>& findings) {
  const auto tells = [](const Session& of, const Finding& finding) {
    return finding.where == of.name || std::any_of(of.findings.begin(), of.findings.end(), [&](const Finding& own) {
             return own.code == finding.code && own.where == finding.where && own.explanation == finding.explanation;
           });
  };
  std::erase_if(findings, [&](const Finding& finding) {
    if (!tells(*sessions[static_cast<std::size_t>(session)], finding)) return false;
    for (int other = 0; other < std::ssize(sessions); ++other)
      if (other != session && tells(*sessions[static_cast<std::size_t>(other)], finding)) return false;
    return true;
  });
}

}  // namespace

PipelineInput input_without_session(PipelineInput input, int session) {
  input.sessions.erase(input.sessions.begin() + session);
  std::erase_if(input.verdicts, [&](const PairVerdict& verdict) { return verdict.session == session; });
  for (PairVerdict& verdict : input.verdicts) verdict.session -= verdict.session > session ? 1 : 0;
  return input;
}

std::optional<PipelineOutput> without_session(const PipelineInput& input, const PipelineOutput& output, int session) {
  if (rests_on(output, session)) return std::nullopt;
  PipelineOutput left = output;
  take_out_pairs(session, left);
  take_out_clock(session, left.result);
  take_out_advice(session, left.result.advice);
  take_out_findings(input.sessions, session, left.findings);
  if (static_cast<std::size_t>(session) < left.session_uses_sweep.size())
    left.session_uses_sweep.erase(left.session_uses_sweep.begin() + session);
  return left;
}

}  // namespace remount
