// The result: six parameters with their sigma or "not observed", what that means, and what to do.
#pragma once

#include <QScrollArea>
#include <array>
#include <memory>
#include <optional>

#include "model/pipeline/pipeline.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace remount::widgets {

class CorrelationChart;

/// How the result that is shown stands to what is set now.
/// BeingRefined: X is new, its sigmas are not yet.
enum class ResultStanding { Current, OutOfDate, BeingReplaced, BeingRefined };

class ResultPanel : public QScrollArea {
  Q_OBJECT
 public:
  explicit ResultPanel(QWidget* parent = nullptr);
  /// `before`: the result that the present one is compared with ("moved"); null where there is none. `moved_by`: the
  /// edit between the two; empty for a calibration.
  void show_output(std::shared_ptr<const pipeline::PipelineOutput> output,
                   std::shared_ptr<const pipeline::PipelineOutput> before, const QString& moved_by = {});
  /// `note`: a line under the status that says what the standing comes from; empty for none. `next`: what is to be done
  /// or under way, shown as long as there is no result.
  void show_standing(ResultStanding standing, const QString& note, const QString& next);

  /// So wide that no number loses its unit.
  QSize minimumSizeHint() const override;

 signals:
  void copy_requested();
  void export_requested();
  /// Solve X with the clock offset that was found, or without it.
  void clock_offset_asked(bool with_it);

 private:
  struct Row {
    QLabel *value, *sigma, *moved;
  };
  void make_labels(QGridLayout& grid);
  void make_rows(QGridLayout& grid);
  void make_buttons(QGridLayout& grid);
  void show_parameters(const calibration::CalibrationResult& result, bool nominal_known,
                       const calibration::CalibrationResult* before);
  void show_words(const pipeline::PipelineOutput& output);
  void show_clock_button(const pipeline::PipelineOutput* output);
  void show_status();
  static QString what_x_is(const calibration::CalibrationResult& result);

  QLabel* value_title_ = nullptr;
  QLabel* status_;
  QLabel* note_;
  QLabel* moved_by_;
  QLabel* words_;
  QLabel* correlation_title_;
  CorrelationChart* correlation_;
  QPushButton* copy_;
  QPushButton* export_;
  QPushButton* clock_;
  calibration::PerParameter<Row> rows_;
  std::shared_ptr<const pipeline::PipelineOutput> shown_;  // nothing: no result yet
  ResultStanding standing_ = ResultStanding::Current;
  QString next_;
};

/// "Solved", "Solved in part", … for a heading.
QString status_title(const calibration::CalibrationResult& result);
/// "x = 0.9000 m ± 0.0020 …" line by line, for the clipboard.
QString result_as_text(const calibration::CalibrationResult& result);

}  // namespace remount::widgets
