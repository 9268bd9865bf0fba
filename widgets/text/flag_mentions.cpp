#include "widgets/text/flag_mentions.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <functional>

#include "model/method_registry/calibration_method.h"
#include "widgets/text/model_text.h"
#include "widgets/text/section_words.h"
#include "widgets/text/topic_role_words.h"

namespace remount::widgets {
namespace {

struct FlagText {
  Q_DECLARE_TR_FUNCTIONS(remount::widgets::flag_mentions)
};

using Replaced = std::function<QString(const QRegularExpressionMatch&)>;

QString replace(const QString& text, const QRegularExpression& what, const Replaced& by) {
  QString out;
  qsizetype end = 0;
  for (auto each = what.globalMatch(text); each.hasNext();) {
    const QRegularExpressionMatch match = each.next();
    out += text.mid(end, match.capturedStart() - end) + by(match);
    end = match.capturedEnd();
  }
  return out + text.mid(end);
}

QString method_title(const QString& id) {
  const method_registry::CalibrationMethod* method = method_registry::find_method(id.toStdString());
  return method ? FlagText::tr("“%1”").arg(model_text(method->title())) : id;
}

/// `role` and `topic` as they stand on the command line; either may be empty.
QString topics_place(const QString& role, const QString& topic) {
  const QString button = QCoreApplication::translate("remount::widgets::SessionsPanel", "Topics…");
  if (role.isEmpty()) return FlagText::tr("“%1”").arg(button);
  const QString name = role_name(role.toStdString());
  if (topic == QLatin1String("TOPIC") || topic == QLatin1String("NAME"))
    return FlagText::tr("“%1: %2”").arg(button, name);
  return FlagText::tr("“%1: %2 – %3”").arg(button, name, topic == QLatin1String("none") ? FlagText::tr("none") : topic);
}

QString place_of(const QString& flag) {
  if (flag == QLatin1String("nominal")) return FlagText::tr("Nominal mounting");
  return section_title(flag);
}

}  // namespace

QString with_window_places(const QString& text) {
  if (!text.contains(QLatin1String("--"))) return text;
  static const QRegularExpression kPanel(QStringLiteral(R"((\bwith )?(?<![\w/-])--(nominal|range|measured)\b)")),
      kTopic(QStringLiteral(R"((\bwith )?(?<![\w/-])--topic\b(?:\s+([a-z-]+)=([\w/~-]+))?)")),
      kMethods(QStringLiteral(R"((?<![\w/-])--method\s+([a-z-]+(?:(?:, | or |\s*或\s*)[a-z-]+)*))")),
      kMethod(QStringLiteral("[a-z]+(?:-[a-z]+)*")), kLidars(QStringLiteral(R"((?<![\w/-])--lidars(?:\s+all\b)?)")),
      kSet(QStringLiteral(R"(--set\s+(?=[a-z_]+\.[a-z]))"));
  const auto in = [](const QRegularExpressionMatch& match, const QString& place) {
    return match.captured(1).isEmpty() ? place : FlagText::tr("in %1").arg(place);
  };
  QString said = replace(text, kPanel, [&](const QRegularExpressionMatch& match) {
    return in(match, FlagText::tr("“%1”").arg(place_of(match.captured(2))));
  });
  said = replace(said, kTopic, [&](const QRegularExpressionMatch& match) {
    return in(match, topics_place(match.captured(2), match.captured(3)));
  });
  said = replace(said, kMethods, [&](const QRegularExpressionMatch& match) {
    const QString titles = replace(match.captured(1), kMethod,
                                   [](const QRegularExpressionMatch& id) { return method_title(id.captured()); });
    return FlagText::tr("the method %1").arg(titles);
  });
  said = replace(said, kLidars, [](const QRegularExpressionMatch&) {
    return FlagText::tr("the panel “%1”").arg(QCoreApplication::translate("remount::gui::VehicleFeature", "LiDARs"));
  });
  return said.remove(kSet);
}

}  // namespace remount::widgets
