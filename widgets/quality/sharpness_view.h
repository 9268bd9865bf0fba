// How sharp the accumulated map is under the nominal, the result and the best candidates.
#pragma once

#include <QWidget>
#include <memory>

#include "model/pipeline/pipeline.h"

class QPushButton;

namespace remount::widgets {

class FigureTable;
class NoteLabel;
class VerdictLabel;
enum class MapX;

class SharpnessView : public QWidget {
  Q_OBJECT
 public:
  explicit SharpnessView(QWidget* parent = nullptr);
  void show_message(const QString& text);  ///< why there are no numbers
  void show_sharpness(const std::vector<quality::NamedSharpness>& sharpness);
  /// Which maps can be looked at. `start`: what the calibration began with, "nominal" where one was given.
  void offer_maps(bool any, const QString& start);

 signals:
  void map_requested(widgets::MapX x);

 private:
  VerdictLabel* verdict_;
  FigureTable* table_;
  NoteLabel* order_;  // what the order of the rows says
  QPushButton *before_, *after_;
};

}  // namespace remount::widgets
