#include "widgets/text/option_mentions.h"

#include <QCoreApplication>
#include <QHash>
#include <QRegularExpression>

#include "widgets/text/option_access.h"
#include "widgets/text/section_words.h"

namespace remount::widgets {
namespace {

struct MentionText {
  Q_DECLARE_TR_FUNCTIONS(remount::widgets::option_mentions)
};

const QHash<QString, OptionField>& options_by_key() {
  static const QHash<QString, OptionField> all = [] {
    QHash<QString, OptionField> fields;
    for (const OptionField& field : option_fields(settings::Settings{}))
      fields.insert(field.section + '.' + field.name, field);
    return fields;
  }();
  return all;
}

}  // namespace

QString with_option_labels(const QString& text) {
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

}  // namespace remount::widgets
