#include "widgets/quality/sharpness_view.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "algorithms/quality/map_sharpness.h"
#include "algorithms/quality/sharpness_limits.h"
#include "widgets/map/map_view.h"
#include "widgets/result/verdict_table.h"
#include "widgets/text/model_text.h"

namespace remount::widgets {
namespace {

const quality::NamedSharpness* sharpness_of(const std::vector<quality::NamedSharpness>& all,
                                            const calibration::MountingSource& source) {
  for (const quality::NamedSharpness& named : all)
    if (named.source == source) return &named;
  return nullptr;
}

QString name_of(const quality::NamedSharpness& named) {
  if (named.source == calibration::MountingSource::Result) return SharpnessView::tr("result");
  if (named.source == calibration::MountingSource::Nominal) return SharpnessView::tr("nominal");
  return SharpnessView::tr("candidate: %1").arg(model_text(calibration::in_words(named.source)));
}

/// One number of a row; that of nominal or result is marked where its map is clearly sharper, not merely by chance.
TableCell figure(const std::vector<quality::NamedSharpness>& all, const quality::NamedSharpness& named,
                 double quality::MapSharpness::*member, double scale, int decimals) {
  const double value = named.sharpness.*member;
  if (!std::isfinite(value)) return unknown_cell(SharpnessView::tr("The scans do not overlap enough."));
  const quality::NamedSharpness *result = sharpness_of(all, calibration::MountingSource::Result),
                                *nominal = sharpness_of(all, calibration::MountingSource::Nominal);
  const quality::NamedSharpness* other = &named == result ? nominal : &named == nominal ? result : nullptr;
  const bool better = other && value < other->sharpness.*member &&
                      quality::compare(named.sharpness, other->sharpness) == quality::SharperUnder::First;
  return {QString::number(scale * value, 'f', decimals), {}, better ? Verdict::Good : Verdict::Neutral};
}

/// Whether it matters that another row is sharper than the result.
QString order_in_words(const std::vector<quality::NamedSharpness>& all) {
  const quality::NamedSharpness* result = sharpness_of(all, calibration::MountingSource::Result);
  if (!result || !std::isfinite(result->sharpness.plane_thickness_m)) return {};
  if (result->sharpness.points < quality::kFewestPlaces)
    return SharpnessView::tr("Fewer than %1 places could be compared: the order of the rows says nothing.")
        .arg(quality::kFewestPlaces);
  QStringList sharper;
  for (const quality::NamedSharpness& named : all)
    if (quality::compare(named.sharpness, result->sharpness) == quality::SharperUnder::First) sharper << name_of(named);
  if (!sharper.isEmpty())
    return SharpnessView::tr(
               "Clearly sharper than the result: %1. Look at its map and at the pairs before you use the result.")
        .arg(sharper.join(QStringLiteral(", ")));
  const double share = quality::kClearlySharper - 1.0;
  return SharpnessView::
      tr("No row is clearly sharper than the result. Differences below %1 % (here %2 mm) are less than this measure "
         "can tell: the order of such rows is chance.")
          .arg(100.0 * share, 0, 'f', 0)
          .arg(1e3 * share * result->sharpness.plane_thickness_m, 0, 'f', 1);
}

}  // namespace

SharpnessView::SharpnessView(QWidget* parent)
    : QWidget(parent),
      verdict_(new VerdictLabel(tr("Under which mounting the map is sharper"), this)),
      table_(new FigureTable(tr("Sharpness of the accumulated map"), this)),
      order_(new NoteLabel(this)),
      before_(new QPushButton(this)),
      after_(new QPushButton(tr("Map under the result"), this)) {
  table_->setToolTip(
      tr("Lower is sharper. Thickness: how thick flat surfaces are, in mm. Entropy: mean map entropy, no unit."));
  before_->setToolTip(tr("Shows the accumulated map as it was with the mounting before"));
  after_->setToolTip(tr("Shows the accumulated map as it is with the new mounting"));
  connect(before_, &QPushButton::clicked, this, [this] { emit map_requested(MapX::Nominal); });
  connect(after_, &QPushButton::clicked, this, [this] { emit map_requested(MapX::Result); });
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(before_);
  buttons->addWidget(after_);
  buttons->addStretch();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  column->addWidget(verdict_);
  column->addLayout(buttons);
  column->addWidget(table_, 1);
  column->addWidget(order_);
  column->addStretch();
  show_message({});
  offer_maps(false, {});
}

void SharpnessView::offer_maps(bool any, const QString& start) {
  before_->setText(start.isEmpty() ? tr("Map under the nominal") : tr("Map under the %1").arg(start));
  before_->setEnabled(any);
  after_->setEnabled(any);
}

void SharpnessView::show_message(const QString& text) {
  verdict_->show_verdict(Verdict::Neutral, text);
  table_->hide();
  order_->hide();
}

void SharpnessView::show_sharpness(const std::vector<quality::NamedSharpness>& sharpness) {
  const quality::NamedSharpness *result = sharpness_of(sharpness, calibration::MountingSource::Result),
                                *nominal = sharpness_of(sharpness, calibration::MountingSource::Nominal);
  if (result && nominal) {
    const double after_mm = 1e3 * result->sharpness.plane_thickness_m,
                 before_mm = 1e3 * nominal->sharpness.plane_thickness_m;
    const QString figures = tr("surfaces are %1 mm thick under the result, %2 mm under the nominal")
                                .arg(after_mm, 0, 'f', 1)
                                .arg(before_mm, 0, 'f', 1);
    switch (quality::compare(result->sharpness, nominal->sharpness)) {
      case quality::SharperUnder::First:
        verdict_->show_verdict(Verdict::Good, tr("The map became sharper: %1.").arg(figures));
        break;
      case quality::SharperUnder::Second:
        verdict_->show_verdict(Verdict::Bad, tr("The map became blunter: %1.").arg(figures));
        break;
      case quality::SharperUnder::Neither:
        verdict_->show_verdict(Verdict::Neutral, tr("No clear difference: %1.").arg(figures));
        break;
      case quality::SharperUnder::TooFewPlaces:
        verdict_->show_verdict(Verdict::Neutral, tr("Too few places to tell: %1.").arg(figures));
        break;
    }
  } else {
    verdict_->show_verdict(Verdict::Neutral,
                           tr("No nominal mounting was given: there is nothing before to compare with."));
  }
  std::vector<std::vector<TableCell>> rows;
  for (const quality::NamedSharpness& named : sharpness)
    rows.push_back({{name_of(named), {}, Verdict::Neutral},
                    figure(sharpness, named, &quality::MapSharpness::plane_thickness_m, 1e3, 1),
                    figure(sharpness, named, &quality::MapSharpness::mean_map_entropy, 1.0, 3),
                    {QString::number(named.sharpness.points), tr("The same places are compared under every mounting"),
                     Verdict::Neutral}});
  table_->show_rows({tr("Mounting"), tr("Thickness [mm]"), tr("Entropy"), tr("Places compared")}, rows);
  table_->show();
  order_->show_note(order_in_words(sharpness));
}

}  // namespace remount::widgets
