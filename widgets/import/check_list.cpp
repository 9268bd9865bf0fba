#include "widgets/import/check_list.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "widgets/basics/press_on_purpose.h"
#include "widgets/basics/theme.h"
#include "widgets/text/model_text.h"

namespace remount::widgets {
namespace {

using guesses::Verdict;

QString verdict_sign(Verdict verdict) {
  switch (verdict) {
    case Verdict::Good:
      return QStringLiteral("✓");
    case Verdict::NotTold:
      return QStringLiteral("–");
    case Verdict::Doubtful:
      return severity_sign(drive::Severity::Warning);
    default:
      return severity_sign(drive::Severity::Problem);
  }
}

QColor (*verdict_color(Verdict verdict))(const QPalette&) {
  return verdict == Verdict::Good       ? good_color
         : verdict == Verdict::NotTold  ? faded_color
         : verdict == Verdict::Doubtful ? warning_color
                                        : bad_color;
}

}  // namespace

CheckList::CheckList(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
  grid_->setContentsMargins(4, 2, 4, 2);
  grid_->setHorizontalSpacing(8);
  grid_->setVerticalSpacing(3);
  grid_->setColumnStretch(2, 1);
  setAccessibleName(tr("Checks against the data"));
}

void CheckList::empty() {
  while (QLayoutItem* item = grid_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  for (int row = 0; row < grid_->rowCount(); ++row) grid_->setRowStretch(row, 0);
}

QWidget* CheckList::make_advice(qint64 added_ns) {
  auto* button =
      new QPushButton(tr("Add %1 s").arg(QString::number(1e-9 * static_cast<double>(added_ns), 'g', 12)), this);
  button->setToolTip(tr("Adds it to the times of the table, as under Time above"));
  press_on_purpose(*button);
  connect(button, &QPushButton::clicked, this, [this, added_ns] { emit offset_requested(added_ns); });
  return button;
}

void CheckList::add_line(int row, const guesses::ImportCheck& check) {
  auto* sign = new QLabel(verdict_sign(check.verdict), this);
  set_style(*sign, text_in(verdict_color(check.verdict)));
  auto* title = new QLabel(model_text(guesses::words(check.kind)), this);
  QStringList lines;
  for (const Message& evidence : check.evidence) lines << model_text(evidence);
  auto* what = new QLabel(lines.join('\n'), this);
  what->setWordWrap(true);
  what->setTextFormat(Qt::PlainText);
  what->setTextInteractionFlags(Qt::TextSelectableByMouse);
  if (check.verdict == Verdict::Bad) set_style(*what, text_in(bad_color));
  int column = 0;
  for (QLabel* label : {sign, title, what}) grid_->addWidget(label, row, column++, Qt::AlignTop);
  if (check.added_ns) grid_->addWidget(make_advice(*check.added_ns), row, column, Qt::AlignBottom);
}

void CheckList::show_checks(const guesses::ImportChecks& checks) {
  empty();
  int row = 0;
  for (const guesses::ImportCheck& check : checks.checks) add_line(row++, check);
  grid_->setRowStretch(row, 1);
}

void CheckList::show_text(const QString& text) {
  empty();
  auto* label = new QLabel(text, this);
  label->setWordWrap(true);
  grid_->addWidget(label, 0, 0, 1, 4, Qt::AlignTop);
  grid_->setRowStretch(1, 1);
}

QString CheckList::text() const {
  QStringList texts;
  for (const QLabel* label : findChildren<QLabel*>()) texts << label->text();
  return texts.join('\n');
}

}  // namespace remount::widgets
