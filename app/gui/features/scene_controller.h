// Between the workbench and the 3-D view of the pair: what takes long is prepared in the background.
#pragma once

#include <QObject>
#include <functional>
#include <optional>

#include "app/gui/workbench/workbench.h"
#include "widgets/pairs/pair_view.h"

namespace remount::gui {

class SceneController : public QObject {
  Q_OBJECT
 public:
  using Caption = std::function<QString(motion::PairIndex pair)>;
  SceneController(Workbench& workbench, widgets::PairView& pair_view, Caption caption, QObject* parent = nullptr);

  void show_pair(motion::PairIndex pair, const scene::PairSceneDataPtr& data);
  /// Clouds of no pair of the output, as soon as they are prepared and until a pair is selected.
  void show_clouds(const QString& caption, const CloudsPtr& clouds, const scene::PairTransforms& transforms);
  /// A pair of the output is on its way, or none: clouds that are being prepared are no longer wanted.
  void forget_clouds();
  /// The output changed: the same clouds, under what holds now.
  void refresh();
  /// Looks at the mounting of a candidate instead of the result; nothing: the result.
  void show_candidate(std::optional<calibration::CandidateIndex> candidate);
  std::optional<calibration::CandidateIndex> candidate() const { return candidate_; }
  bool preparing() const { return jobs_.running(clouds_job_) || jobs_.running(distance_job_); }

 private:
  scene::PairTransforms transforms(motion::PairIndex pair) const;
  void name_candidate();
  void face_forward();
  void start_distances(const widgets::DistanceRequest& request);
  JobRunner::Failed report_failure();

  Workbench& workbench_;
  widgets::PairView& pair_view_;
  Caption caption_;
  std::optional<calibration::CandidateIndex> candidate_;
  int clouds_job_ = 0, distance_job_ = 0;
  std::optional<widgets::DistanceRequest> next_distances_;  // the last that was asked for while others were computed
  JobRunner jobs_;  // last: its threads end before anything they report to is gone
};

}  // namespace remount::gui
