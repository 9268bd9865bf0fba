#include "widgets/shell/help_window.h"

#include <QDir>
#include <QEvent>
#include <QFile>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QTextBrowser>
#include <QTextDocument>
#include <QUrl>
#include <QVBoxLayout>

#include "widgets/basics/axes_picture.h"
#include "widgets/basics/screen_room.h"
#include "widgets/text/readable.h"

namespace remount::widgets {
namespace {

constexpr int kNameRole = Qt::UserRole;

}  // namespace

HelpWindow::HelpWindow(const QString& folder, QWidget* parent)
    : QDialog(parent), search_(new QLineEdit(this)), list_(new QListWidget(this)), text_(new QTextBrowser(this)) {
  setWindowTitle(tr("Help"));
  static const QRegularExpression kTitle(QStringLiteral("<title>(.*)</title>"));
  for (const QString& file : QDir(folder).entryList({"*.html"}, QDir::Files, QDir::Name)) {
    QFile page(QDir(folder).filePath(file));
    if (!page.open(QIODevice::ReadOnly)) continue;
    const QString html = QString::fromUtf8(page.readAll());
    pages_.push_back({file.section('-', 1).section('.', 0, 0), kTitle.match(html).captured(1), html});
  }
  search_->setPlaceholderText(tr("Search"));
  keep_placeholder_readable(*search_);
  search_->setAccessibleName(tr("Search in the help"));
  search_->setClearButtonEnabled(true);
  list_->setAccessibleName(tr("Contents of the help"));
  list_->setMaximumWidth(250);
  list_->setWordWrap(true);
  text_->setAccessibleName(tr("Page of the help"));
  auto* left = new QVBoxLayout;
  left->addWidget(search_);
  left->addWidget(list_, 1);
  auto* row = new QHBoxLayout(this);
  row->addLayout(left);
  row->addWidget(text_, 1);
  connect(search_, &QLineEdit::textChanged, this, &HelpWindow::search);
  connect(list_, &QListWidget::currentRowChanged, this, &HelpWindow::show_current);
  resize(within_screen(*this, {820, 520}));
  search({});
}

void HelpWindow::search(const QString& text) {
  const QString shown = current_page();
  list_->clear();
  for (const Page& page : pages_) {
    QTextDocument plain;
    plain.setHtml(page.html);
    if (!text.isEmpty() && !plain.toPlainText().contains(text, Qt::CaseInsensitive)) continue;
    auto* item = new QListWidgetItem(page.title, list_);
    item->setData(kNameRole, page.name);
    if (page.name == shown) list_->setCurrentItem(item);
  }
  if (list_->currentRow() < 0) list_->setCurrentRow(0);
}

void HelpWindow::show_page(const QString& name) {
  search_->clear();
  list_->setCurrentRow(0);
  for (int row = 0; row < list_->count(); ++row)
    if (list_->item(row)->data(kNameRole).toString() == name) list_->setCurrentRow(row);
}

QString HelpWindow::current_page() const {
  return list_->currentItem() ? list_->currentItem()->data(kNameRole).toString() : QString();
}

QStringList HelpWindow::listed_pages() const {
  QStringList names;
  for (int row = 0; row < list_->count(); ++row) names << list_->item(row)->data(kNameRole).toString();
  return names;
}

void HelpWindow::show_current() {
  for (const Page& page : pages_) {
    if (page.name != current_page()) continue;
    text_->document()->addResource(QTextDocument::ImageResource, QUrl("image:axes"), axes_picture(palette(), 420));
    text_->setHtml(page.html);
  }
}

void HelpWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) show_current();  // its picture
  QDialog::changeEvent(event);
}

}  // namespace remount::widgets
