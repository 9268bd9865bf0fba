// What the next calibration is made of: sessions, nominal mounting, method, search range and options.
#pragma once

#include "app/gui/shell/feature.h"
#include "widgets/text/option_access.h"

class QPushButton;
class QVBoxLayout;

namespace remount::widgets {
class NominalPanel;
class OptionsDialog;
class RangePanel;
class SessionListModel;
class SessionsPanel;
}  // namespace remount::widgets

namespace remount::gui {

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
  void set_angle_unit(widgets::AngleUnit unit);  ///< of range and options
  void ask_for_nominal();
  void show_options();
  void make_options();
  void ask_for_default_options();

  widgets::SessionListModel* model_;
  widgets::SessionsPanel* sessions_;
  widgets::NominalPanel* nominal_;
  widgets::RangePanel* range_;
  QPushButton* run_ = nullptr;
  widgets::OptionsDialog* options_ = nullptr;
  widgets::AngleUnit angle_unit_ = widgets::AngleUnit::Degrees;
};

}  // namespace remount::gui
