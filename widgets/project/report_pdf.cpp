#include "widgets/project/report_pdf.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QFontMetrics>
#include <QPainter>
#include <QPdfWriter>
#include <QTextBlock>
#include <QTextDocument>
#include <QUrl>

#include "algorithms/core/error.h"
#include "messages/window.h"
#include "widgets/basics/rows.h"
#include "widgets/charts/paint_drawing.h"

namespace remount::widgets {
namespace {

constexpr int kDpi = 288;
constexpr double kLayoutDpi = 96.0;  // of the text engine's pixels
constexpr double kChartScale = 2.5;  // sharp when printed

QString image_tag(QTextDocument& document, const QImage& image, int width) {
  const QString name = QStringLiteral("image:%1").arg(image.cacheKey());
  document.addResource(QTextDocument::ImageResource, QUrl(name), image);
  const int height = image.width() > 0 ? width * image.height() / image.width() : 0;
  return QStringLiteral("<img src=\"%1\" width=\"%2\" height=\"%3\">").arg(name).arg(width).arg(height);
}

/// What the text engine cannot do by style sheet is said in its own terms.
void fit_to_paper(QTextDocument& document, const QSizeF& page) {
  QFont font = document.defaultFont();
  font.setPixelSize(13);
  document.setDefaultFont(font);
  document.setDefaultStyleSheet(
      "h1{font-size:22px} h2{font-size:16px} table{border-collapse:collapse} td,th{font-size:9px} "
      "td,th{white-space:nowrap} td.text{white-space:normal} "
      "pre{font-size:9px} .weak{color:#666666} .warn{color:#9a4a00}");
  document.setDocumentMargin(0);
  document.setPageSize(page);
}

void check_letters(const QString& text, const QFont& font) {
  const QFontMetrics metrics(font);  // of the fonts that step in for this one, too
  for (const char32_t letter : text.toUcs4())
    if (letter > 0x7f && QChar::isLetter(letter) && !metrics.inFontUcs4(letter))
      throw Error(ErrorCode::Unsupported, {},
                  say::window_pdf_without_letter(QString::fromUcs4(&letter, 1).toStdString()));
}

constexpr double kScale = kDpi / kLayoutDpi;
constexpr double kFooter = 24.0;

void set_up(QPdfWriter& writer, const QString& title, const std::string& version) {
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setPageMargins(QMarginsF(14, 14, 14, 16), QPageLayout::Millimeter);
  writer.setResolution(kDpi);
  writer.setTitle(title);
  writer.setCreator(QStringLiteral("Remount ") + QString::fromStdString(version));
}

/// The page as HTML, with charts and pictures as resources of the document.
void fill(QTextDocument& document, const report::Report& report, report::ReportStyle style, int width) {
  style.chart = [&](const report::Drawing& drawing) {
    return image_tag(document, image_of(drawing, kChartScale), width).toStdString();
  };
  style.picture = [&](const report::ReportPicture& picture) {
    const QImage image =
        QImage::fromData(reinterpret_cast<const uchar*>(picture.png.data()), qt_count(picture.png.size()));
    return image_tag(document, image, width).toStdString();
  };
  QString html = QString::fromStdString(report::report_html(report, style));
  const qsizetype css = html.indexOf("<style>"), end = html.indexOf("</style>");
  html.remove(css, end + 8 - css);
  document.setHtml(html);
}

/// A heading at the end of a page, with a line that leads to what follows, goes to the next one, where that begins.
void keep_headings_with_text(QTextDocument& document) {
  const auto page_of = [&](const QTextBlock& block) {  // of its first line, which may be a chart
    double end = document.documentLayout()->blockBoundingRect(block).top();
    if (block.layout()->lineCount() > 0) end += block.layout()->lineAt(0).rect().bottom();
    return static_cast<int>((end - 1.0) / document.pageSize().height());
  };
  QTextBlockFormat on_next_page;
  on_next_page.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
  for (QTextBlock block = document.begin(); block.next().isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() == 0) continue;
    const QTextBlock first = block.next(), second = first.next();
    const bool leads = first.text().size() > 1 && first.layout()->lineCount() == 1 && second.isValid() &&
                       second.blockFormat().headingLevel() == 0;
    if (page_of(first) == page_of(block) && (!leads || page_of(second) == page_of(block))) continue;
    QTextCursor(block).mergeBlockFormat(on_next_page);
    document.setPageSize(document.pageSize());  // all is laid out anew: what is only moved on is not drawn
  }
}

void paint_text(QPainter& painter, const QTextDocument& document, int page) {
  const QRectF part(QPointF(0, page * document.pageSize().height()), document.pageSize());
  painter.save();
  painter.scale(kScale, kScale);
  painter.translate(0, -part.top());
  painter.setClipRect(part);
  QAbstractTextDocumentLayout::PaintContext context;
  context.clip = part;
  context.palette.setColor(QPalette::Text, Qt::black);
  document.documentLayout()->draw(&painter, context);
  painter.restore();
}

void paint_footer(QPainter& painter, QFont font, const QSizeF& paper, const QString& text) {
  painter.save();
  painter.scale(kScale, kScale);
  font.setPixelSize(10);
  painter.setFont(font);
  painter.drawText(QRectF(0, paper.height() - kFooter, paper.width(), kFooter), Qt::AlignRight | Qt::AlignBottom, text);
  painter.restore();
}

}  // namespace

QByteArray report_pdf(const report::Report& report, report::ReportStyle style, const QString& title) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  if (!buffer.open(QIODevice::WriteOnly)) return {};
  QPdfWriter writer(&buffer);
  set_up(writer, title, report.file.version);
  const QSizeF paper = QSizeF(writer.width(), writer.height()) / kScale;
  QTextDocument document;
  fit_to_paper(document, {paper.width(), paper.height() - kFooter});
  fill(document, report, std::move(style), static_cast<int>(paper.width()));
  keep_headings_with_text(document);
  check_letters(document.toPlainText(), document.defaultFont());
  QPainter painter(&writer);
  if (!painter.isActive()) return {};
  const int pages = document.pageCount();
  for (int page = 0; page < pages; ++page) {
    if (page > 0) writer.newPage();
    paint_text(painter, document, page);
    paint_footer(painter, document.defaultFont(), paper, QStringLiteral("%1 / %2").arg(page + 1).arg(pages));
  }
  painter.end();
  return bytes;
}

}  // namespace remount::widgets
