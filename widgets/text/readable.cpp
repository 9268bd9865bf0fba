#include "widgets/text/readable.h"

#include <QAbstractButton>
#include <QApplication>
#include <QEvent>
#include <QPainter>
#include <QProxyStyle>
#include <QStyleOption>
#include <algorithm>
#include <cmath>
#include <functional>

namespace remount::widgets {
namespace {

constexpr double kText = 4.5, kEdge = 3.0;  // WCAG 2.1: text, and parts of controls

double luminance(const QColor& color) {
  const auto linear = [](double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

/// Calls `apply` now and after every change of the widget's palette.
class PaletteFollower : public QObject {
 public:
  PaletteFollower(QWidget& widget, std::function<void()> apply) : QObject(&widget), apply_(std::move(apply)) {
    widget.installEventFilter(this);
    apply_();
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool changed = event->type() == QEvent::PaletteChange || event->type() == QEvent::ApplicationPaletteChange;
    if (changed && !applying_) {
      applying_ = true;  // what it sets is a change, too
      apply_();
      applying_ = false;
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  std::function<void()> apply_;
  bool applying_ = false;
};

/// Draws an edge around boxes that are not ticked. A style sheet would not follow another palette.
class EdgeStyle : public QProxyStyle {
 public:
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    const bool box = element == PE_IndicatorCheckBox, circle = element == PE_IndicatorRadioButton;
    if ((!box && !circle) || !option->state.testFlag(State_Off)) return;
    const QPalette& palette = option->palette;
    painter->save();
    painter->setBrush(Qt::NoBrush);
    painter->setPen(faint_but_readable(palette.color(QPalette::WindowText), palette.color(QPalette::Window), kEdge));
    painter->setRenderHint(QPainter::Antialiasing, circle);
    const QRect edge = option->rect.adjusted(0, 0, -1, -1);
    circle ? painter->drawEllipse(edge) : painter->drawRect(edge);
    painter->restore();
  }
};

}  // namespace

double contrast(const QColor& first, const QColor& second) {
  const double a = luminance(first), b = luminance(second);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

QColor faint_but_readable(const QColor& ink, const QColor& paper, double least_contrast) {
  constexpr int kSteps = 20;
  for (int step = kSteps / 2; step < kSteps; ++step) {
    const auto mix = [share = static_cast<double>(step) / kSteps](int a, int b) {
      return static_cast<int>(std::lround(a * share + b * (1.0 - share)));
    };
    const QColor mixed(mix(ink.red(), paper.red()), mix(ink.green(), paper.green()), mix(ink.blue(), paper.blue()));
    if (contrast(mixed, paper) >= least_contrast) return mixed;
  }
  return ink;
}

void keep_placeholder_readable(QWidget& editor) {
  new PaletteFollower(editor, [&editor] {
    const QPalette now = QApplication::palette(&editor);
    const QColor color = faint_but_readable(now.color(QPalette::Text), now.color(QPalette::Base), kText);
    QPalette own;  // of this role alone: the others go on following the application's
    own.setColor(QPalette::PlaceholderText, color);
    editor.setPalette(own);
  });
}

void keep_box_visible(QAbstractButton& box) {
  auto* style = new EdgeStyle;
  style->setParent(&box);
  box.setStyle(style);
}

}  // namespace remount::widgets
