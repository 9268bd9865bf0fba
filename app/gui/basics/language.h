// The language of the window: the user's choice, at first the system's.
#pragma once

#include <QString>
#include <vector>

namespace remount::gui {

struct SpokenLanguage {
  QString code;  ///< "en", "zh_CN"
  QString name;  ///< in itself
};
/// Those that the program speaks.
const std::vector<SpokenLanguage>& languages();

/// The remembered choice, or the first of the system's languages that is spoken here; English where none is.
QString preferred_language();
/// Likewise, from the system's languages alone ("zh-Hans-CN").
QString language_for(const QStringList& system_languages);

/// All texts from now on are in this language; those that are on the screen are not changed by it. The choice is
/// remembered where `remember`.
void speak(const QString& code, bool remember);
QString spoken_language();

}  // namespace remount::gui
