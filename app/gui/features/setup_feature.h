// What the next calibration is made of: sessions, nominal mounting, method, search range and options.
#pragma once

#include "app/gui/shell/feature.h"
#include "widgets/text/option_access.h"

class QPushButton;
class QVBoxLayout;

namespace remount {

class NominalPanel;
class OptionsDialog;
class RangePanel;
class SessionListModel;
class SessionsPanel;

class SetupFeature : public Feature {
  Q_OBJECT
 public:
  explicit SetupFeature(MainWindow& window);
  std::vector<TurnQueue::Piece> show_output_later() override;
  void show_state() override;
  void show_palette(const QPalette& palette) override;

 private:
  QWidget* make_column();
  void add_method(QVBoxLayout& column);
  void add_run(QVBoxLayout& column);
  void connect_sessions();
  void connect_setup();
  void show_sessions();
  void set_angle_unit(AngleUnit unit);  ///< of range and options
  void ask_for_nominal();
  void show_options();
  void make_options();
  void ask_for_default_options();

  SessionListModel* model_;
  SessionsPanel* sessions_;
  NominalPanel* nominal_;
  RangePanel* range_;
  QPushButton* run_ = nullptr;
  OptionsDialog* options_ = nullptr;
  AngleUnit angle_unit_ = AngleUnit::Degrees;
};

}  // namespace remount
