// How the columns of a table count: time, position and attitude, each with what was guessed and why.
#pragma once

#include <QWidget>
#include <array>
#include <memory>

#include "model/guesses/table_import.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QGroupBox;
class QHBoxLayout;
class QLabel;

namespace remount::widgets {

class ConventionForm : public QWidget {
  Q_OBJECT
 public:
  explicit ConventionForm(QWidget* parent = nullptr);
  void show_table(const guesses::ImportTable& table);
  void show_choices(const guesses::TableChoices& choices);

 signals:
  void edited(const guesses::TableChoices& choices);

 private:
  enum Part { Time, Position, Attitude, PartCount };
  struct Group {
    QGroupBox* box = nullptr;
    QFormLayout* form = nullptr;
    QComboBox* readings = nullptr;  ///< what else fits
    QLabel *sureness = nullptr, *why = nullptr;
    std::vector<guesses::TableChoices> others;
  };
  Group make_group(const QString& title, QHBoxLayout& row);
  void make_time();
  void make_position();
  void make_attitude();
  QComboBox* add_list(Group& group, const QString& label);
  QComboBox* add_units(Group& group, const QString& label);
  void finish(Group& group);
  void fill_readings(Part part);
  void take_reading(Part part, int row);
  void show_guess(Part part);
  bool as_guessed(Part part) const;
  bool is_whole(Part part) const;
  const guesses::Guess* guess(Part part) const;
  void read_form();

  std::array<Group, PartCount> groups_;
  QComboBox *time_unit_ = nullptr, *date_order_ = nullptr, *time_scale_ = nullptr, *position_unit_ = nullptr;
  QComboBox *style_ = nullptr, *angle_unit_ = nullptr;
  QDoubleSpinBox* offset_s_ = nullptr;
  std::array<QCheckBox*, 3> negated_{};
  guesses::ImportTable table_;
  guesses::TableChoices choices_;
};

}  // namespace remount::widgets
