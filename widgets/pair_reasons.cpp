#include "widgets/pair_reasons.h"

#include <QCoreApplication>

#include "algorithms/messages/render.h"
#include "widgets/model_text.h"

namespace remount {

const std::vector<const char*>& quick_reasons() {
  static const std::vector<const char*> reasons{
      QT_TRANSLATE_NOOP("remount::reasons", "moving objects"),
      QT_TRANSLATE_NOOP("remount::reasons", "aligned wrongly"),
      QT_TRANSLATE_NOOP("remount::reasons", "too little in common"),
      QT_TRANSLATE_NOOP("remount::reasons", "INS doubtful here"),
      QT_TRANSLATE_NOOP("remount::reasons", "view blocked or dirty"),
  };
  return reasons;
}

namespace {
/// The user's own words or one of the quick reasons, else the program's.
QString words_of(const std::string& reason) {
  const QString quick = QCoreApplication::translate("remount::reasons", reason.c_str());
  return quick != QString::fromStdString(reason) ? quick : model_text(reason);
}
}  // namespace

QString reason_words(const std::string& reason) { return reason.empty() ? QString() : words_of(reason); }

QString reason_words(const Message& reason) {
  return reason.code() == kVerbatim ? reason_words(english(reason)) : model_text(reason);
}

}  // namespace remount
