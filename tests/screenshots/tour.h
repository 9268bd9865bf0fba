// Every page and dialog of the window, as pictures for people to look at before a change is called done.
#pragma once

#include <QSize>
#include <QString>
#include <QStringList>

namespace remount::testing {

struct TourRequest {
  QString folder;        ///< where the pictures go
  QStringList sessions;  ///< none: the bundled sample
  QString language = QStringLiteral("en");
  QSize size{1440, 900};
  bool dark = false;
};

/// From an empty start to an exported file; false where that did not succeed.
bool take_tour(const TourRequest& request);

}  // namespace remount::testing
