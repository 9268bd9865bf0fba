#include "widgets/charts/plot_view.h"

#include <QPaintEvent>
#include <QPainter>
#include <algorithm>

#include "algorithms/messages/render.h"
#include "model/report/plot_chart.h"
#include "widgets/charts/paint_drawing.h"
#include "widgets/text/model_text.h"

namespace remount::widgets {
namespace {

constexpr double kWidest = 1.5;  // larger, a line of a thousand points shows nothing more

}  // namespace

PlotView::PlotView(QWidget* parent) : QWidget(parent) {
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  setAccessibleName(tr("Plots of the method"));
}

void PlotView::show_plots(const std::vector<calibration::Plot>& plots) {
  drawings_.clear();
  QStringList titles;
  const Language language = window_language();
  for (const calibration::Plot& plot : plots) {
    drawings_.push_back(report::plot_chart(plot, language));
    titles << QString::fromStdString(drawings_.back().description);
  }
  setAccessibleDescription(titles.join('\n'));
  updateGeometry();
  update();
}

double PlotView::scale_of(int width) const {
  double widest = 1.0;
  for (const report::Drawing& drawing : drawings_) widest = std::max(widest, drawing.width);
  return std::min(kWidest, width / widest);
}

int PlotView::heightForWidth(int width) const {
  double height = 0.0;
  for (const report::Drawing& drawing : drawings_) height += drawing.height * scale_of(width) + kGap;
  return static_cast<int>(height);
}

QSize PlotView::sizeHint() const { return {480, heightForWidth(480)}; }

void PlotView::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  const double scale = scale_of(width());
  double top = 0.0;
  for (const report::Drawing& drawing : drawings_) {
    const QRectF place(0.0, top, drawing.width * scale, drawing.height * scale);
    top += place.height() + kGap;
    if (!place.intersects(event->rect())) continue;
    painter.save();
    painter.fillRect(place, Qt::white);
    painter.translate(place.topLeft());
    painter.scale(scale, scale);
    paint_drawing(drawing, painter);
    painter.restore();
  }
}

}  // namespace remount::widgets
