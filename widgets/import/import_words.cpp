#include "widgets/import/import_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

#include "widgets/text/model_text.h"

namespace remount::widgets {
namespace {

struct ImportText {
  Q_DECLARE_TR_FUNCTIONS(remount::widgets::import_words)
};

}  // namespace

QString style_words(guesses::AttitudeStyle style) {
  switch (style) {
    case guesses::AttitudeStyle::Heading:
      return ImportText::tr("Heading from north, clockwise; nose up positive");
    case guesses::AttitudeStyle::EnuYaw:
      return ImportText::tr("Yaw from east, counter-clockwise; nose down positive");
    case guesses::AttitudeStyle::NovAtel:
      return ImportText::tr("NovAtel: azimuth from north, axes right-forward-up");
    case guesses::AttitudeStyle::QuaternionEnu:
      return ImportText::tr("Quaternion, vehicle to east-north-up (ROS)");
    default:
      return ImportText::tr("Quaternion, forward-right-down to north-east-down");
  }
}

QString time_unit_words(std::int64_t unit_ns) {
  switch (unit_ns) {
    case 1'000'000'000:
      return ImportText::tr("seconds");
    case 1'000'000:
      return ImportText::tr("milliseconds");
    case 1'000:
      return ImportText::tr("microseconds");
    case 1:
      return ImportText::tr("nanoseconds");
    default:
      return ImportText::tr("date or time of day");
  }
}

QString place_unit_words(formats::PlaceUnit unit) {
  switch (unit) {
    case formats::PlaceUnit::Radians:
      return ImportText::tr("radians");
    case formats::PlaceUnit::DegreesMinutes:
      return ImportText::tr("degrees and minutes (ddmm.mmmm)");
    case formats::PlaceUnit::TenMillionths:
      return ImportText::tr("ten-millionths of a degree");
    default:
      return ImportText::tr("degrees");
  }
}

QString time_scale_words(formats::TimeScale scale) {
  switch (scale) {
    case formats::TimeScale::Unix:
      return ImportText::tr("UTC, since 1970 (Unix)");
    case formats::TimeScale::Gps:
      return ImportText::tr("GPS, since 1980 or of a week");
    default:
      return ImportText::tr("GPS, of a week that is not given");
  }
}

QString date_order_words(formats::DateOrder order) { return model_text(guesses::words(order)); }

QString difference_words(const guesses::SampledTable& table, const guesses::TableChoices& from,
                         const guesses::TableChoices& to) {
  QStringList parts;
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (from.roles.at(i) != to.roles.at(i))
      parts << ImportText::tr("%1: %2").arg(QString::fromStdString(table.label(i)),
                                            model_text(guesses::words(to.roles.at(i))));
  if (from.time_unit_ns != to.time_unit_ns) parts << time_unit_words(to.time_unit_ns);
  if (from.date_order != to.date_order && to.time_unit_ns == 0) parts << date_order_words(to.date_order);
  if (from.time_scale != to.time_scale) parts << time_scale_words(to.time_scale);
  if (from.position_unit != to.position_unit && !to.metric())
    parts << ImportText::tr("position in %1").arg(place_unit_words(to.position_unit));
  if (from.attitude != to.attitude) parts << style_words(to.attitude);
  if (from.attitude_in_deg != to.attitude_in_deg && !guesses::is_quaternion(to.attitude))
    parts << (to.attitude_in_deg ? ImportText::tr("angles in degrees") : ImportText::tr("angles in radians"));
  const QString names[] = {ImportText::tr("heading turned round"), ImportText::tr("pitch turned round"),
                           ImportText::tr("roll turned round")};
  const QString usual[] = {ImportText::tr("heading as usual"), ImportText::tr("pitch as usual"),
                           ImportText::tr("roll as usual")};
  for (std::size_t i = 0; i < 3; ++i)
    if (from.negated.at(i) != to.negated.at(i)) parts << (to.negated.at(i) ? names[i] : usual[i]);
  return parts.join(QStringLiteral(", "));
}

QString evidence_words(const guesses::Guess& guess) {
  QStringList lines;
  // How other readings are written in a manifest, the list of readings says in words.
  for (const Message& evidence : guess.evidence)
    if (evidence.code() != "guess-rival") lines << model_text(evidence);
  if (guess.sureness == guesses::Sureness::Open) std::ranges::reverse(lines);
  return lines.join('\n');
}

}  // namespace remount::widgets
