#include "widgets/pair_reasons.h"

#include <QCoreApplication>

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

QString reason_words(const std::string& reason) {
  return reason.empty() ? QString() : QCoreApplication::translate("remount::reasons", reason.c_str());
}

}  // namespace remount
