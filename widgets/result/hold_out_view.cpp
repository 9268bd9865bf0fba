#include "widgets/result/hold_out_view.h"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "model/formats/files/number_text.h"
#include "model/results/display_units.h"
#include "model/results/result_file.h"
#include "widgets/basics/rows.h"
#include "widgets/result/verdict_table.h"
#include "widgets/text/model_text.h"
#include "widgets/text/parameter_text.h"
#include "widgets/text/sentences.h"

namespace remount::widgets {
namespace {

using Rows = std::vector<std::vector<TableCell>>;

TableCell rms_cell(const pipeline::ResidualRms& residual, const QString& why_not, const QString& tool_tip = {}) {
  if (!std::isfinite(residual.translation_m)) return unknown_cell(why_not);
  return {HoldOutView::tr("%1°, %2 mm")
              .arg(radians_to_degrees(residual.rotation_rad), 0, 'f', 3)
              .arg(1e3 * residual.translation_m, 0, 'f', 1),
          tool_tip, Verdict::Neutral};
}

QString why_unsolved(const pipeline::SessionAlone& session, const QString& name) {
  return calibration::is_usable(session.result)
             ? QString()
             : HoldOutView::tr("%1 alone gives no result: %2").arg(name, model_text(session.result.message));
}

QString first_of(const QStringList& reasons) {
  for (const QString& reason : reasons)
    if (!reason.isEmpty()) return reason;
  return HoldOutView::tr("There are no pairs to score.");
}

Rows score_rows(const pipeline::HoldOut& found, const QStringList& names) {
  Rows rows;
  for (const pipeline::HeldOutScore& score : found.scores) {
    const QString a = names.value(qt_row(score.solved_on)), b = names.value(qt_row(score.scored_on));
    const pipeline::SessionAlone& solved = found.sessions[score.solved_on];
    const pipeline::SessionAlone& scored = found.sessions[score.scored_on];
    const QString own_missing = why_unsolved(scored, b);
    const QString lent = shown_parameter_names(score.lent);
    const QString note =
        lent.isEmpty() ? QString() : HoldOutView::tr("%1 does not observe %2: taken from %3's own X").arg(a, lent, b);
    rows.push_back({{a, {}, Verdict::Neutral},
                    {b, {}, Verdict::Neutral},
                    {QString::number(scored.pairs), {}, Verdict::Neutral},
                    rms_cell(score.residual, first_of({why_unsolved(solved, a), own_missing}), note),
                    rms_cell(scored.own, first_of({own_missing})),
                    rms_cell(scored.common, first_of({HoldOutView::tr("There is no common result.")}))});
  }
  return rows;
}

/// "+1.2 ± 0.8", in mm or degrees.
QString difference_text(calibration::Parameter i, double difference, double sigma) {
  const double units = calibration::is_angle(i) ? 1.0 : 1e3;
  const int decimals = calibration::is_angle(i) ? 4 : 1;
  return QString::fromStdString(formats::signed_text(units * results::on_screen(i, difference), decimals)) + u' ' +
         spread_text(units * results::on_screen(i, sigma), decimals);
}

QStringList difference_heads() {
  QStringList heads{HoldOutView::tr("Difference of X")};
  for (const calibration::Parameter i : calibration::kParameters)
    heads << QStringLiteral("%1 [%2]").arg(parameter_name(i),
                                           calibration::is_angle(i) ? QStringLiteral("°") : QStringLiteral("mm"));
  return heads << HoldOutView::tr("In words");
}

bool differ(const pipeline::SessionDifference& difference) {
  const auto largest = calibration::largest_difference(difference);
  return largest && largest->sigmas > calibration::kDiffer_sigma;
}

Verdict verdict_of(const pipeline::SessionDifference& difference) {
  if (!calibration::largest_difference(difference)) return Verdict::Doubtful;
  return differ(difference) ? Verdict::Bad : Verdict::Good;
}

QString in_words(const pipeline::SessionDifference& difference) {
  const auto largest = calibration::largest_difference(difference);
  if (!largest) return HoldOutView::tr("nothing is observed by both");
  const QString sigmas = QString::number(largest->sigmas, 'f', 1), name = parameter_name(largest->parameter);
  if (differ(difference)) return HoldOutView::tr("differ by %1 sigma in %2").arg(sigmas, name);
  const auto both =
      std::count_if(calibration::kParameters.begin(), calibration::kParameters.end(),
                    [&](calibration::Parameter parameter) { return std::isfinite(difference.sigma[parameter]); });
  return HoldOutView::tr("agree in %1 of 6 parameters (at most %2 sigma, in %3)").arg(both).arg(sigmas, name);
}

/// Once for the whole page: what its dashes stand for, session by session. Empty where there is none.
QString dashes_in_words(const pipeline::HoldOut& found, const QStringList& names) {
  QStringList reasons;
  for (motion::SessionIndex session; session < found.sessions.size(); ++session) {
    const pipeline::SessionAlone& alone = found.sessions[session];
    const QString name = names.value(qt_row(session)), unsolved = why_unsolved(alone, name);
    const QString blind = shown_parameter_names(~alone.result.observed());
    if (!unsolved.isEmpty())
      reasons << unsolved;
    else if (!blind.isEmpty())
      reasons << HoldOutView::tr("%1 alone does not observe %2.").arg(name, blind);
  }
  if (reasons.isEmpty()) return {};
  reasons.prepend(HoldOutView::tr("–: no number, because a session alone says nothing about it."));
  return one_text(reasons);
}

TableCell difference_cell(const pipeline::HoldOut& found, const pipeline::SessionDifference& difference,
                          calibration::Parameter i, const QStringList& names) {
  if (std::isfinite(difference.sigma[i])) {
    const double sigmas = std::abs(difference.difference[i]) / difference.sigma[i];
    return {difference_text(i, difference.difference[i], difference.sigma[i]),
            HoldOutView::tr("%1 times the sigma of both together").arg(sigmas, 0, 'f', 1),
            sigmas > calibration::kDiffer_sigma ? Verdict::Bad : Verdict::Neutral};
  }
  QStringList reasons;
  for (const motion::SessionIndex session : {difference.a, difference.b}) {
    const pipeline::SessionAlone& alone = found.sessions[session];
    const QString name = names.value(qt_row(session)), unsolved = why_unsolved(alone, name);
    if (!unsolved.isEmpty())
      reasons << unsolved;
    else if (!alone.result.known[i].observed)
      reasons << HoldOutView::tr("%1 does not observe %2").arg(name, parameter_name(i));
  }
  return unknown_cell(reasons.join('\n'));
}

Rows difference_rows(const pipeline::HoldOut& found, const QStringList& names) {
  Rows rows;
  for (const pipeline::SessionDifference& difference : found.differences) {
    std::vector<TableCell> row{
        {QStringLiteral("%1 − %2").arg(names.value(qt_row(difference.a)), names.value(qt_row(difference.b))),
         {},
         Verdict::Neutral}};
    for (const calibration::Parameter i : calibration::kParameters)
      row.push_back(difference_cell(found, difference, i, names));
    const bool compared = calibration::largest_difference(difference).has_value();
    row.push_back(compared ? TableCell{in_words(difference), {}, verdict_of(difference)}
                           : unknown_cell(in_words(difference)));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

HoldOutView::HoldOutView(QWidget* parent)
    : QWidget(parent),
      verdict_(new VerdictLabel(tr("Whether the sessions agree"), this)),
      dashes_(new NoteLabel(this)),
      scores_(new FigureTable(tr("Residuals of each session under the X of another"), this)),
      differences_(new FigureTable(tr("Differences between the X of two sessions"), this)) {
  scores_->setToolTip(
      tr("What P X = X Q leaves over the pairs of the session it is scored on, root mean square, in degrees and mm. "
         "Where all clouds were aligned together as the last step, residuals are slightly too small."));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  column->addWidget(verdict_);
  column->addWidget(dashes_);
  column->addWidget(scores_, 1);
  column->addWidget(differences_, 1);
  column->addStretch();
  show_message({});
}

void HoldOutView::show_message(const QString& text) {
  verdict_->show_verdict(Verdict::Neutral, text);
  dashes_->hide();
  scores_->hide();
  differences_->hide();
}

void HoldOutView::show_hold_out(const pipeline::HoldOut& found, const QStringList& names) {
  const auto sigmas = [](const pipeline::SessionDifference& difference) {
    const auto largest = calibration::largest_difference(difference);
    return largest ? largest->sigmas : -1.0;
  };
  const auto worst =
      std::max_element(found.differences.begin(), found.differences.end(),
                       [&](const auto& left, const auto& right) { return sigmas(left) < sigmas(right); });
  if (worst == found.differences.end()) return show_message(tr("Needs a second session."));
  const QString pair = tr("%1 and %2").arg(names.value(worst->a), names.value(worst->b));
  verdict_->show_verdict(verdict_of(*worst),
                         calibration::largest_difference(*worst)
                             ? tr("Each session solved alone. %1: %2.").arg(pair, in_words(*worst))
                             : tr("Each session solved alone. No two of them observe the same parameter: whether they "
                                  "agree cannot be said."));
  dashes_->show_note(dashes_in_words(found, names));
  scores_->show_rows({tr("Solved on"), tr("Scored on"), tr("Pairs"), tr("Under that X"), tr("Under its own X"),
                      tr("Under the common X")},
                     score_rows(found, names));
  differences_->show_rows(difference_heads(), difference_rows(found, names));
  scores_->show();
  differences_->show();
}

}  // namespace remount::widgets
