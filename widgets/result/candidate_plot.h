// Candidates as points: two views that share their horizontal axis, as an engineer draws them.
#pragma once

#include <QWidget>
#include <array>
#include <memory>
#include <optional>

#include "model/pipeline/pipeline.h"
#include "widgets/basics/rows.h"

namespace remount::widgets {

/// Of three parameters, the second and the third over the first: x-y and x-z, or yaw-pitch and yaw-roll.
class CandidatePlot : public QWidget {
  Q_OBJECT
 public:
  enum class Kind { Position, Attitude };
  explicit CandidatePlot(Kind kind, QWidget* parent = nullptr);
  void show_output(std::shared_ptr<const pipeline::PipelineOutput> output);
  void show_range(const calibration::SearchRange& range);
  void show_nominal(const std::optional<RigidTransform>& nominal_ins_from_lidar);
  void show_selected(std::optional<calibration::CandidateIndex> candidate);
  std::optional<calibration::CandidateIndex> selected() const { return selected_; }
  /// Where a candidate is drawn in view 0 or 1; beyond the limits at the edge.
  QPointF place_of(calibration::CandidateIndex candidate, int view) const;
  std::optional<calibration::CandidateIndex> candidate_at(
      const QPointF& position) const;  ///< nothing where none is near
  QString title(int view) const;       ///< "pitch over yaw [°]"

  QSize minimumSizeHint() const override { return {220, 110}; }
  QSize sizeHint() const override { return {320, 200}; }

 signals:
  /// Under the mouse, clicked, or reached with the arrow keys.
  void candidate_pointed(calibration::CandidateIndex candidate);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Limits {
    double low = 0.0, high = 1.0;
  };
  calibration::Parameter parameter(int axis) const {
    return calibration::kParameters.at((kind_ == Kind::Position ? 0U : 3U) + static_cast<std::size_t>(axis));
  }
  std::size_t count() const { return output_ ? output_->result.candidates.size() : 0; }
  void find_limits();
  QRectF view_area(int view) const;
  QPointF to_screen(int view, double horizontal, double vertical) const;
  void paint_view(class QPainter& painter, int view) const;
  void paint_range(class QPainter& painter, int view) const;
  void paint_points(class QPainter& painter, int view) const;

  Kind kind_;
  std::shared_ptr<const pipeline::PipelineOutput> output_;
  std::vector<calibration::PerParameter<double>> shown_;  // of each candidate, on screen
  calibration::PerParameter<Limits> range_;
  std::optional<calibration::PerParameter<double>> nominal_, result_;
  std::array<Limits, 3> limits_{};
  std::optional<calibration::CandidateIndex> selected_;
};

}  // namespace remount::widgets
