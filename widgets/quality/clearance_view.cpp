#include "widgets/quality/clearance_view.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/basics/rows.h"
#include "widgets/result/verdict_table.h"
#include "widgets/text/parameter_text.h"

namespace remount::widgets {
namespace {

TableCell distance_cell(double distance_m) {
  if (!std::isfinite(distance_m)) return unknown_cell(ClearanceView::tr("Nothing is there within the heights."));
  return {QString::number(distance_m, 'f', 2), {}, Verdict::Neutral};
}

TableCell change_cell(double before_m, double after_m) {
  if (!std::isfinite(after_m - before_m))
    return unknown_cell(ClearanceView::tr("There is no point under one of the two."));
  const QString number = rounded_text(after_m - before_m, 3);
  return {number.toDouble() > 0.0 ? '+' + number : number, {}, Verdict::Neutral};
}

/// What tells names apart is often at their end, and the chooser is narrow: "…0005_sync" for
/// "2011_09_30_drive_0005_sync".
QStringList without_common_beginning(const QStringList& names) {
  if (names.size() < 2) return names;
  const QString& first = names.front();
  qsizetype common = first.size();
  for (const QString& name : names)
    common = std::min<qsizetype>(
        common, std::mismatch(first.begin(), first.end(), name.begin(), name.end()).first - first.begin());
  while (common > 0 && first[common - 1].isLetterOrNumber()) --common;  // whole words
  if (common < 4 || names.count(first) == names.size()) return names;
  QStringList shown;
  for (const QString& name : names) shown << QStringLiteral("…") + name.sliced(common);
  return shown;
}

}  // namespace

ClearanceView::ClearanceView(QWidget* parent)
    : QWidget(parent),
      plot_(new ClearancePlot(this)),
      table_(new FigureTable(tr("Distance of the nearest point on each side of the vehicle, metres"), this)),
      dashes_(new NoteLabel(this)),
      caution_(new NoteLabel(this)),
      session_(new QComboBox(this)),
      keyframe_(new QSpinBox(this)) {
  table_->setToolTip(
      tr("From the outline to the nearest point straight ahead, behind, left and right, in metres; "
         "nearest: in any direction. Points inside the outline are the vehicle."));
  auto* right = new QWidget(this);
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(make_controls());
  column->addWidget(caution_);
  column->addWidget(table_, 1);
  column->addWidget(dashes_);
  auto* splitter = new QSplitter(this);
  splitter->addWidget(plot_);
  splitter->addWidget(right);
  splitter->setStretchFactor(0, 3);
  splitter->setStretchFactor(1, 2);
  splitter->setChildrenCollapsible(false);
  auto* page = new QVBoxLayout(this);
  page->setContentsMargins(4, 4, 4, 4);
  page->addWidget(splitter);
  set_box({});
  show_nominal_known(true, {});
  show_message({});
}

QDoubleSpinBox* ClearanceView::make_length(const QString& name, const QString& tool_tip, double low_m, double high_m) {
  auto* spin = new QDoubleSpinBox(this);
  spin->setRange(low_m, high_m);
  spin->setSingleStep(0.1);
  spin->setSuffix(tr(" m"));
  spin->setKeyboardTracking(false);
  spin->setAccessibleName(name);
  spin->setToolTip(tool_tip);
  connect(spin, &QDoubleSpinBox::valueChanged, this, [this] { emit box_edited(box()); });
  return spin;
}

QWidget* ClearanceView::make_controls() {
  session_->setAccessibleName(tr("Session of the scan"));
  session_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  keyframe_->setAccessibleName(tr("Number of the scan"));
  keyframe_->setToolTip(tr("Which of the scans that the calibration used"));
  keyframe_->setMinimum(1);
  keyframe_->setKeyboardTracking(false);
  connect(session_, &QComboBox::currentIndexChanged, this, [this] {
    limit_keyframe();
    emit scan_chosen();
  });
  connect(keyframe_, &QSpinBox::valueChanged, this, &ClearanceView::scan_chosen);
  front_ = make_length(tr("Front"), tr("From the INS to the front end of the vehicle, m"), 0.0, 50.0);
  rear_ = make_length(tr("Rear"), tr("From the INS to the rear end of the vehicle, m"), 0.0, 50.0);
  half_width_ = make_length(tr("Half width"), tr("From the INS to either side of the vehicle, m"), 0.1, 10.0);
  height_min_ = make_length(tr("Lowest"), tr("Lower points are the ground: height against the INS, m"), -20.0, 20.0);
  height_max_ =
      make_length(tr("Highest"), tr("Higher points are bridges and branches: height against the INS, m"), -20.0, 20.0);
  auto* controls = new QWidget(this);
  auto* grid = new QGridLayout(controls);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(1);
  const auto add = [&](int line, int column, QWidget* editor, const QString& name, int columns = 1) {
    auto* label = new QLabel(name, controls);
    label->setBuddy(editor);
    grid->addWidget(label, 2 * line, column, 1, columns);
    grid->addWidget(editor, 2 * line + 1, column, 1, columns);
    grid->setColumnStretch(column, 1);
  };
  add(0, 0, session_, tr("Session"), 2);  // names of sessions are long
  add(0, 2, keyframe_, tr("Scan"));
  add(0, 3, half_width_, half_width_->accessibleName());
  add(1, 0, height_min_, height_min_->accessibleName());
  add(1, 1, height_max_, height_max_->accessibleName());
  add(1, 2, front_, front_->accessibleName());
  add(1, 3, rear_, rear_->accessibleName());
  return controls;
}

quality::VehicleBox ClearanceView::box() const {
  return {front_->value(), rear_->value(), half_width_->value(), height_min_->value(), height_max_->value()};
}

void ClearanceView::set_box(const quality::VehicleBox& box) {
  const std::array<std::pair<QDoubleSpinBox*, double>, 5> values{{{front_, box.front_m},
                                                                  {rear_, box.rear_m},
                                                                  {half_width_, box.half_width_m},
                                                                  {height_min_, box.height_min_m},
                                                                  {height_max_, box.height_max_m}}};
  for (const auto& [spin, value] : values) {
    const QSignalBlocker quiet(spin);
    spin->setValue(value);
  }
}

void ClearanceView::show_choices(const QStringList& sessions, const std::vector<int>& keyframes) {
  keyframes_ = keyframes;
  const QSignalBlocker quiet(session_);
  const int before = session_->currentIndex();
  session_->clear();
  const QStringList shown = without_common_beginning(sessions);
  for (qsizetype i = 0; i < sessions.size(); ++i) {
    session_->addItem(shown[i]);
    session_->setItemData(static_cast<int>(i), sessions[i], Qt::ToolTipRole);
  }
  session_->setCurrentIndex(std::clamp(before, sessions.isEmpty() ? -1 : 0, qt_count(sessions.size()) - 1));
  limit_keyframe();
}

std::optional<motion::SessionIndex> ClearanceView::chosen_session() const {
  return at_row<motion::SessionIndex>(session_->currentIndex());
}
int ClearanceView::chosen_keyframe() const { return keyframe_->value() - 1; }

void ClearanceView::limit_keyframe() {
  const QSignalBlocker quiet(keyframe_);
  const std::optional<motion::SessionIndex> session = chosen_session();
  const int count = session && *session < keyframes_.size() ? keyframes_[*session] : 0;
  keyframe_->setMaximum(std::max(1, count));
  keyframe_->setSuffix(tr(" of %1").arg(count));
  for (QWidget* editor : {static_cast<QWidget*>(session_), static_cast<QWidget*>(keyframe_)})
    editor->setEnabled(count > 0);
}

void ClearanceView::show_nominal_known(bool known, const QString& caution) {
  nominal_known_ = known;
  plot_->name_before(known ? tr("nominal") : tr("start"));
  caution_->setText(caution);
  caution_->setVisible(!caution.isEmpty() && shows_scan_);
}

void ClearanceView::show_message(const QString& text) {
  shows_scan_ = false;
  plot_->show_message(text);
  table_->hide();
  dashes_->hide();
  caution_->hide();
}

void ClearanceView::show_scan(const QString& name, const MeasuredScanPtr& scan) {
  shows_scan_ = true;
  plot_->show_scan(name, scan);
  show_figures(scan->free_before, scan->free_after);
  table_->show();
  caution_->setVisible(!caution_->text().isEmpty());
}

void ClearanceView::show_figures(const quality::Clearances& before, const quality::Clearances& after) {
  const auto all = [](const quality::Clearances& found) {
    return std::array<double, 5>{found.sides[0].distance_m, found.sides[1].distance_m, found.sides[2].distance_m,
                                 found.sides[3].distance_m, found.nearest.distance_m};
  };
  const std::array<double, 5> before_m = all(before), after_m = all(after);
  std::vector<TableCell> was{{nominal_known_ ? tr("Nominal") : tr("Start"), {}, Verdict::Neutral}},
      is{{tr("With result"), {}, Verdict::Neutral}}, change{{tr("Difference"), {}, Verdict::Neutral}};
  bool any_dash = false;
  for (std::size_t i = 0; i < before_m.size(); ++i) {
    any_dash = any_dash || !std::isfinite(before_m[i] + after_m[i]);
    was.push_back(distance_cell(before_m[i]));
    is.push_back(distance_cell(after_m[i]));
    change.push_back(change_cell(before_m[i], after_m[i]));
  }
  table_->show_rows({tr("Free [m]"), tr("Front"), tr("Rear"), tr("Left"), tr("Right"), tr("Nearest")},
                    nominal_known_ ? std::vector{was, is, change} : std::vector{was, is});  // the start is no mounting
  dashes_->show_note(any_dash
                         ? tr("–: no point of the scan lies on that side within the heights. Nothing was seen there, "
                              "which is less than knowing that it is free.")
                         : QString());
}

}  // namespace remount::widgets
