#include "widgets/result/result_panel.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <algorithm>
#include <cmath>

#include "algorithms/core/index.h"
#include "model/method_registry/calibration_method.h"
#include "model/pipeline/offset_search.h"
#include "model/results/preliminary.h"
#include "model/results/result_file.h"
#include "model/results/result_words.h"
#include "widgets/basics/theme.h"
#include "widgets/result/correlation_chart.h"
#include "widgets/result/result_tables.h"
#include "widgets/text/model_text.h"
#include "widgets/text/pair_counts.h"
#include "widgets/text/parameter_text.h"

namespace remount::widgets {
namespace {

constexpr int kStatusRow = 0, kNoteRow = 1, kTitleRow = 2, kFirstParameterRow = 3, kMovedByRow = 9, kButtonRow = 10,
              kWordsRow = 11, kCorrelationTitleRow = 12, kCorrelationRow = 13;
constexpr int kColumns = 4;

auto status_color(const calibration::CalibrationResult& result) -> QColor (*)(const QPalette&) {
  const calibration::Status status = result.status;
  if (status == calibration::Status::Ok) return good_color;
  if (results::knows_nothing(result)) return bad_color;
  return status == calibration::Status::Degenerate || status == calibration::Status::Inconsistent ? warning_color
                                                                                                  : bad_color;
}

}  // namespace

QString status_title(const calibration::CalibrationResult& result) {
  if (results::is_preliminary(result)) return ResultPanel::tr("Preliminary: the calibration was cancelled");
  switch (result.status) {
    case calibration::Status::Ok:
      return ResultPanel::tr("Solved");
    case calibration::Status::Degenerate:
      return results::knows_nothing(result) ? ResultPanel::tr("Not solved: nothing is observed")
                                            : ResultPanel::tr("Solved, but not every direction");
    case calibration::Status::TooFewPairs:
      return ResultPanel::tr("Not solved: too few pairs");
    case calibration::Status::TooLittleData:
      return ResultPanel::tr("Not solved: too little data");
    case calibration::Status::NoUsableData:
      return ResultPanel::tr("Not solved: nothing of the data can be used");
    case calibration::Status::NotConverged:
      return ResultPanel::tr("Not solved: did not converge");
    case calibration::Status::OutOfRange:
      return ResultPanel::tr("Not solved: the solution lies outside the search range");
    case calibration::Status::Inconsistent:
      return ResultPanel::tr("Do not trust this result");  // its own words say why
    case calibration::Status::Cancelled:
      return ResultPanel::tr("Cancelled");
  }
  return {};
}

QString result_as_text(const calibration::CalibrationResult& result) {
  QStringList lines{status_title(result)};
  if (!calibration::is_solved(result.status) && !result.message.empty()) lines << model_text(result.message);
  lines << ResultPanel::tr("ins_from_lidar (LiDAR to INS), R = Rz(yaw) Ry(pitch) Rx(roll)");
  if (!results::has_mounting(result)) return lines.join('\n');
  const calibration::PerParameter<double> values = results::six_on_screen(result.mounting.reference_from_sensor);
  for (const calibration::Parameter i : calibration::kParameters) {
    const std::optional<double> sigma = result.estimate(i).sigma;
    if (!sigma && values[i] == 0.0) {  // nobody gave it, and a number would be taken for one
      lines << QStringLiteral("%1 = – %2").arg(parameter_name(i), ResultPanel::tr("(not observed)"));
      continue;
    }
    lines << QStringLiteral("%1 = %2%3 %4")
                 .arg(parameter_name(i))
                 .arg(rounded_text(values[i], 4))
                 .arg(unit_suffix(i), sigma ? spread_text(results::on_screen(i, *sigma), 4) + unit_suffix(i)
                                            : ResultPanel::tr("(not observed: do not rely on it)"));
  }
  return lines.join('\n');
}

ResultPanel::ResultPanel(QWidget* parent)
    : QScrollArea(parent),
      status_(new QLabel),
      note_(new QLabel),
      moved_by_(new QLabel),
      words_(new QLabel),
      correlation_title_(new QLabel(tr("<b>Correlations</b>"))),
      correlation_(new CorrelationChart),
      copy_(new QPushButton(tr("Copy"))),
      export_(new QPushButton(tr("Export…"))),
      clock_(new QPushButton) {
  auto* content = new QWidget;
  auto* grid = new QGridLayout(content);
  grid->setContentsMargins(8, 8, 8, 8);
  make_labels(*grid);
  make_rows(*grid);
  make_buttons(*grid);
  grid->addWidget(correlation_title_, kCorrelationTitleRow, 0, 1, kColumns);
  grid->addWidget(correlation_, kCorrelationRow, 0, 1, kColumns);
  grid->setRowStretch(kCorrelationRow + 1, 1);
  grid->setColumnStretch(1, 1);
  grid->setHorizontalSpacing(10);
  setWidget(content);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  show_standing(ResultStanding::Current, {}, {});
  show_output(nullptr, nullptr);
}

QSize ResultPanel::minimumSizeHint() const {
  constexpr int kMost_px = 360;
  const int bar = verticalScrollBar()->sizeHint().width();
  return {std::min(kMost_px, widget()->minimumSizeHint().width() + bar), QScrollArea::minimumSizeHint().height()};
}

void ResultPanel::make_labels(QGridLayout& grid) {
  for (QLabel* label : {status_, note_, moved_by_, words_}) {
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  }
  status_->setAccessibleName(tr("Status of the result"));
  words_->setAccessibleName(tr("Explanation of the result"));
  words_->setAlignment(Qt::AlignTop);
  words_->setToolTip(tr(
      "Errors summed: E(X), the sum of ‖P X − X Q‖ over the accepted pairs (Frobenius norm), with P the motion of the "
      "INS and Q that of the LiDAR."));
  grid.addWidget(status_, kStatusRow, 0, 1, kColumns);
  grid.addWidget(note_, kNoteRow, 0, 1, kColumns);
  moved_by_->setAccessibleName(tr("What the result is compared with"));
  grid.addWidget(moved_by_, kMovedByRow, 0, 1, kColumns);
  grid.addWidget(words_, kWordsRow, 0, 1, kColumns);
}

void ResultPanel::make_rows(QGridLayout& grid) {
  const std::array<QString, kColumns> titles{QString(), what_x_is({}), tr("1 sigma"), tr("moved")};
  const std::array<QString, kColumns> helps{
      QString(),
      tr("X is the mounting: where the LiDAR sits in the frame of the INS (x, y, z) and how it is turned there (yaw, "
         "pitch, roll). Methods that know no INS say here in which frame X is instead."),
      tr("How far the value may be off: in two of three cases it is closer than this"),
      tr("Change since the result before; what made it is said below the numbers")};
  for (int column = 0; column < kColumns; ++column) {
    auto* title = new QLabel(titles[index_at(column)]);
    title->setAlignment(Qt::AlignRight | Qt::AlignBottom);
    title->setWordWrap(column == 1);  // the numbers need the room
    title->setToolTip(helps[index_at(column)]);
    grid.addWidget(title, kTitleRow, column);
    if (column == 1) value_title_ = title;
  }
  for (const calibration::Parameter i : calibration::kParameters) {
    const int row = kFirstParameterRow + calibration::row_of(i);
    grid.addWidget(new QLabel(parameter_name(i)), row, 0);
    rows_[i] = {new QLabel, new QLabel, new QLabel};
    int column = 1;
    for (QLabel* label : {rows_[i].value, rows_[i].sigma, rows_[i].moved}) {
      label->setAlignment(Qt::AlignRight);
      label->setTextInteractionFlags(Qt::TextSelectableByMouse);
      grid.addWidget(label, row, column++);
    }
    rows_[i].value->setAccessibleName(tr("Value of %1").arg(parameter_name(i)));
    rows_[i].sigma->setAccessibleName(tr("Sigma of %1").arg(parameter_name(i)));
    rows_[i].moved->setToolTip(tr("Change since the result before; what made it is said below the numbers"));
  }
}

void ResultPanel::make_buttons(QGridLayout& grid) {
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(copy_);
  buttons->addWidget(export_);
  buttons->addWidget(clock_);
  buttons->addStretch();
  grid.addLayout(buttons, kButtonRow, 0, 1, kColumns);
  connect(copy_, &QPushButton::clicked, this, &ResultPanel::copy_requested);
  connect(export_, &QPushButton::clicked, this, &ResultPanel::export_requested);
  connect(clock_, &QPushButton::clicked, this,
          [this] { emit clock_offset_asked(shown_ && !shown_->result.time_offset.applied); });
}

// There where an offset was found: what is done with it is taken back by one click, and by another done again.
void ResultPanel::show_clock_button(const pipeline::PipelineOutput* output) {
  const bool applied = output && output->result.time_offset.applied;
  clock_->setVisible(output && results::has_mounting(output->result) &&
                     (applied || pipeline::clock_differs(output->result)));
  clock_->setText(applied ? tr("Without clock offset") : tr("With clock offset"));
  clock_->setToolTip(applied ? tr("X is solved with the offset that was found between the clocks of LiDAR and INS; "
                                  "solve it as if the clocks agreed")
                             : tr("The clocks of LiDAR and INS differ, and X is biased by it; solve X with the offset "
                                  "that was found"));
}

QString ResultPanel::what_x_is(const calibration::CalibrationResult& result) {
  const calibration::Mounting& mounting = result.mounting;
  if (mounting.reference == calibration::BodyFrame::Antenna) return tr("X: LiDAR from antenna");
  if (mounting.reference == calibration::BodyFrame::Machine) return tr("X: LiDAR in machine");
  if (mounting.reference == calibration::BodyFrame::Vehicle)
    return mounting.sensor == calibration::BodyFrame::Antenna ? tr("X: antenna in vehicle")
                                                              : tr("X: sensor in vehicle");
  return tr("X: LiDAR in INS");
}

void ResultPanel::show_standing(ResultStanding standing, const QString& note, const QString& next) {
  standing_ = standing;
  next_ = next;
  note_->setText(note);
  note_->setVisible(!note.isEmpty());
  show_status();
}

void ResultPanel::show_status() {
  set_style(*note_, text_in(warning_color));
  if (!shown_) {
    status_->setText(tr("No result yet"));
    set_style(*status_, [](const QPalette&) { return QString(); });
    words_->setText(next_);
    return;
  }
  // Green is for what holds now.
  QString title = status_title(shown_->result);
  QColor (*color)(const QPalette&) = status_color(shown_->result);
  if (standing_ == ResultStanding::OutOfDate) {
    title = tr("▲ Out of date. It was: %1").arg(title);
    color = warning_color;
  } else if (standing_ == ResultStanding::BeingReplaced) {
    title = tr("… Result before: %1").arg(title);
    color = faded_color;
  } else if (standing_ == ResultStanding::BeingRefined) {
    title = tr("… Being completed: %1").arg(title);
    color = faded_color;
  }
  status_->setText(title);
  set_style(*status_, marked_box(color, QStringLiteral("font-weight: bold; padding: 5px")));
}

void ResultPanel::show_output(std::shared_ptr<const pipeline::PipelineOutput> output,
                              std::shared_ptr<const pipeline::PipelineOutput> before, const QString& moved_by) {
  const bool numbers = output && results::has_mounting(output->result);
  copy_->setEnabled(output && results::has_mounting(output->result));
  export_->setEnabled(output && calibration::is_usable(output->result));
  shown_ = output;
  show_status();
  show_clock_button(output.get());
  correlation_title_->setVisible(numbers);
  correlation_->setVisible(numbers);
  if (numbers) correlation_->show_result(output->result);
  const bool compared = numbers && before && results::has_mounting(before->result);
  moved_by_->setVisible(compared);
  moved_by_->setText(moved_by.isEmpty() ? tr("moved: since the calibration before")
                                        : tr("moved: by “%1”").arg(moved_by));
  value_title_->setText(what_x_is(output ? output->result : calibration::CalibrationResult()));
  if (!output) {
    for (const calibration::Parameter parameter : calibration::kParameters)
      for (const Row& row = rows_[parameter]; QLabel * label : {row.value, row.sigma, row.moved})
        label->setText(label == row.value ? QStringLiteral("–") : QString());
    return;
  }
  show_parameters(output->result, output->nominal_known,
                  before && results::has_mounting(before->result) ? &before->result : nullptr);
  show_words(*output);
  updateGeometry();
}

void ResultPanel::show_parameters(const calibration::CalibrationResult& result, bool nominal_known,
                                  const calibration::CalibrationResult* before) {
  const bool numbers = results::has_mounting(result);
  const calibration::PerParameter<double> values = results::six_on_screen(result.mounting.reference_from_sensor);
  const calibration::PerParameter<double> old =
      before ? results::six_on_screen(before->mounting.reference_from_sensor) : values;
  for (const calibration::Parameter i : calibration::kParameters) {
    const calibration::Estimate estimate = result.estimate(i);
    const std::optional<double>& sigma = estimate.sigma;
    Row& row = rows_[i];
    const bool zero_by_default =
        !sigma && !calibration::is_angle(i) && !nominal_known;  // a number would be taken for one
    row.value->setText(numbers && !zero_by_default ? rounded_text(values[i], 4) + unit_suffix(i) : QStringLiteral("–"));
    row.value->setToolTip(
        numbers && zero_by_default ? tr("Not observed, and no nominal mounting is given: files hold 0") : QString());
    row.value->setEnabled(numbers && sigma.has_value());
    const double spread = sigma ? results::on_screen(i, *sigma) : 0.0;
    const double bootstrap = results::on_screen(i, estimate.bootstrap_sigma.value_or(0.0));
    row.sigma->setText(!numbers ? QString()
                       : sigma  ? spread_text(spread, 4) + unit_suffix(i) +
                                     (estimate.measured ? QStringLiteral(" *") : QString())
                               : tr("not observed"));
    set_style(*row.sigma,
              sigma || !numbers ? Style([](const QPalette&) { return QString(); }) : text_in(warning_color));
    row.sigma->setToolTip(
        sigma || !numbers
            ? (bootstrap > 0.0 ? tr("Bootstrap over blocks of time: %1").arg(spread_text(bootstrap, 4) + unit_suffix(i))
                               : tr("From the information of the solution"))
            : tr("This drive says nothing about it: do not rely on the value shown"));
    double change = values[i] - old[i];
    if (calibration::is_angle(i)) change = radians_to_degrees(wrap_angle_rad(degrees_to_radians(change)));
    const bool known_before = before && before->estimate(i).sigma;
    row.moved->setText(numbers && sigma && known_before ? moved_text(i, change) : QString());
  }
}

void ResultPanel::show_words(const pipeline::PipelineOutput& output) {
  const calibration::CalibrationResult& result = output.result;
  QString html = "<p>" + model_text(result.message).toHtmlEscaped() + "</p>";
  QStringList advice, blind, figures;
  for (const Message& sentence : result.advice) advice << model_text(sentence);
  for (const calibration::ObservabilityDirection& direction : result.directions)
    if (!direction.observed && !direction.words.empty()) blind << model_text(direction.words);
  blind.removeDuplicates();  // two directions of the same parameters have the same words
  const PairCounts pairs = count_pairs(output);
  if (method_registry::is_from_pairs(output.method))
    figures << tr("%n pairs: %1 accepted, %2 rejected", nullptr, static_cast<int>(pairs.all))
                   .arg(pairs.accepted)
                   .arg(pairs.rejected);
  if (results::has_mounting(result)) {
    figures << tr("residuals: %1 cm, %2° (rms)")
                   .arg(100.0 * result.translation_rms_m, 0, 'f', 2)
                   .arg(radians_to_degrees(result.rotation_rms_rad), 0, 'f', 3);
    if (method_registry::is_from_pairs(output.method))
      figures << tr("errors of all accepted pairs, summed: %1").arg(result.frobenius_sum, 0, 'f', 4);
  }
  const bool starred = std::any_of(calibration::kParameters.begin(), calibration::kParameters.end(),
                                   [&](calibration::Parameter parameter) {
                                     const calibration::Estimate estimate = result.estimate(parameter);
                                     return estimate.measured && estimate.sigma;
                                   });
  if (results::has_mounting(result) && starred) figures << tr("* with a value measured by hand");
  if (const Message words = results::disagreement_words(result); !words.empty()) figures << model_text(words);
  if (results::has_mounting(result))
    for (const Message& words : results::clock_words(result)) figures << model_text(words);
  if (results::has_mounting(result) && !output.pairs.empty())
    figures << (results::is_aligned_together(result)
                    ? tr("the clouds of all accepted pairs were aligned together as the last step")
                    : tr("solved from the aligned pairs; calibrate again (F5) to align their clouds together, too"));
  html +=
      html_list(tr("What to do"), advice) + html_list(tr("Not observed"), blind) + html_list(tr("Figures"), figures);
  html += nominal_table(output) + sharpness_table(output);
  if (output.map_check == pipeline::MapCheck::Moved && results::has_mounting(result))
    html +=
        "<p>" + tr("Map sharpness: the result has moved since it was measured; see Quality.").toHtmlEscaped() + "</p>";
  words_->setText(html);
}

}  // namespace remount::widgets
