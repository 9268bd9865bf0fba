#include "widgets/methods/method_view.h"

#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include "algorithms/messages/render.h"
#include "model/report/plot_chart.h"
#include "widgets/basics/rows.h"
#include "widgets/charts/plot_view.h"
#include "widgets/result/verdict_table.h"
#include "widgets/text/model_text.h"

namespace remount::widgets {

MethodView::MethodView(QWidget* parent)
    : QWidget(parent),
      title_(new QLabel(this)),
      quantities_(new FigureTable(tr("What the method determined beside the mounting"), this)),
      plots_(new PlotView) {
  title_->setWordWrap(true);
  title_->setAccessibleName(tr("Method of the result"));
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(plots_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setAccessibleName(tr("Plots of the method"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  column->addWidget(title_);
  column->addWidget(quantities_);
  column->addWidget(scroll, 1);
  show_message({});
}

void MethodView::show_message(const QString& text) {
  title_->setText(text);
  quantities_->hide();
  plots_->show_plots({});
}

void MethodView::show_method(const QString& title, const std::vector<calibration::NamedQuantity>& quantities,
                             const std::vector<calibration::Plot>& plots) {
  title_->setText(title);
  const Language language = window_language();
  std::vector<std::vector<TableCell>> rows;
  for (const calibration::NamedQuantity& quantity : quantities)
    rows.push_back({{model_text(quantity.name), {}, Verdict::Neutral},
                    {QString::fromStdString(report::quantity_text(quantity, language)), tr("± 1 sigma"),
                     quantity.observed ? Verdict::Neutral : Verdict::Doubtful}});
  quantities_->show_rows({tr("Also determined"), tr("Value")}, rows);
  quantities_->setVisible(!rows.empty());
  quantities_->setMaximumHeight(30 * (qt_count(rows.size()) + 1) + 8);
  plots_->show_plots(plots);
}

}  // namespace remount::widgets
