#include "widgets/panels/help_window.h"

#include <QDir>
#include <QFile>
#include <QHBoxLayout>
#include <QImage>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QRegularExpression>
#include <QTextBrowser>
#include <QTextDocument>
#include <QUrl>
#include <QVBoxLayout>

namespace remount {
namespace {

constexpr int kNameRole = Qt::UserRole;

void draw_arrow(QPainter& painter, QPointF from, QPointF to, const QString& name, const QColor& color) {
  painter.setPen(QPen(color, 2.5));
  painter.drawLine(from, to);
  const QLineF line(to, from);
  for (const double turn : {25.0, -25.0}) {
    QLineF wing = line;
    wing.setLength(9.0);
    wing.setAngle(line.angle() + turn);
    painter.drawLine(wing);
  }
  painter.drawText(to + QPointF(5.0, -4.0), name);
}

}  // namespace

QImage axes_picture(const QPalette& palette, int width) {
  constexpr double kWidth = 360.0, kHeight = 150.0;
  QImage image(width, static_cast<int>(width * kHeight / kWidth), QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(width / kWidth, width / kWidth);
  const QColor ink = palette.color(QPalette::Text);
  painter.setPen(QPen(ink, 1.2));
  painter.drawRoundedRect(QRectF(20, 55, 120, 56), 12, 12);  // seen from above, front to the right
  painter.drawLine(QPointF(108, 60), QPointF(108, 106));     // windscreen
  painter.drawPolyline(QPolygonF(
      {{200, 110}, {200, 86}, {226, 80}, {244, 62}, {292, 62}, {312, 84}, {330, 88}, {330, 110}, {200, 110}}));
  painter.drawEllipse(QPointF(228, 112), 11, 11);
  painter.drawEllipse(QPointF(304, 112), 11, 11);
  const QColor x(200, 60, 50), y(40, 140, 60), z(50, 100, 200);
  draw_arrow(painter, {70, 83}, {150, 83}, "x", x);
  draw_arrow(painter, {70, 83}, {70, 22}, "y", y);
  draw_arrow(painter, {262, 92}, {345, 92}, "x", x);
  draw_arrow(painter, {262, 92}, {262, 24}, "z", z);
  painter.setPen(ink);
  painter.drawText(QPointF(20, 140), HelpWindow::tr("seen from above"));
  painter.drawText(QPointF(200, 140), HelpWindow::tr("seen from the right"));
  return image;
}

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
  resize(820, 520);
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

}  // namespace remount
