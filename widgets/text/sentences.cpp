#include "widgets/text/sentences.h"

namespace remount::widgets {

QString one_text(const QStringList& sentences) {
  QString text;
  for (const QString& sentence : sentences) {
    if (sentence.isEmpty()) continue;
    if (!text.isEmpty() && !QStringLiteral("。！？；：").contains(text.back())) text += QLatin1Char(' ');
    text += sentence;
  }
  return text;
}

}  // namespace remount::widgets
