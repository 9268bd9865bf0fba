#include "widgets/result/result_tables.h"

#include <cmath>

#include "model/results/result_words.h"
#include "widgets/result/result_panel.h"
#include "widgets/text/model_text.h"
#include "widgets/text/parameter_text.h"

namespace remount::widgets {
namespace {

QString html_row(const QStringList& cells, const char* tag = "td") {
  QString row;
  for (qsizetype i = 0; i < cells.size(); ++i)
    row += QStringLiteral("<%1 align='%2'>%3&nbsp;&nbsp;</%1>")
               .arg(QLatin1String(tag), i == 0 ? QStringLiteral("left") : QStringLiteral("right"),
                    cells[i].toHtmlEscaped());
  return "<tr>" + row + "</tr>";
}

QString html_table(const QString& title, const QStringList& heads, const QString& rows) {
  return "<p><b>" + title.toHtmlEscaped() + "</b></p><table cellspacing='0'>" + html_row(heads, "th") + rows +
         "</table>";
}

}  // namespace

QString html_list(const QString& title, const QStringList& items) {
  if (items.isEmpty()) return {};
  QString html = "<p><b>" + title.toHtmlEscaped() + "</b></p><ul style='margin-left:-22px; margin-top:0'>";
  for (const QString& item : items) html += "<li>" + item.toHtmlEscaped() + "</li>";
  return html + "</ul>";
}

QString nominal_table(const pipeline::PipelineOutput& output) {
  if (!output.nominal_known || !results::has_mounting(output.result)) return {};
  const calibration::PerParameter<double> nominal = results::six_on_screen(output.initial_ins_from_lidar),
                                          found = results::six_on_screen(output.result.mounting.reference_from_sensor);
  QString rows;
  for (const calibration::Parameter i : calibration::kParameters) {
    double change = found[i] - nominal[i];
    if (calibration::is_angle(i)) change = radians_to_degrees(wrap_angle_rad(degrees_to_radians(change)));
    const auto number = [&](double value) { return rounded_text(value, 3) + unit_suffix(i); };
    const bool known = output.result.known[i].observed;
    rows += html_row({parameter_name(i), number(nominal[i]), known ? number(found[i]) : QStringLiteral("–"),
                      known ? moved_text(i, change) : QStringLiteral("–")});
  }
  return html_table(ResultPanel::tr("Nominal and new"),
                    {QString(), ResultPanel::tr("nominal"), ResultPanel::tr("new"), ResultPanel::tr("difference")},
                    rows);
}

QString sharpness_table(const pipeline::PipelineOutput& output) {
  if (output.sharpness.empty()) return {};
  QString rows;
  for (const quality::NamedSharpness& named : output.sharpness) {
    const QString name = named.source == calibration::MountingSource::Result ? ResultPanel::tr("after: result")
                         : named.source == calibration::MountingSource::Nominal
                             ? ResultPanel::tr("before: nominal")
                             : model_text(calibration::in_words(named.source));
    const auto number = [](double value, int decimals) {
      return std::isfinite(value) ? QString::number(value, 'f', decimals) : QStringLiteral("–");
    };
    rows += html_row({name, number(1e3 * named.sharpness.plane_thickness_m, 1) + QStringLiteral(" mm"),
                      number(named.sharpness.mean_map_entropy, 3)});
  }
  return html_table(ResultPanel::tr("Map sharpness (lower is sharper)"),
                    {QString(), ResultPanel::tr("surfaces"), ResultPanel::tr("entropy")}, rows);
}

}  // namespace remount::widgets
