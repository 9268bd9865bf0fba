#include "widgets/text/model_text.h"

#include <QCoreApplication>
#include <QHash>
#include <QLocale>
#include <QRegularExpression>
#include <QSet>
#include <algorithm>
#include <mutex>

#include "algorithms/messages/render.h"
#include "widgets/text/flag_mentions.h"
#include "widgets/text/option_mentions.h"

namespace remount {
namespace {

constexpr const char* kContext = "remount::model";
constexpr const char* kComma = ", ";  // itself a phrase
constexpr qsizetype kMostRemembered = 4000;

struct Pattern {
  QString piece;  // stands in every text that fits: most are told by it, before an expression is compiled for them
  QRegularExpression expression;
  QString translation;
  qsizetype letters = 0;   // that have to be there
  QList<int> as_they_are;  // placeholders in quotes: names in files, which are not translated
};

struct Patterns {
  QString probe;  // one phrase in the language that the rest is in
  std::vector<Pattern> list;
  QSet<QString> phrases;  // in English
  QHash<QString, QString> known;
};

/// The longest piece between placeholders.
QString fixed_piece(const QString& english) {
  static const QRegularExpression kPlaceholder(QStringLiteral("%\\d"));
  const QStringList pieces = english.split(kPlaceholder);
  return *std::max_element(pieces.begin(), pieces.end(),
                           [](const QString& a, const QString& b) { return a.size() < b.size(); });
}

QList<int> quoted(const QString& english) {
  static const QRegularExpression kQuoted(QStringLiteral("['\"]%(\\d)['\"]"));
  QList<int> numbers;
  for (auto match = kQuoted.globalMatch(english); match.hasNext();) numbers << match.next().captured(1).toInt();
  return numbers;
}

QString translated(const char* phrase) { return QCoreApplication::translate(kContext, phrase); }

/// The patterns of the present language; made anew where that has changed.
Patterns& patterns() {
  static Patterns all;
  const QString probe = translated("observed");
  if (probe == all.probe) return all;
  all = {probe, {}, {}, {}};
  for (const char* phrase : model_phrases()) {
    const QString english = QString::fromUtf8(phrase), other = translated(phrase);
    all.phrases.insert(english);
    if (!english.contains(QLatin1String("%1")) || other == english) continue;
    QString expression = QRegularExpression::escape(english);
    expression.replace(QRegularExpression(QStringLiteral("\\\\%(\\d)")), QStringLiteral("(?<a\\1>.+?)"));
    all.list.push_back({fixed_piece(english),
                        QRegularExpression(QStringLiteral("\\A") + expression + QStringLiteral("\\z"),
                                           QRegularExpression::DotMatchesEverythingOption),
                        other, english.size(), quoted(english)});
  }
  // What says more is tried first: "%1 with %2" would take many a sentence apart.
  std::stable_sort(all.list.begin(), all.list.end(),
                   [](const Pattern& a, const Pattern& b) { return a.letters > b.letters; });
  return all;
}

/// What stands for a "%1": a sentence, a phrase, phrases with commas between them, or lines of a list.
/// @param is_list_of_names where there are commas; such a list stays as it is
QString captured_text(const QString& text, bool is_list_of_names, const Patterns& all) {
  if (text.startsWith(QLatin1Char('\n'))) {
    QStringList lines = text.split(QLatin1Char('\n'));
    for (QString& line : lines) {
      const QString words = line.trimmed();
      line = line.left(line.indexOf(words)) + model_text(words);
    }
    return lines.join(QLatin1Char('\n'));
  }
  const QString whole = model_text(text);
  if (whole != text || is_list_of_names || !text.contains(QLatin1String(kComma))) return whole;
  QStringList parts = text.split(QLatin1String(kComma));
  for (QString& part : parts) {
    if (!all.phrases.contains(part)) return text;
    part = translated(part.toUtf8().constData());
  }
  return parts.join(translated(kComma));
}

// "%1 with %2" fits many a sentence that it says nothing about: what stands in such a one is known or a name.
constexpr qsizetype kFewLetters = 16;
bool may_stand_in_few_words(const QString& captured, const QString& words) {
  return words != captured || captured.count(QLatin1Char(' ')) < 3;
}

QString by_pattern(const QString& text, const Patterns& all) {
  for (const Pattern& pattern : all.list) {
    if (!text.contains(pattern.piece)) continue;
    const QRegularExpressionMatch match = pattern.expression.match(text);
    if (!match.hasMatch()) continue;
    QString sentence = pattern.translation;
    bool fits = true;
    for (int i = 1; i < match.lastCapturedIndex() + 1; ++i) {
      const QString captured = match.captured(QStringLiteral("a%1").arg(i));
      const QString words =
          pattern.as_they_are.contains(i) ? captured : captured_text(captured, !pattern.as_they_are.isEmpty(), all);
      fits = fits && (pattern.letters > kFewLetters || may_stand_in_few_words(captured, words));
      sentence.replace(QStringLiteral("%%1").arg(i), words);
    }
    if (fits) return sentence;
  }
  return text;
}

}  // namespace

QString in_words_of_window(const QString& text) { return with_option_labels(with_window_places(text)); }

QString model_text(const QString& text) {
  // Reports are written in the background while the window paints; recursive, for patterns hold texts of their own.
  static std::recursive_mutex mutex;
  const std::scoped_lock lock(mutex);
  if (text.isEmpty()) return text;
  Patterns& all = patterns();
  if (all.list.empty()) return in_words_of_window(text);  // English
  if (const auto found = all.known.constFind(text); found != all.known.constEnd()) return *found;
  const QString exact = QCoreApplication::translate(kContext, text.toUtf8().constData());
  const QString result = in_words_of_window(exact != text ? exact : by_pattern(text, all));
  if (all.known.size() > kMostRemembered) all.known.clear();
  all.known.insert(text, result);
  return result;
}

QString model_text(std::string_view text) { return model_text(QString::fromUtf8(text)); }

QString model_text(const std::string& text) { return model_text(std::string_view(text)); }

QString model_text(const Message& message) {
  const QString words = QString::fromStdString(render(message, window_language()));
  return message.code() == kVerbatim ? words : in_words_of_window(words);  // what a user typed stays as it is
}

Language window_language() { return QLocale().language() == QLocale::Chinese ? Language::Chinese : Language::English; }

}  // namespace remount
