#include "remount/calibrate.h"

#include <map>
#include <utility>

#include "algorithms/core/parallel.h"
#include "api/bridge.h"
#include "api/result_inside.h"
#include "messages/programs.h"
#include "model/methods/calibrate.h"
#include "model/project/project.h"
#include "model/results/disagreement.h"
#include "model/results/input_files.h"
#include "model/results/mounting_frames.h"

namespace remount::api {
namespace {

Result result_of(const pipeline::PipelineInput& input, const pipeline::PipelineOutput& output,
                 std::vector<results::InputFile> files) {
  const auto inside = std::make_shared<Result::Inside>();
  inside->file = project::make_result_file(input, output, std::move(files));
  inside->findings = output.findings;
  inside->keyframes = output.keyframes;
  inside->pairs = output.pairs;
  return Result(inside);
}

pipeline::PipelineInput input_of(const CalibrateOptions& options) {
  pipeline::PipelineInput input;
  input.settings = options.settings.inside();
  settings::require_valid(input.settings);
  if (options.threads < 0 || options.threads > kMostThreads)
    throw remount::Error(remount::ErrorCode::Contract, "threads", say::api_threads(options.threads));
  input.threads = options.threads;
  if (options.nominal_ins_from_lidar)
    input.nominal_ins_from_lidar = rigid_of_matrix(*options.nominal_ins_from_lidar, "nominal_ins_from_lidar");
  return input;
}

/// Names the moments of the pairs by what they are called.
class MomentList {
 public:
  motion::KeyframeIndex keyframe(std::size_t number) {
    const auto [place, is_new] = places_.try_emplace(number, keyframes_.size());
    if (is_new) {
      const motion::ScanIndex scan(number);
      keyframes_.push_back({motion::SessionIndex(), scan, signed_of(scan), 0.0});
    }
    return place->second;
  }
  std::vector<motion::Keyframe> take() { return std::move(keyframes_); }

 private:
  std::map<std::size_t, motion::KeyframeIndex> places_;
  std::vector<motion::Keyframe> keyframes_;
};

void require_numbers(const std::vector<MotionPair>& pairs) {
  if (pairs.empty()) throw remount::Error(remount::ErrorCode::Contract, "pairs", say::api_no_pairs());
  for (const MotionPair& pair : pairs)
    if (pair.a.has_value() != pairs.front().a.has_value() || pair.b.has_value() != pair.a.has_value())
      throw remount::Error(remount::ErrorCode::Contract, "pairs", say::api_pair_numbers());
}

void add_pairs(const std::vector<MotionPair>& pairs, pipeline::PipelineOutput& output) {
  require_numbers(pairs);
  MomentList moments;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::string where = "pairs[" + std::to_string(i) + "]";
    if (pairs[i].a && pairs[i].a == pairs[i].b)
      throw remount::Error(remount::ErrorCode::Contract, where, say::api_pair_of_one_moment());
    motion::Pair pair;
    pair.keyframe_a = moments.keyframe(pairs[i].a.value_or(2 * i + 1));
    pair.keyframe_b = moments.keyframe(pairs[i].b.value_or(2 * i));
    pair.ins_b_from_ins_a = rigid_of_matrix(pairs[i].ins_b_from_ins_a, where + ".ins_b_from_ins_a");
    pair.lidar_b_from_lidar_a = rigid_of_matrix(pairs[i].lidar_b_from_lidar_a, where + ".lidar_b_from_lidar_a");
    pair.registration.overlap = 1.0;
    output.pairs.push_back(pair);
  }
  output.keyframes = moments.take();
}

}  // namespace

Result calibrate(const std::vector<Session>& sessions, const CalibrateOptions& options, const Progress& progress) {
  return with_progress(progress, [&](remount::Progress& inner) {
    pipeline::PipelineInput input = input_of(options);
    for (const Session& session : sessions) input.sessions.push_back(session.inside());
    const method_registry::CalibrationMethod& method = *input.settings.run.method;
    if (method.frames) input.nominal_frames = method.frames(input.sessions);
    if (!input.nominal_ins_from_lidar && !options.ignore_declared_nominal)
      input.nominal_ins_from_lidar = results::declared_nominal(input.sessions, method);
    const pipeline::PipelineOutput output = methods::calibrate(input, inner);
    std::vector<results::InputFile> files;
    if (options.hash_inputs) files = results::hash_inputs(input.sessions, input.threads, inner);
    return result_of(input, output, std::move(files));
  });
}

Result solve(const std::vector<MotionPair>& pairs, const CalibrateOptions& options, const Progress& progress) {
  return with_progress(progress, [&](remount::Progress& inner) {
    const pipeline::PipelineInput input = input_of(options);
    pipeline::PipelineOutput output;
    add_pairs(pairs, output);
    output.result = pipeline::solve_motion_pairs(output.keyframes, output.pairs, input.settings,
                                                 input.nominal_ins_from_lidar, inner);
    results::report_disagreement(output.result, output.findings);
    return result_of(input, output, {});
  });
}

}  // namespace remount::api
