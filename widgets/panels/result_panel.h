// The result: six parameters with their sigma or "not observed", what that means, and what to do.
#pragma once

#include <QScrollArea>
#include <array>
#include <memory>
#include <optional>

#include "model/pipeline.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace remount {

class ResultPanel : public QScrollArea {
  Q_OBJECT
 public:
  explicit ResultPanel(QWidget* parent = nullptr);
  /// `before`: the result that the present one is compared with ("moved"); null where there is none.
  void show_output(std::shared_ptr<const PipelineOutput> output, std::shared_ptr<const PipelineOutput> before);
  /// A line under the status: "solving again…", "options changed since"; empty for none.
  void show_note(const QString& note);

 signals:
  void copy_requested();
  void export_requested();

 private:
  struct Row {
    QLabel *value, *sigma, *moved;
  };
  void make_labels(QGridLayout& grid);
  void make_rows(QGridLayout& grid);
  void make_buttons(QGridLayout& grid);
  void show_parameters(const CalibrationResult& result, const CalibrationResult* before);
  void show_words(const PipelineOutput& output);

  QLabel* status_;
  QLabel* note_;
  QLabel* words_;
  QPushButton* copy_;
  QPushButton* export_;
  std::array<Row, 6> rows_{};
};

/// "Solved", "Solved in part", … for a heading.
QString status_title(Status status);
/// Whether the six numbers of a result mean anything.
bool has_numbers(Status status);
/// "x = 0.9000 m ± 0.0020 …" line by line, for the clipboard.
QString result_as_text(const CalibrationResult& result);

}  // namespace remount
