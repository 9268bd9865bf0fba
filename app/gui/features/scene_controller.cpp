#include "app/gui/features/scene_controller.h"

#include <cmath>

#include "model/drive/session_frames.h"
#include "widgets/result/candidate_table_model.h"

namespace remount::gui {

SceneController::SceneController(Workbench& workbench, widgets::PairView& pair_view, Caption caption, QObject* parent)
    : QObject(parent), workbench_(workbench), pair_view_(pair_view), caption_(std::move(caption)) {
  connect(&pair_view_, &widgets::PairView::distances_wanted, this, &SceneController::start_distances);
}

JobRunner::Failed SceneController::report_failure() {
  return [this](const JobFailure& failure) {
    workbench_.notices().say(drive::Severity::Problem, failure.where, failure.what);
  };
}

void SceneController::show_pair(motion::PairIndex pair, const scene::PairSceneDataPtr& data) {
  forget_clouds();
  if (!pair_view_.has_gl() || !workbench_.outcome().output()) return;
  face_forward();
  pair_view_.show_pair(caption_(pair), data, transforms(pair));
}

void SceneController::face_forward() {
  const RigidTransform vehicle_from_ins = drive::vehicle_from_ins(workbench_.sessions().all());
  const Eigen::Vector3d forward_in_ins = vehicle_from_ins.linear().transpose() * Eigen::Vector3d::UnitX();
  pair_view_.set_forward(std::atan2(forward_in_ins.y(), forward_in_ins.x()));
}

void SceneController::show_clouds(const QString& caption, const CloudsPtr& clouds,
                                  const scene::PairTransforms& transforms) {
  forget_clouds();
  candidate_.reset();
  name_candidate();
  if (!pair_view_.has_gl()) return;
  face_forward();
  auto job = std::make_shared<int>(0);
  clouds_job_ = jobs_.start(
      [this, job, caption, clouds, transforms](Progress& progress) -> JobRunner::Deliver {
        scene::PairSceneDataPtr data = scene::prepare_pair_scene(clouds, progress);
        return [this, job, caption, data, transforms] {
          if (data && *job == clouds_job_) pair_view_.show_pair(caption, data, transforms);
        };
      },
      report_failure());
  *job = clouds_job_;
}

void SceneController::forget_clouds() {
  jobs_.cancel(clouds_job_);
  clouds_job_ = 0;
}

void SceneController::refresh() {
  candidate_.reset();  // places in the list mean others now
  name_candidate();
  const OutputPtr output = workbench_.outcome().output();
  const std::optional<motion::PairIndex> pair = workbench_.selection().pair();
  if (output && pair && *pair < output->pairs.size()) pair_view_.show_transforms(caption_(*pair), transforms(*pair));
}

void SceneController::show_candidate(std::optional<calibration::CandidateIndex> candidate) {
  const OutputPtr output = workbench_.outcome().output();
  const bool known = output && candidate && *candidate < output->result.candidates.size();
  if (!known || candidate == widgets::place_of_result(output->result)) candidate.reset();
  if (candidate == candidate_) return;
  candidate_ = candidate;
  name_candidate();
  const std::optional<motion::PairIndex> pair = workbench_.selection().pair();
  if (!output || !pair) return;
  pair_view_.show_transforms(caption_(*pair), transforms(*pair));
  if (candidate_) pair_view_.show_alignment(scene::PairAlignment::CurrentX);
}

void SceneController::name_candidate() {
  pair_view_.name_current(!candidate_ ? QString() : tr("candidate %1").arg(*candidate_ + 1));
}

scene::PairTransforms SceneController::transforms(motion::PairIndex pair) const {
  const OutputPtr output = workbench_.outcome().output();
  const RigidTransform* const candidate =
      !candidate_ ? nullptr : &output->result.candidates.at(*candidate_).ins_from_lidar;
  scene::PairTransforms transforms = scene::pair_transforms(*output, pair, candidate);
  const RigidTransform vehicle_from_ins = drive::vehicle_from_ins(workbench_.sessions().all());
  transforms.up_in_view = vehicle_from_ins.linear().transpose() * Eigen::Vector3d::UnitZ();
  return transforms;
}

void SceneController::start_distances(const widgets::DistanceRequest& request) {
  if (jobs_.running(distance_job_)) {
    next_distances_ = request;
    return;
  }
  distance_job_ = jobs_.start(
      [this, request](Progress& progress) -> JobRunner::Deliver {
        std::vector<std::vector<float>> distances_m;
        for (const RigidTransform& lidar_b_from_lidar_a : request.lidar_b_from_lidar_a)
          distances_m.push_back(scene::distances_to_target(*request.data, lidar_b_from_lidar_a, progress));
        return [this, request, distances_m = std::move(distances_m)]() mutable {
          pair_view_.show_distances(request, std::move(distances_m));
          if (next_distances_) start_distances(*std::exchange(next_distances_, std::nullopt));
        };
      },
      report_failure());
}

}  // namespace remount::gui
