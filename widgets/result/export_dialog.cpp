#include "widgets/result/export_dialog.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "algorithms/core/index.h"
#include "widgets/basics/file_dialogs.h"
#include "widgets/basics/screen_room.h"
#include "widgets/basics/theme.h"

namespace remount::widgets {

ExportDialog::ExportDialog(std::vector<ExportFormat> formats, TextOf text_of, QWidget* parent)
    : QDialog(parent),
      formats_(std::move(formats)),
      text_of_(std::move(text_of)),
      list_(new QListWidget(this)),
      preview_(new QPlainTextEdit(this)),
      direction_(new QLabel(this)),
      warning_(new QLabel(this)),
      outcome_(new QLabel(this)),
      forms_(new QVBoxLayout) {
  setWindowTitle(tr("Export the result"));
  list_->setAccessibleName(tr("Format"));
  list_->setTextElideMode(Qt::ElideRight);
  for (const ExportFormat& format : formats_) {
    list_->addItem(format.title);
    list_->item(list_->count() - 1)->setToolTip(format.title + '\n' + format.direction);
  }
  // One line for each, whole: names are told apart by their ends.
  list_->setFixedWidth(list_->sizeHintForColumn(0) + 2 * list_->frameWidth() + 24);
  preview_->setReadOnly(true);
  preview_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  preview_->setAccessibleName(tr("Preview"));
  direction_->setWordWrap(true);
  direction_->setAccessibleName(tr("Direction of the transform"));
  warning_->setWordWrap(true);
  warning_->setTextFormat(Qt::PlainText);
  warning_->hide();
  outcome_->setWordWrap(true);
  outcome_->setTextFormat(Qt::PlainText);
  outcome_->setAccessibleName(tr("What became of it"));
  outcome_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // a long path does not widen the dialog
  outcome_->hide();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  copy_ = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
  save_ = buttons->addButton(tr("Save…"), QDialogButtonBox::ActionRole);
  save_->setDefault(true);
  connect(copy_, &QPushButton::clicked, this, [this] {
    QGuiApplication::clipboard()->setText(current_text());
    show_outcome(tr("Copied."), false);
    emit copied(current_id());
  });
  connect(save_, &QPushButton::clicked, this, &ExportDialog::ask_where);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(list_, &QListWidget::currentRowChanged, this, &ExportDialog::show_current);
  auto* grid = new QGridLayout(this);
  grid->addWidget(warning_, 0, 0, 1, 2);
  grid->addLayout(forms_, 1, 0, 1, 2);
  grid->addWidget(list_, 2, 0, 2, 1);
  grid->addWidget(direction_, 2, 1);
  grid->addWidget(preview_, 3, 1);
  grid->addWidget(outcome_, 4, 0, 1, 2);
  grid->addWidget(buttons, 5, 0, 1, 2);
  grid->setColumnStretch(1, 1);
  grid->setRowStretch(3, 1);
  resize(within_screen(*this, {1080, 620}));
  list_->setCurrentRow(0);
}

void ExportDialog::add_form(QWidget* form) { forms_->addWidget(form); }

void ExportDialog::show_warning(const QString& warning) {
  set_style(*warning_, marked_box(warning_color, QStringLiteral("padding: 6px")));
  warning_->setText(QStringLiteral("▲  ") + warning);
  warning_->setVisible(!warning.isEmpty());
}

void ExportDialog::show_outcome(const QString& text, bool failed) {
  set_style(*outcome_, marked_box(failed ? bad_color : good_color, QStringLiteral("padding: 6px")));
  outcome_->setText((failed ? QStringLiteral("✕  ") : QStringLiteral("✓  ")) + text);
  outcome_->show();
}

QString ExportDialog::current_id() const {
  const int row = list_->currentRow();
  return row < 0 ? QString() : formats_[index_at(row)].id;
}

QString ExportDialog::current_text() const { return text_; }

void ExportDialog::choose(const QString& id) {
  for (std::size_t i = 0; i < formats_.size(); ++i)
    if (formats_[i].id == id) list_->setCurrentRow(static_cast<int>(i));
}

void ExportDialog::show_current() {
  if (list_->currentRow() < 0) return;
  const ExportFormat& format = formats_[index_at(list_->currentRow())];
  const ExportText current = text_of_(format.id);
  const QString& direction = current.direction.isEmpty() ? format.direction : current.direction;
  direction_->setText("<b>" + tr("Direction:").toHtmlEscaped() + "</b> " + direction.toHtmlEscaped());
  if (current.text != text_) outcome_->hide();  // it was about another text
  text_ = current.text;
  preview_->setLineWrapMode(current.problem.isEmpty() ? QPlainTextEdit::NoWrap : QPlainTextEdit::WidgetWidth);
  const QString shown = current.problem.isEmpty() ? current.text : current.problem;
  if (preview_->toPlainText() != shown) preview_->setPlainText(shown);  // or it would jump to its beginning
  // A message must not be saved for a calibration.
  copy_->setEnabled(final_ && current.problem.isEmpty());
  save_->setEnabled(final_ && current.problem.isEmpty());
}

void ExportDialog::set_final(bool is_final) { final_ = is_final; }

void ExportDialog::ask_where() {
  if (list_->currentRow() < 0) return;
  const ExportFormat& format = formats_[index_at(list_->currentRow())];
  const QString title = tr("Save %1").arg(format.title);
  const QString path = format.folder ? ask_for_folder(this, title, FileKind::Exports)
                                     : ask_where_to_save(this, title, FileKind::Exports, format.file_name);
  if (!path.isEmpty()) emit save_requested(format.id, path, current_text());
}

}  // namespace remount::widgets
