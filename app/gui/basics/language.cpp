#include "app/gui/basics/language.h"

#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>

#include "widgets/basics/remembering.h"

/// Resources of a static library are left out where nothing names them. Not in a namespace: the macro says so.
static void name_resources() {
  Q_INIT_RESOURCE(translations);
  Q_INIT_RESOURCE(help);
}

namespace remount::gui {
namespace {

const QString kLanguageKey = QStringLiteral("language");

struct LanguageState {
  QString code = QStringLiteral("en");
  QTranslator own, of_qt;
};
LanguageState& language_state() {
  static auto* only = new LanguageState;  // outlives the application, which unhooks its translators when it ends
  return *only;
}

}  // namespace

const std::vector<SpokenLanguage>& languages() {
  static const std::vector<SpokenLanguage> all{{"en", QStringLiteral("English")},
                                               {"zh_CN", QStringLiteral("简体中文")}};
  return all;
}

QString language_for(const QStringList& system_languages) {
  for (const QString& wanted : system_languages) {
    const QLocale locale(QString(wanted).replace('-', '_'));
    if (locale.language() == QLocale::English) return QStringLiteral("en");
    // Readers of traditional characters are better served by simplified ones than by English.
    if (locale.language() == QLocale::Chinese) return QStringLiteral("zh_CN");
  }
  return QStringLiteral("en");
}

QString preferred_language() {
  const QString chosen = widgets::remembers() ? QSettings().value(kLanguageKey).toString() : QString();
  for (const SpokenLanguage& language : languages())
    if (language.code == chosen) return chosen;
  return language_for(QLocale::system().uiLanguages());
}

void speak(const QString& code, bool remember) {
  name_resources();
  LanguageState& now = language_state();
  for (QTranslator* translator : {&now.own, &now.of_qt}) QCoreApplication::removeTranslator(translator);
  now.code = code;
  if (now.of_qt.load("qtbase_" + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(&now.of_qt);  // buttons of Qt's own dialogs
  if (now.own.load(":/translations/remount_" + code + ".qm")) QCoreApplication::installTranslator(&now.own);
  QLocale::setDefault(code == QLatin1String("en") ? QLocale(QLocale::English) : QLocale(code));
  if (remember && widgets::remembers()) QSettings().setValue(kLanguageKey, code);
}

QString spoken_language() { return language_state().code; }

}  // namespace remount::gui
