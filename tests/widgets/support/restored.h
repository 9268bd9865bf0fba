// What tests change for the whole application is put back however they end.
#pragma once

#include <QApplication>
#include <QPalette>

#include "app/gui/basics/language.h"

namespace remount::testing {

/// For as long as it lives; afterwards the palette is what it was.
class PaletteFor {
 public:
  explicit PaletteFor(const QPalette& palette) { QApplication::setPalette(palette); }
  ~PaletteFor() { QApplication::setPalette(before_); }
  PaletteFor(const PaletteFor&) = delete;
  PaletteFor& operator=(const PaletteFor&) = delete;

 private:
  QPalette before_ = QApplication::palette();
};

/// The same for the language, which is not remembered for the next start.
class LanguageFor {
 public:
  explicit LanguageFor(const QString& code = gui::spoken_language()) { gui::speak(code, false); }
  ~LanguageFor() { gui::speak(before_, false); }
  LanguageFor(const LanguageFor&) = delete;
  LanguageFor& operator=(const LanguageFor&) = delete;

 private:
  QString before_ = gui::spoken_language();
};

inline QPalette dark_palette() { return {QColor(58, 60, 65), QColor(45, 47, 51)}; }

}  // namespace remount::testing
