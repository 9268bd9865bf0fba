#include "widgets/import/convention_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <algorithm>
#include <cmath>

#include "widgets/basics/shrinking_area.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wheel_scrolls.h"
#include "widgets/import/import_words.h"
#include "widgets/text/model_text.h"

namespace remount::widgets {
namespace {

using guesses::AttitudeStyle;
using guesses::GuessKind;
using guesses::Sureness;
using guesses::TableChoices;

constexpr std::int64_t kTimeUnits_ns[] = {1'000'000'000, 1'000'000, 1'000, 1, 0};
constexpr double kMostOffset_s = 3.9e9;

QColor (*sureness_color(Sureness sureness))(const QPalette&) {
  if (sureness == Sureness::Chosen) return faded_color;  // what it is worth the checks say
  return sureness == Sureness::Open ? bad_color : sureness == Sureness::Likely ? warning_color : good_color;
}

/// A list that is as narrow as its form makes it: its items are read when it is open.
QComboBox* narrow_list(QWidget* parent) {
  auto* list = new QComboBox(parent);
  list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  list->setMinimumContentsLength(10);
  let_wheel_scroll(*list);
  return list;
}

}  // namespace

ConventionForm::ConventionForm(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  groups_ = {make_group(tr("Time"), *row), make_group(tr("Position"), *row), make_group(tr("Attitude"), *row)};
  row->setStretch(Time, 4);
  row->setStretch(Position, 3);
  row->setStretch(Attitude, 6);
  make_time();
  make_position();
  make_attitude();
  for (Group& group : groups_) finish(group);
}

ConventionForm::Group ConventionForm::make_group(const QString& title, QHBoxLayout& row) {
  Group group;
  group.box = new QGroupBox(title, this);
  group.form = new QFormLayout(group.box);
  group.form->setContentsMargins(8, 2, 8, 4);
  group.form->setVerticalSpacing(3);
  group.form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  row.addWidget(group.box);
  return group;
}

QComboBox* ConventionForm::add_list(Group& group, const QString& label) {
  QComboBox* list = narrow_list(group.box);
  group.form->addRow(label, list);
  connect(list, &QComboBox::activated, this, &ConventionForm::read_form);
  return list;
}

QComboBox* ConventionForm::add_units(Group& group, const QString& label) {
  QComboBox* list = add_list(group, label);
  list->addItem(tr("degrees"), true);
  list->addItem(tr("radians"), false);
  return list;
}

void ConventionForm::make_time() {
  time_unit_ = add_list(groups_[Time], tr("&Unit"));
  for (const std::int64_t unit_ns : kTimeUnits_ns)
    time_unit_->addItem(time_unit_words(unit_ns), QVariant::fromValue<qlonglong>(unit_ns));
  date_order_ = add_list(groups_[Time], tr("&Dates are"));
  for (const auto order : {formats::DateOrder::YearFirst, formats::DateOrder::DayFirst, formats::DateOrder::MonthFirst})
    date_order_->addItem(date_order_words(order), static_cast<int>(order));
  time_scale_ = add_list(groups_[Time], tr("&Clock"));
  for (const auto scale : {formats::TimeScale::Unix, formats::TimeScale::Gps, formats::TimeScale::GpsWeek})
    time_scale_->addItem(time_scale_words(scale), static_cast<int>(scale));
  offset_s_ = new QDoubleSpinBox(groups_[Time].box);
  offset_s_->setDecimals(6);
  offset_s_->setRange(-kMostOffset_s, kMostOffset_s);
  offset_s_->setSuffix(tr(" s"));
  offset_s_->setKeyboardTracking(false);
  let_wheel_scroll(*offset_s_);
  offset_s_->setMinimumWidth(60);
  offset_s_->setToolTip(
      tr("Is added to the times of the table, not to those of the scans. A minus makes them earlier."));
  groups_[Time].form->addRow(tr("Add to its ti&mes"), offset_s_);
  connect(offset_s_, &QDoubleSpinBox::valueChanged, this, &ConventionForm::read_form);
}

void ConventionForm::make_position() {
  position_unit_ = add_list(groups_[Position], tr("U&nit"));
  for (const auto& [unit, name] : formats::kPlaceUnits)
    position_unit_->addItem(place_unit_words(unit), static_cast<int>(unit));
  position_unit_->setToolTip(tr("Of latitude and longitude. East, north, x, y, z and heights are metres."));
}

void ConventionForm::make_attitude() {
  Group& group = groups_[Attitude];
  style_ = add_list(group, tr("Counts &as"));
  for (std::size_t i = 0; i < guesses::kAttitudeStyleCount; ++i)
    style_->addItem(style_words(static_cast<AttitudeStyle>(i)), static_cast<int>(i));
  angle_unit_ = add_units(group, tr("Un&it"));
  auto* row = new QHBoxLayout;
  const QString names[] = {tr("heading"), tr("pitch"), tr("roll")};
  for (std::size_t i = 0; i < 3; ++i) {
    negated_.at(i) = new QCheckBox(names[i], group.box);
    negated_.at(i)->setToolTip(tr("The table counts this angle the other way than the convention above does"));
    negated_.at(i)->setAccessibleName(tr("%1 counts the other way").arg(names[i]));
    row->addWidget(negated_.at(i));
    connect(negated_.at(i), &QCheckBox::clicked, this, &ConventionForm::read_form);
  }
  row->addStretch();
  group.form->addRow(tr("Turned round"), row);
}

void ConventionForm::finish(Group& group) {
  const auto part = static_cast<Part>(&group - groups_.data());
  group.readings = narrow_list(group.box);
  group.readings->setAccessibleName(tr("Other readings that fit"));
  group.form->insertRow(0, tr("Readings that fit"), group.readings);
  connect(group.readings, &QComboBox::activated, this, [this, part](int row) { take_reading(part, row); });
  group.sureness = new QLabel(group.box);
  group.why = new QLabel(group.box);
  for (QLabel* label : {group.sureness, group.why}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  }
  group.why->setAlignment(Qt::AlignTop);
  group.form->addRow(group.sureness);
  auto* area = new ShrinkingArea(group.why, {120, 2 * fontMetrics().lineSpacing()});
  area->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
  area->viewport()->setAutoFillBackground(false);
  group.why->setAutoFillBackground(false);
  group.form->addRow(area);
}

const guesses::Guess* ConventionForm::guess(Part part) const {
  constexpr GuessKind kKinds[] = {GuessKind::Time, GuessKind::Position, GuessKind::Attitude};
  if (!table_.guess) return nullptr;
  const auto found = std::ranges::find(table_.guess->guesses, kKinds[part], &guesses::Guess::kind);
  return found == table_.guess->guesses.end() ? nullptr : &*found;
}

void ConventionForm::show_table(const guesses::ImportTable& table) {
  table_ = table;
  choices_ = table.preset;
  for (const Part part : {Time, Position, Attitude}) fill_readings(part);
  show_choices(table.preset);
}

void ConventionForm::fill_readings(Part part) {
  Group& group = groups_.at(part);
  group.others.clear();
  group.readings->clear();
  group.readings->addItem(tr("as guessed"));
  if (const guesses::Guess* found = guess(part))
    for (const formats::InsTableLayout& layout : found->other_layouts) {
      TableChoices other = table_.preset;
      if (part == Time)
        take_time(table_.table, layout, other);
      else
        take_motion(table_.table, layout, other);
      const QString words = difference_words(table_.table, table_.preset, other);
      if (words.isEmpty()) continue;
      group.readings->addItem(words);
      group.readings->setItemData(group.readings->count() - 1, words, Qt::ToolTipRole);
      group.others.push_back(std::move(other));
    }
  group.form->setRowVisible(group.readings, !group.others.empty());
}

/// Of another reading what it is about; the rest stays as it was chosen.
void ConventionForm::take_reading(Part part, int row) {
  const std::vector<TableChoices>& others = groups_.at(part).others;
  std::vector<Message> lacks;
  const TableChoices& wanted = row == 0 ? table_.preset : others.at(static_cast<std::size_t>(row - 1));
  const auto layout = layout_of(table_.table, wanted, lacks);
  if (!layout) return;
  TableChoices choices = choices_;
  if (part == Time)
    take_time(table_.table, *layout, choices);
  else
    take_motion(table_.table, *layout, choices);
  emit edited(choices);
}

bool ConventionForm::as_guessed(Part part) const {
  return part == Time       ? same_time(choices_, table_.preset)
         : part == Position ? same_position(choices_, table_.preset)
                            : same_attitude(choices_, table_.preset);
}

/// Whether it has its columns.
bool ConventionForm::is_whole(Part part) const {
  const auto all = [this](const auto& roles) {
    return std::ranges::all_of(roles, [this](guesses::ColumnRole role) { return choices_.has(role); });
  };
  using guesses::ColumnRole;
  if (part == Time) return choices_.has(ColumnRole::Time);
  if (part == Attitude)
    return guesses::is_quaternion(choices_.attitude) ? all(guesses::kQuaternionRoles) : all(guesses::kAngleRoles);
  if (!choices_.metric()) return all(guesses::kGeodeticRoles) && choices_.has(ColumnRole::Height);
  return all(std::array{ColumnRole::East, ColumnRole::North}) &&
         (choices_.has(ColumnRole::Height) || choices_.has(ColumnRole::Down));
}

void ConventionForm::show_guess(Part part) {
  Group& group = groups_.at(part);
  const guesses::Guess* found = guess(part);
  const bool guessed = found && as_guessed(part), whole = is_whole(part), seen = found || choices_ != table_.preset;
  const Sureness sureness = guessed ? found->sureness : Sureness::Chosen;
  group.sureness->setText(!whole ? tr("a column is missing: please choose")
                          : seen ? model_text(guesses::words(sureness))
                                 : tr("not compared with the data: please check"));
  set_style(*group.sureness, text_in(!whole ? bad_color : seen ? sureness_color(sureness) : warning_color));
  group.why->setText(guessed ? evidence_words(*found) : QString());
  group.why->setToolTip(group.why->text());
  const auto place = std::ranges::find(group.others, choices_);
  group.readings->setCurrentIndex(guessed                       ? 0
                                  : place == group.others.end() ? -1
                                                                : static_cast<int>(place - group.others.begin()) + 1);
}

void ConventionForm::show_choices(const TableChoices& choices) {
  choices_ = choices;
  time_unit_->setCurrentIndex(time_unit_->findData(QVariant::fromValue<qlonglong>(choices.time_unit_ns)));
  date_order_->setCurrentIndex(date_order_->findData(static_cast<int>(choices.date_order)));
  groups_[Time].form->setRowVisible(date_order_, choices.time_unit_ns == 0);
  time_scale_->setCurrentIndex(time_scale_->findData(static_cast<int>(choices.time_scale)));
  const QSignalBlocker quiet(offset_s_);
  offset_s_->setValue(1e-9 * static_cast<double>(choices.offset_ns));
  position_unit_->setCurrentIndex(position_unit_->findData(static_cast<int>(choices.position_unit)));
  groups_[Position].form->setRowVisible(position_unit_, !choices.metric());
  style_->setCurrentIndex(style_->findData(static_cast<int>(choices.attitude)));
  style_->setToolTip(style_->currentText());
  angle_unit_->setCurrentIndex(angle_unit_->findData(choices.attitude_in_deg));
  const bool angles = !guesses::is_quaternion(choices.attitude);
  angle_unit_->setEnabled(angles);
  for (std::size_t i = 0; i < 3; ++i) {
    negated_.at(i)->setChecked(choices.negated.at(i));
    negated_.at(i)->setEnabled(angles);
  }
  for (const Part part : {Time, Position, Attitude}) show_guess(part);
}

void ConventionForm::read_form() {
  TableChoices choices = choices_;
  choices.time_unit_ns = time_unit_->currentData().toLongLong();
  choices.date_order = static_cast<formats::DateOrder>(date_order_->currentData().toInt());
  choices.time_scale = static_cast<formats::TimeScale>(time_scale_->currentData().toInt());
  choices.offset_ns = std::llround(offset_s_->value() * 1e9);
  choices.position_unit = static_cast<formats::PlaceUnit>(position_unit_->currentData().toInt());
  choices.attitude = static_cast<AttitudeStyle>(style_->currentData().toInt());
  choices.attitude_in_deg = angle_unit_->currentData().toBool();
  for (std::size_t i = 0; i < 3; ++i) choices.negated.at(i) = negated_.at(i)->isChecked();
  emit edited(choices);
}

}  // namespace remount::widgets
