#include "widgets/result/comparison_view.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "model/results/display_units.h"
#include "widgets/result/verdict_table.h"
#include "widgets/text/model_text.h"
#include "widgets/text/parameter_text.h"

namespace remount::widgets {
namespace {

using Rows = std::vector<std::vector<TableCell>>;

TableCell value_cell(const calibration::CalibrationResult& result, calibration::Parameter i) {
  const auto sigma = result.estimate(i).sigma;
  if (!calibration::is_usable(result) || !sigma) return unknown_cell(ComparisonView::tr("not observed"));
  const int decimals = results::justified_decimals(results::on_screen(i, *sigma));
  return {rounded_text(results::six_on_screen(result.mounting.reference_from_sensor)[i], decimals) + QLatin1Char(' ') +
              spread_text(results::on_screen(i, *sigma), decimals),
          ComparisonView::tr("± 1 sigma"), Verdict::Neutral};
}

Rows value_rows(const std::vector<report::NamedResult>& results) {
  Rows rows;
  for (const report::NamedResult& result : results) {
    std::vector<TableCell> row{{QString::fromStdString(result.name),
                                ComparisonView::tr("Method: %1").arg(QString::fromStdString(result.file.method)),
                                Verdict::Neutral}};
    for (const calibration::Parameter i : calibration::kParameters) row.push_back(value_cell(result.file.result, i));
    rows.push_back(std::move(row));
  }
  return rows;
}

Rows pair_rows(const std::vector<report::ComparedResults>& compared) {
  Rows rows;
  for (const report::ComparedResults& pair : compared) {
    const Verdict verdict = pair.contradict                                    ? Verdict::Bad
                            : calibration::largest_difference(pair.difference) ? Verdict::Good
                                                                               : Verdict::Doubtful;
    rows.push_back({{model_text(pair.words), {}, verdict}});
  }
  return rows;
}

}  // namespace

ComparisonView::ComparisonView(QWidget* parent)
    : QWidget(parent),
      verdict_(new VerdictLabel(tr("Whether the results agree"), this)),
      table_(new FigureTable(tr("Results side by side"), this)),
      pairs_(new FigureTable(tr("Every two results"), this)),
      clear_(new QPushButton(tr("Leave files out"), this)) {
  auto* add = new QPushButton(tr("Add result files…"), this);
  add->setToolTip(
      tr("Results of other methods or drives of the same vehicle, as the command line or the export "
         "writes them"));
  connect(add, &QPushButton::clicked, this, &ComparisonView::add_requested);
  connect(clear_, &QPushButton::clicked, this, &ComparisonView::clear_requested);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(add);
  buttons->addWidget(clear_);
  buttons->addStretch();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  column->addWidget(verdict_);
  column->addWidget(table_, 2);
  column->addWidget(pairs_, 1);
  column->addLayout(buttons);
  show_results({});
}

void ComparisonView::show_results(const std::vector<report::NamedResult>& results) {
  const std::vector<report::ComparedResults> compared = report::compare_results(results);
  const auto contradict =
      std::count_if(compared.begin(), compared.end(), [](const auto& pair) { return pair.contradict; });
  const bool any = std::any_of(compared.begin(), compared.end(), [](const auto& pair) {
    return calibration::largest_difference(pair.difference).has_value();
  });
  if (results.size() < 2)
    verdict_->show_verdict(Verdict::Neutral,
                           tr("Calibrate with another method, or add result files: they are set against each other "
                              "here, with a warning where they differ by more than they claim."));
  else if (contradict > 0)
    verdict_->show_verdict(Verdict::Bad,
                           tr("Results differ by more than they claim: do not use them before you know why."));
  else if (any)
    verdict_->show_verdict(Verdict::Good, tr("The results agree within what they claim."));
  else
    verdict_->show_verdict(Verdict::Doubtful, tr("The results have nothing in common that could be compared."));
  QStringList heads{tr("Result")};
  for (const calibration::Parameter i : calibration::kParameters)
    heads << parameter_name(i) + (calibration::is_angle(i) ? QStringLiteral(" [°]") : QStringLiteral(" [m]"));
  table_->show_rows(heads, value_rows(results));
  pairs_->show_rows({tr("In words")}, pair_rows(compared));
  pairs_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  pairs_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);  // sentences of two lines
  table_->setVisible(!results.empty());
  pairs_->setVisible(!compared.empty());
  clear_->setEnabled(results.size() > 1);
}

}  // namespace remount::widgets
