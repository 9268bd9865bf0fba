#include "widgets/forms/option_mentions.h"

#include <QCoreApplication>
#include <QHash>
#include <QRegularExpression>

#include "widgets/forms/option_access.h"
#include "widgets/forms/section_words.h"

namespace remount {
namespace {

struct MentionText {
  Q_DECLARE_TR_FUNCTIONS(remount::option_mentions)
};

const QHash<QString, OptionField>& options_by_key() {
  static const QHash<QString, OptionField> all = [] {
    QHash<QString, OptionField> fields;
    for (const OptionField& field : option_fields(Settings{})) fields.insert(field.section + '.' + field.name, field);
    return fields;
  }();
  return all;
}

/// "--topic lidar=TOPIC takes another" -> "“Topics…” takes another".
QString without_flags(QString text) {
  static const QRegularExpression topic(QStringLiteral(R"(--topic(?: [\w-]+=(?:TOPIC|none|/[\w/~-]*))?)"));
  if (!text.contains(QLatin1String("--"))) return text;
  text.replace(topic, Words::tr("“Topics…”"));
  text.replace(QLatin1String("--nominal"), Words::tr("a nominal mounting"));
  text.replace(QLatin1String("--method"), Words::tr("the method"));
  text.replace(QLatin1String("--measured"), QStringLiteral("“%1”").arg(section_title(QStringLiteral("measured"))));
  return text;
}

}  // namespace

QString with_option_labels(const QString& with_flags) {
  const QString text = without_flags(with_flags);
  static const QRegularExpression key(QStringLiteral(R"((?<![\w./])[a-z_]+\.[a-z0-9_]+(?![\w/]|\.\w))"));
  if (!text.contains('.')) return text;
  QString said = text;
  // From the end, so that the places found stay where they are.
  QList<QRegularExpressionMatch> found;
  for (auto each = key.globalMatch(text); each.hasNext();) found.prepend(each.next());
  for (const QRegularExpressionMatch& match : found) {
    const bool is_place = match.capturedStart() == 0 && text.mid(match.capturedEnd()).startsWith(':');
    if (is_place) continue;
    const auto option = options_by_key().constFind(match.captured());
    if (option == options_by_key().constEnd()) continue;
    said.replace(match.capturedStart(), match.capturedLength(),
                 MentionText::tr("“%1” (%2)").arg(option_label(*option), section_title(option->section)));
  }
  return said;
}

}  // namespace remount
