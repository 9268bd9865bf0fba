// Holds a panel that may be given less room than it needs: it scrolls then, and the window fits on a small screen.
#pragma once

#include <QScrollArea>

namespace remount::widgets {

class ShrinkingArea : public QScrollArea {
  Q_OBJECT
 public:
  /// @param least what it is given in any case, unless the content needs less
  explicit ShrinkingArea(QWidget* content, QSize least = {160, 80}, QWidget* parent = nullptr);

  QSize minimumSizeHint() const override;
  QSize sizeHint() const override;

 private:
  QSize least_;
};

}  // namespace remount::widgets
