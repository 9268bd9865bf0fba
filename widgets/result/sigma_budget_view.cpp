#include "widgets/result/sigma_budget_view.h"

#include <QHBoxLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QPainter>
#include <QScrollArea>
#include <QToolTip>
#include <QVBoxLayout>

#include "model/formats/files/number_text.h"
#include "widgets/basics/theme.h"
#include "widgets/charts/chart_axis.h"
#include "widgets/text/model_text.h"
#include "widgets/text/parameter_text.h"

namespace remount::widgets {

using calibration::Parameter;

namespace {

/// In mm and thousandths of a degree: parts are small.
QString part_number(Parameter parameter, double sigma) {
  const double small = 1e3 * (calibration::is_angle(parameter) ? radians_to_degrees(sigma) : sigma);
  return QString::fromStdString(formats::spread_text(small, 2));
}

QString part_text(Parameter parameter, double sigma) {
  return part_number(parameter, sigma) +
         (calibration::is_angle(parameter) ? QStringLiteral(" m°") : QStringLiteral(" mm"));
}

/// The numbers before the words, which take the lines that they need.
QString legend_of(const calibration::CalibrationResult& result, const QPalette& palette) {
  QString html = QStringLiteral("<table cellspacing='0' cellpadding='1'><tr><td></td>");
  for (const Parameter parameter : calibration::kParameters)
    html += QStringLiteral("<td align='right'>&nbsp;%1<br>[%2]</td>")
                .arg(parameter_name(parameter),
                     calibration::is_angle(parameter) ? QStringLiteral("m°") : QStringLiteral("mm"));
  html += QStringLiteral("<td></td></tr>");
  for (std::size_t i = 0; i < result.sigma_parts.size(); ++i) {
    const calibration::SigmaPart& part = result.sigma_parts[i];
    html += QStringLiteral("<tr><td><font color='%1'>■</font></td>").arg(SigmaBars::color_of(i, palette).name());
    for (const Parameter parameter : calibration::kParameters)
      html += QStringLiteral("<td align='right'>&nbsp;%1</td>")
                  .arg(result.known[parameter].observed ? part_number(parameter, part.sigma[parameter])
                                                        : QStringLiteral("–"));
    html += QStringLiteral("<td>&nbsp;%1</td></tr>").arg(model_text(part.source).toHtmlEscaped());
  }
  return html + QStringLiteral("</table>");
}

}  // namespace

SigmaBars::SigmaBars(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setAccessibleName(tr("What the sigma of each parameter is made of"));
}

void SigmaBars::show_result(const calibration::CalibrationResult* result) {
  result_ = result ? std::optional(*result) : std::nullopt;
  update();
}

double SigmaBars::share(std::size_t part, Parameter parameter) const {
  if (!result_ || part >= result_->sigma_parts.size() || !result_->known[parameter].observed) return 0.0;
  double whole = 0.0;
  for (const calibration::SigmaPart& one : result_->sigma_parts) whole += one.sigma[parameter] * one.sigma[parameter];
  const double sigma = result_->sigma_parts[part].sigma[parameter];
  return whole > 0.0 ? sigma * sigma / whole : 0.0;
}

/// Told apart by the colour-blind too (Okabe and Ito 2008), and lighter on dark.
QColor SigmaBars::color_of(std::size_t part, const QPalette& palette) {
  static const std::array<QColor, 8> kColors{QColor(0, 114, 178),   QColor(230, 159, 0),  QColor(0, 158, 115),
                                             QColor(204, 121, 167), QColor(213, 94, 0),   QColor(86, 180, 233),
                                             QColor(200, 190, 50),  QColor(128, 128, 128)};
  const QColor color = kColors.at(part % kColors.size());
  const int again = static_cast<int>(part / kColors.size());
  return color.lighter((is_dark(palette) ? 125 : 100) + 40 * again);
}

QRectF SigmaBars::bar_of(int row) const {
  const double left = fontMetrics().horizontalAdvance(tr("pitch")) + 20.0,
               right = fontMetrics().horizontalAdvance(QStringLiteral("±000.00 mm")) + 10.0, high = height() / 6.0;
  return {left, row * high + 2.0, std::max(10.0, width() - left - right), high - 4.0};
}

std::optional<SigmaBars::Place> SigmaBars::place_at(const QPoint& position) const {
  if (!result_) return std::nullopt;
  int row = 0;
  for (const Parameter parameter : calibration::kParameters) {
    const QRectF bar = bar_of(row++);
    if (!bar.contains(position)) continue;
    double left = bar.left();
    for (std::size_t part = 0; part < result_->sigma_parts.size(); ++part) {
      left += share(part, parameter) * bar.width();
      if (position.x() < left) return Place{part, parameter};
    }
  }
  return std::nullopt;
}

QString SigmaBars::words_of(const Place& place) const {
  const calibration::SigmaPart& part = result_->sigma_parts.at(place.part);
  return tr("%1: %2\n%3, %4 % of the variance")
      .arg(parameter_name(place.parameter), model_text(part.source),
           part_text(place.parameter, part.sigma[place.parameter]))
      .arg(100.0 * share(place.part, place.parameter), 0, 'f', 0);
}

void SigmaBars::paintEvent(QPaintEvent*) {
  if (!result_) return;
  QPainter painter(this);
  int row = 0;
  for (const Parameter parameter : calibration::kParameters) {
    const QRectF bar = bar_of(row++);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(4, bar.top(), bar.left() - 8, bar.height()), Qt::AlignLeft | Qt::AlignVCenter,
                     parameter_name(parameter));
    const auto sigma = result_->estimate(parameter).sigma;
    painter.drawText(QRectF(bar.right() + 6, bar.top(), width() - bar.right() - 6, bar.height()),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     sigma ? QStringLiteral("±") + part_text(parameter, *sigma) : QStringLiteral("–"));
    if (!sigma) {
      painter.setPen(faint_text_color(palette()));
      painter.drawText(bar, Qt::AlignCenter, tr("not observed"));
      continue;
    }
    double left = bar.left();
    for (std::size_t part = 0; part < result_->sigma_parts.size(); ++part) {
      const double wide = share(part, parameter) * bar.width();
      painter.fillRect(QRectF(left, bar.top(), wide, bar.height()), color_of(part, palette()));
      left += wide;
    }
  }
}

bool SigmaBars::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  auto* help = static_cast<QHelpEvent*>(event);
  if (const auto place = place_at(help->pos()))
    QToolTip::showText(help->globalPos(), words_of(*place), this);
  else
    QToolTip::hideText();
  return true;
}

SigmaBudgetView::SigmaBudgetView(QWidget* parent)
    : QWidget(parent), bars_(new SigmaBars(this)), intro_(new QLabel(this)), legend_(new QLabel(this)) {
  intro_->setWordWrap(true);
  legend_->setTextFormat(Qt::RichText);
  legend_->setWordWrap(true);
  legend_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  legend_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  legend_->setAccessibleName(tr("Parts of the sigmas"));
  auto* area = new QScrollArea(this);
  area->setWidget(legend_);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  auto* row = new QHBoxLayout;
  row->addWidget(bars_, 2);
  row->addWidget(area, 5);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 4, 6, 4);
  column->addWidget(intro_);
  column->addLayout(row, 1);
  show_result(nullptr);
}

void SigmaBudgetView::show_result(const calibration::CalibrationResult* result) {
  const bool told = result && calibration::is_usable(*result) && calibration::sigma_parts_add_up(*result);
  bars_->show_result(told ? result : nullptr);
  bars_->setVisible(told);
  legend_->setText(told ? legend_of(*result, palette()) : QString());
  intro_->setText(
      !result ? tr("After a calibration: where the sigma of each parameter comes from.")
      : told  ? tr("Each bar is the variance (sigma squared) of a parameter, parted by where it comes from; the "
                    "table has the root of each part. The widest part is what to make better first.")
              : tr("This result does not tell what its sigmas are made of: it is of another method, of several "
                    "LiDARs together, of a former version, or has no usable X."));
}

}  // namespace remount::widgets
