#include "widgets/residuals/residuals_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include "widgets/basics/theme.h"

namespace remount::widgets {
namespace {

constexpr int kChoices_px = 190;
constexpr int kNarrow_px = 520;  ///< below, choices beside the plot would take half of it

QString number_with_unit(double value, const QString& unit) {
  return QStringLiteral("%1 %2").arg(value, 0, 'g', 3).arg(unit);
}

}  // namespace

ResidualsPanel::ResidualsPanel(QWidget* parent)
    : QWidget(parent),
      plot_(new ResidualPlot(this)),
      measure_(new QComboBox(this)),
      circumstance_(new QComboBox(this)),
      reject_(new QPushButton(tr("Reject marked"), this)),
      summary_(new QLabel(this)),
      side_(new QWidget(this)),
      row_(new QBoxLayout(QBoxLayout::LeftToRight, this)),
      choices_(new QBoxLayout(QBoxLayout::TopToBottom)),
      states_(new QBoxLayout(QBoxLayout::TopToBottom)) {
  auto* column = new QVBoxLayout(side_);
  column->setContentsMargins(0, 0, 0, 0);
  for (QBoxLayout* part : {static_cast<QBoxLayout*>(column), choices_, states_}) part->setSpacing(3);
  column->addLayout(choices_);
  column->addLayout(states_);
  add_choices();
  add_states();
  reject_->setToolTip(
      tr("Draw a line around points with the left button: they are marked. With Shift they are marked "
         "beside those before."));
  connect(reject_, &QPushButton::clicked, this, &ResidualsPanel::reject_marked);
  states_->addWidget(reject_);
  summary_->setWordWrap(true);
  summary_->setAlignment(Qt::AlignTop);
  summary_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  summary_->setAccessibleName(tr("What the plot holds"));
  summary_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored);  // a low panel cuts it, not the plot
  column->addWidget(summary_, 1);
  connect(plot_, &ResidualPlot::contents_changed, this, &ResidualsPanel::show_summary);
  row_->setContentsMargins(6, 4, 6, 4);
  row_->addWidget(side_);
  row_->addWidget(plot_, 1);
  lay_out(false);
  show_summary();
}

void ResidualsPanel::lay_out(bool narrow) {
  row_->setDirection(narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
  for (QBoxLayout* part : {choices_, states_})
    part->setDirection(narrow ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  side_->setMinimumWidth(narrow ? 0 : kChoices_px);
  side_->setMaximumWidth(narrow ? QWIDGETSIZE_MAX : kChoices_px);
  summary_->setVisible(!narrow);  // it is the tool tip of the panel as well
}

void ResidualsPanel::resizeEvent(QResizeEvent* event) {
  lay_out(width() < kNarrow_px);
  QWidget::resizeEvent(event);
}

void ResidualsPanel::add_choices() {
  for (const ResidualMeasure measure : kResidualMeasures)
    measure_->addItem(QStringLiteral("%1 [%2]").arg(name_of(measure), unit_of(measure)));
  for (const PairCircumstance circumstance : kPairCircumstances) circumstance_->addItem(name_of(circumstance));
  measure_->setAccessibleName(tr("What the height of a point shows"));
  circumstance_->setAccessibleName(tr("Over what it is drawn"));
  measure_->setToolTip(tr("x, y, z, roll, pitch and yaw are in the axes of the LiDAR at the later scan."));
  //: between two lists: residual x over speed
  auto* over = new QLabel(tr("over"), this);
  auto* row = new QHBoxLayout;
  row->addWidget(over);
  row->addWidget(circumstance_, 1);
  for (QComboBox* combo : {measure_, circumstance_}) {
    combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(combo, &QComboBox::currentIndexChanged, this, [this] {
      plot_->set_axes(kResidualMeasures.at(index_at(measure_->currentIndex())),
                      kPairCircumstances.at(index_at(circumstance_->currentIndex())));
    });
  }
  choices_->addWidget(measure_, 1);
  choices_->addLayout(row, 1);
}

void ResidualsPanel::add_states() {
  const auto add = [&](motion::PairState state, const QString& text) {
    auto* box = new QCheckBox(text, this);
    box->setChecked(true);
    set_style(*box, [state](const QPalette& palette) {
      return QStringLiteral("QCheckBox { color: %1 }").arg(state_color(state, palette).name());
    });
    connect(box, &QCheckBox::toggled, plot_,
            [plot = plot_, state](bool shown) { plot->show_state_of_pairs(state, shown); });
    states_->addWidget(box);
  };
  add(motion::PairState::Accepted, tr("● accepted"));
  add(motion::PairState::Rejected, tr("✕ rejected"));
  add(motion::PairState::Proposed, tr("○ proposed"));
}

void ResidualsPanel::choose(ResidualMeasure measure, PairCircumstance circumstance) {
  measure_->setCurrentIndex(static_cast<int>(measure));
  circumstance_->setCurrentIndex(static_cast<int>(circumstance));
}

void ResidualsPanel::show_summary() {
  const std::vector<motion::PairIndex> rejectable = plot_->marked_and_kept();
  reject_->setEnabled(!rejectable.empty());
  reject_->setText(rejectable.empty() ? tr("Reject marked")
                                      : tr("Reject %n marked", nullptr, static_cast<int>(rejectable.size())));
  const ResidualSummary summary = plot_->summary();
  const QString unit = unit_of(plot_->measure());
  QStringList lines;
  if (summary.outside > 0) lines << tr("%n outside: double click", nullptr, summary.outside);
  if (summary.accepted > 0)
    lines << tr("accepted: mean %1, std. dev. %2")
                 .arg(number_with_unit(summary.mean, unit), number_with_unit(summary.deviation, unit));
  if (summary.unknown > 0) lines << tr("%n without a value", nullptr, summary.unknown);
  summary_->setText(lines.join('\n'));
  summary_->setToolTip(summary_->text());
  setToolTip(summary_->text());
}

void ResidualsPanel::reject_marked() {
  const std::vector<motion::PairIndex> pairs = plot_->marked_and_kept();
  if (pairs.empty()) return;
  const QString measure = name_of(plot_->measure()).toLower(), circumstance = name_of(plot_->circumstance()).toLower();
  plot_->mark({});  // they have done their work: what is undone later is not rejected by them again
  //: why pairs were rejected: "marked in the plot: residual x over speed"
  emit reject_requested(pairs, tr("marked in the plot: %1 over %2").arg(measure, circumstance));
}

}  // namespace remount::widgets
