#include "widgets/quality/obstacle_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <algorithm>
#include <cmath>

#include "algorithms/core/index.h"
#include "widgets/basics/press_on_purpose.h"
#include "widgets/basics/rows.h"
#include "widgets/basics/screen_room.h"
#include "widgets/basics/theme.h"
#include "widgets/text/model_text.h"
#include "widgets/text/parameter_text.h"
#include "widgets/text/readable.h"
#include "widgets/text/sentences.h"

namespace remount::widgets {
namespace {

constexpr int kLeastName_px = 90;

/// Adds one editor for each option; `changed` is called after the member has its new value.
struct FormBuilder {
  QFormLayout& layout;
  std::function<void()> changed;

  void add(const OptionInfo& info, QWidget* editor) {
    const QString label = model_text(info.label());
    editor->setToolTip(model_text(info.help()));
    editor->setAccessibleName(label);
    layout.addRow(label, editor);
  }
  void operator()(const OptionInfo& info, double& member) {
    auto* spin = new QDoubleSpinBox;
    spin->setRange(info.minimum, info.maximum);
    spin->setSuffix(' ' + QString::fromUtf8(info.unit));
    spin->setSingleStep(0.1);
    spin->setKeyboardTracking(false);
    spin->setValue(member);
    QObject::connect(spin, &QDoubleSpinBox::valueChanged, spin, [&member, done = changed](double value) {
      member = value;
      done();
    });
    add(info, spin);
  }
  void operator()(const OptionInfo& info, bool& member) {
    auto* box = new QCheckBox;
    box->setChecked(member);
    keep_box_visible(*box);
    QObject::connect(box, &QCheckBox::toggled, box, [&member, done = changed](bool on) {
      member = on;
      done();
    });
    add(info, box);
  }
};

QString distance(double value_m) {
  return std::isfinite(value_m) ? ObstacleDialog::tr("%1 m").arg(value_m, 0, 'f', 2)
                                : ObstacleDialog::tr("no obstacle");
}

}  // namespace

ObstacleDialog::ObstacleDialog(const QString& scan, bool nominal_known, const QString& caution, QWidget* parent)
    : QDialog(parent),
      before_(nominal_known ? tr("Nominal") : tr("Start")),
      verdict_(new QLabel(this)),
      table_(new QTableWidget(this)) {
  setWindowTitle(tr("Obstacles in %1").arg(scan));
  verdict_->setWordWrap(true);
  verdict_->setAccessibleName(tr("Decision"));
  table_->setColumnCount(4);
  table_->setHorizontalHeaderLabels({tr("Object"), before_, tr("With result"), tr("Difference")});
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setTextElideMode(Qt::ElideMiddle);
  table_->setWordWrap(false);
  table_->viewport()->installEventFilter(this);
  table_->setAccessibleName(tr("Distance of each object from the outline of the vehicle"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  press_on_purpose(*buttons->button(QDialogButtonBox::Close));  // Enter ends the edit of a measure, not the dialog
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* grid = new QGridLayout(this);
  auto* doubts = new QLabel(caution, this);
  doubts->setWordWrap(true);
  doubts->setVisible(!caution.isEmpty());
  auto* title = new QLabel(windowTitle(), this);  // the frame of a window may have no room for it
  title->setWordWrap(true);
  grid->addWidget(title, 0, 0, 1, 2);
  grid->addWidget(verdict_, 1, 0, 1, 2);
  grid->addWidget(doubts, 2, 0, 1, 2);
  grid->addWidget(make_form(), 3, 0, Qt::AlignTop);
  grid->addWidget(table_, 3, 1);
  grid->addWidget(buttons, 4, 0, 1, 2);
  grid->setColumnStretch(1, 1);
  grid->setRowStretch(3, 1);
  grid->setRowMinimumHeight(1, fontMetrics().height() + 14);  // the decision with the box around it
  resize(within_screen(*this, {760, 440}));
  verdict_->setText(tr("Measuring the distances…"));
}

QWidget* ObstacleDialog::make_form() {
  auto* form = new QWidget(this);
  auto* layout = new QFormLayout(form);
  layout->setContentsMargins(0, 0, 0, 0);
  FormBuilder builder{*layout, [this] { emit options_edited(); }};
  quality::ObstacleOptions::visit(options_, builder);
  return form;
}

void ObstacleDialog::show_problem(const QString& text) {
  table_->setRowCount(0);
  set_style(*verdict_, text_in(bad_color));
  verdict_->setText(text);
}

void ObstacleDialog::show_verdict(const quality::ObstacleComparison& found) {
  const auto words = [](const quality::ObstacleCheck& result) {
    const QString nearest =
        std::isfinite(result.nearest_m) ? tr("nearest at %1").arg(distance(result.nearest_m)) : tr("nothing near");
    return result.decision == quality::ObstacleDecision::Stop ? tr("stop (%1)").arg(nearest)
                                                              : tr("clear (%1)").arg(nearest);
  };
  const auto color = found.decision_differs()                                       ? bad_color
                     : found.calibrated.decision == quality::ObstacleDecision::Stop ? warning_color
                                                                                    : good_color;
  set_style(*verdict_, marked_box(color, QStringLiteral("padding: 6px")));
  QStringList verdict{tr("%1: %2. With result: %3.").arg(before_, words(found.nominal), words(found.calibrated))};
  if (found.decision_differs()) verdict << tr("The mounting changes the decision.");
  verdict_->setText(one_text(verdict));
}

void ObstacleDialog::show_comparison(quality::ObstacleComparison found, const quality::ObstacleOptions& options) {
  show_verdict(found);
  // The nearest decide: they come first. What is no obstacle has no distance and comes last.
  const auto rank = [](double distance_m) { return std::isfinite(distance_m) ? distance_m : 1e9; };
  std::stable_sort(found.rows.begin(), found.rows.end(), [&](const auto& a, const auto& b) {
    return rank(a.calibrated_distance_m) < rank(b.calibrated_distance_m);
  });
  table_->setRowCount(qt_count(found.rows.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const quality::ObstacleDifference& entry = found.rows[index_at(row)];
    const double change_m = entry.calibrated_distance_m - entry.nominal_distance_m;
    const std::array<QString, 4> cells{
        QStringLiteral("%1 %2").arg(entry.object).arg(model_text(cloud::shape_word(entry.shape))),
        distance(entry.nominal_distance_m), distance(entry.calibrated_distance_m),
        std::isfinite(change_m) ? tr("%1 m").arg(rounded_text(change_m, 3)) : QString()};
    for (int column = 0; column < 4; ++column) {
      auto* item = new QTableWidgetItem(cells[index_at(column)]);
      const double shown_m = column == 1 ? entry.nominal_distance_m : entry.calibrated_distance_m;
      if (column == 0) item->setToolTip(item->text());
      if ((column == 1 || column == 2) && shown_m < options.stop_distance_m) {
        item->setData(Qt::UserRole, true);
        item->setToolTip(tr("Closer than the stop distance"));
      }
      if (column > 0) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(row, column, item);
    }
  }
  recolor();
  fit_columns();
}

void ObstacleDialog::recolor() {
  for (int row = 0; row < table_->rowCount(); ++row)
    for (int column = 0; column < table_->columnCount(); ++column)
      if (QTableWidgetItem* item = table_->item(row, column); item->data(Qt::UserRole).toBool())
        item->setForeground(bad_color(palette()));
}

// Names as wide as they are, but for the room that the distances need; what does not fit is left out in its middle.
void ObstacleDialog::fit_columns() {
  const int last = table_->columnCount() - 1;  // takes the room that is left
  const QAbstractItemView& view = *table_;
  int others = std::max(view.sizeHintForColumn(last), table_->horizontalHeader()->sectionSizeHint(last));
  for (int column = 0; column < last; ++column) {
    table_->resizeColumnToContents(column);
    if (column > 0) others += table_->columnWidth(column);
  }
  const int room = std::max(table_->viewport()->width() - others, kLeastName_px);
  table_->setColumnWidth(0, std::min(table_->columnWidth(0), room));
}

bool ObstacleDialog::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_->viewport() && event->type() == QEvent::Resize) fit_columns();
  return QDialog::eventFilter(watched, event);
}

void ObstacleDialog::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) recolor();
  QDialog::changeEvent(event);
}

}  // namespace remount::widgets
