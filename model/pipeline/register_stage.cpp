#include "model/pipeline/register_stage.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/core/error.h"
#include "algorithms/core/parallel.h"
#include "algorithms/motion/pairing.h"
#include "algorithms/registration/registration.h"
#include "messages/pipeline.h"
#include "messages/stages.h"

namespace remount::pipeline {
namespace {

constexpr float kMovingMargin_m = 0.3f;

// Sessions with somebody's lidar poses take part in the solution, not in what is done with scans.
bool has_scans(const StageContext& context, motion::KeyframeIndex keyframe) {
  return context.motion.session(context.keyframes[keyframe].session).scans != nullptr;
}

std::vector<LidarBox> moving_boxes(const KeyframeObjects& scan) {
  std::vector<LidarBox> boxes;
  for (std::size_t i = 0; i < scan.objects.size(); ++i)
    if (scan.moving[i])
      boxes.push_back({scan.objects[i].box_min_in_lidar.array() - kMovingMargin_m,
                       scan.objects[i].box_max_in_lidar.array() + kMovingMargin_m});
  return boxes;
}

void reject(motion::Pair& pair, const Message& reason) {
  if (pair.decided_by == motion::DecidedBy::User) return;
  pair.state = motion::PairState::Rejected;
  pair.decided_by = motion::DecidedBy::Program;
  pair.reason = reason;
}

// Counts finished items across workers and reports them.
class Counter {
 public:
  Counter(Stage stage, std::size_t total, Progress& progress) : stage_(stage), total_(total), progress_(progress) {
    progress_.report(stage_, 0, total_);
  }
  void finished() { progress_.report(stage_, ++done_, total_); }

 private:
  Stage stage_;
  std::size_t total_;
  Progress& progress_;
  std::atomic<std::size_t> done_{0};
};

std::shared_ptr<const registration::PreparedCloud> prepare(const StageContext& context, ScanStore& scans,
                                                           const std::vector<KeyframeObjects>& objects,
                                                           motion::KeyframeIndex keyframe, const Progress& progress) {
  return scans.prepare(keyframe, context.keyframes[keyframe], moving_boxes(objects[keyframe]), progress);
}

// Points of one scan that the other looks past are no sign of a wrong alignment.
registration::RegistrationOptions options_for(const StageContext& context, const motion::Pair& pair,
                                              const RigidTransform& lidar_b_from_lidar_a) {
  registration::RegistrationOptions options = context.settings.registration;
  if (context.field)
    options.min_overlap *=
        std::max(kLeastShare, context.field->share(context.keyframes[pair.keyframe_a].session, lidar_b_from_lidar_a));
  return options;
}

int objects_needed(const StageContext& context, const motion::Pair& pair) {
  const int all_around = context.settings.pairing.min_shared_objects;
  if (!context.field) return all_around;
  return context.field->objects_needed(context.keyframes[pair.keyframe_a].session, all_around);
}

}  // namespace

Eigen::Vector3f up_in_lidar(const StageContext& context, const motion::Keyframe& keyframe) {
  const auto pose = context.motion.local_from_ins(keyframe.session, keyframe.stamp_ns);
  const Eigen::Matrix3d lidar_from_local =
      context.ins_from_lidar.linear().transpose() *
      (pose ? Eigen::Matrix3d(pose->linear().transpose()) : Eigen::Matrix3d::Identity());
  return (lidar_from_local * Eigen::Vector3d::UnitZ()).cast<float>();
}

void find_keyframe_objects(const StageContext& context, const ScanStore& scans, const std::vector<motion::Pair>& pairs,
                           std::vector<KeyframeObjects>& objects, Progress& progress) {
  objects.resize(context.keyframes.size());
  std::vector<motion::KeyframeIndex> to_look_at;
  for (const motion::KeyframeIndex k : motion::keyframes_of(pairs, context.keyframes.size()))
    if (!objects[k].looked_for && has_scans(context, k)) to_look_at.push_back(k);
  Counter counter(say::stage_finding_objects, to_look_at.size(), progress);
  parallel_for(to_look_at.size(), context.threads, [&](std::size_t i) {
    const motion::Keyframe& keyframe = context.keyframes[to_look_at[i]];
    KeyframeObjects& found = objects[to_look_at[i]];
    if (!progress.cancelled()) {
      try {
        found.objects =
            cloud::find_objects(scans.load(keyframe), up_in_lidar(context, keyframe), context.settings.objects);
      } catch (const Error& error) {
        found.failure = error.message();
      }
      for (cloud::SceneObject& object : found.objects) std::vector<int>().swap(object.points);
      found.moving.assign(found.objects.size(), false);
      found.looked_for = true;
    }
    counter.finished();
  });
}

void match_pairs(const StageContext& context, std::vector<KeyframeObjects>& objects, std::vector<motion::Pair>& pairs,
                 Progress& progress) {
  std::vector<std::vector<cloud::ObjectMatch>> matches(pairs.size());
  parallel_for(pairs.size(), context.threads, [&](std::size_t i) {
    const motion::Pair& pair = pairs[i];
    if (progress.cancelled()) return;
    matches[i] = cloud::match_objects(
        objects[pair.keyframe_a].objects, objects[pair.keyframe_b].objects,
        calibration::predicted_lidar_motion(pair.ins_b_from_ins_a, context.ins_from_lidar), context.settings.objects);
  });
  if (progress.cancelled()) return;  // missing matches are no reason to reject anything
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    motion::Pair& pair = pairs[i];
    if (!has_scans(context, pair.keyframe_a)) continue;
    KeyframeObjects& a = objects[pair.keyframe_a];
    KeyframeObjects& b = objects[pair.keyframe_b];
    pair.shared_objects = pair.moving_objects = 0;
    for (const cloud::ObjectMatch& match : matches[i]) {
      (match.moving ? pair.moving_objects : pair.shared_objects) += 1;
      if (!match.moving) continue;
      a.moving[match.object_a] = true;
      b.moving[match.object_b] = true;
    }
    if (!a.failure.empty() || !b.failure.empty())
      reject(pair, say::pipeline_pair_not_readable(a.failure.empty() ? b.failure : a.failure));
    else if (const int needed = objects_needed(context, pair); pair.shared_objects < needed)
      reject(pair, say::pipeline_too_few_shared_objects(pair.shared_objects, needed));
  }
}

void register_pairs(const StageContext& context, ScanStore& scans, const std::vector<KeyframeObjects>& objects,
                    std::vector<motion::Pair>& pairs, Progress& progress) {
  Counter counter(say::stage_registering_pairs, pairs.size(), progress);
  parallel_for(pairs.size(), context.threads, [&](std::size_t i) {
    motion::Pair& pair = pairs[i];
    if (pair.state != motion::PairState::Rejected && has_scans(context, pair.keyframe_a) && !progress.cancelled()) {
      try {
        const auto a = prepare(context, scans, objects, pair.keyframe_a, progress),
                   b = prepare(context, scans, objects, pair.keyframe_b, progress);
        const RigidTransform start = calibration::predicted_lidar_motion(pair.ins_b_from_ins_a, context.ins_from_lidar);
        const registration::RegistrationResult result =
            registration::align_scans(*a, *b, start, options_for(context, pair, start), progress);
        pair.lidar_b_from_lidar_a = result.target_from_source;
        pair.registration = result.quality;
      } catch (const Error& error) {
        pair.registration.attempted = true;
        pair.registration.failure = error.message();
      }
      if (!pair.registration.failure.empty()) reject(pair, pair.registration.failure);
    }
    counter.finished();
  });
}

void take_equations(const registration::AlignmentEquations& equations, const RigidTransform& lidar_b_from_lidar_a,
                    motion::Pair& pair) {
  pair.lidar_b_from_lidar_a = perturb(lidar_b_from_lidar_a, registration::damped_step(equations));
  pair.registration.information = equations.information;
  pair.registration.beam_response = equations.beam_response;
  pair.registration.undetermined = equations.undetermined.words();
  pair.registration.rmse_m = equations.rmse_m;
  pair.registration.overlap = equations.overlap;
}

void relinearise_pairs(const StageContext& context, ScanStore& scans, const std::vector<KeyframeObjects>& objects,
                       const std::vector<RigidTransform>& predicted_lidar_b_from_lidar_a,
                       std::vector<motion::Pair>& pairs, Progress& progress) {
  Counter counter(say::stage_aligning_all_clouds, pairs.size(), progress);
  parallel_for(pairs.size(), context.threads, [&](std::size_t i) {
    motion::Pair& pair = pairs[i];
    if (pair.state == motion::PairState::Accepted && has_scans(context, pair.keyframe_a) && !progress.cancelled()) {
      try {
        const auto a = prepare(context, scans, objects, pair.keyframe_a, progress),
                   b = prepare(context, scans, objects, pair.keyframe_b, progress);
        const RigidTransform& at = predicted_lidar_b_from_lidar_a[i];
        const registration::AlignmentEquations equations =
            registration::alignment_equations(*a, *b, at, 0.5 * context.settings.registration.max_correspondence_m,
                                              progress, context.settings.registration.beam_nodes);
        if (progress.cancelled()) return;
        take_equations(equations, at, pair);
      } catch (const Error&) {
        // A scan that has become unreadable since its registration: the pair keeps what it has.
      }
    }
    counter.finished();
  });
}

}  // namespace remount::pipeline
