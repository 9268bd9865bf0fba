#include "widgets/text/model_text.h"

#include <QLocale>

#include "algorithms/messages/catalogue.h"
#include "widgets/text/flag_mentions.h"
#include "widgets/text/option_mentions.h"

namespace remount::widgets {

QString in_words_of_window(const QString& text) { return with_option_labels(with_window_places(text)); }

QString model_text(const Message& message) {
  const QString words = QString::fromStdString(render(message, window_language()));
  return message.code() == kVerbatim ? words : in_words_of_window(words);  // what a user typed stays as it is
}

Language window_language() { return QLocale().language() == QLocale::Chinese ? Language::Chinese : Language::English; }

}  // namespace remount::widgets
