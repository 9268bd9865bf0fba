#include "widgets/basics/theme.h"

#include <QApplication>
#include <QEvent>
#include <QPointer>
#include <QTimer>
#include <QWidget>

namespace remount::widgets {
namespace {
struct ThemeText {
  Q_DECLARE_TR_FUNCTIONS(remount::widgets::theme)
};

/// Keeps the style sheet of a widget in the colours of the present palette.
class StyleKeeper : public QObject {
 public:
  StyleKeeper(QWidget& widget, Style style) : QObject(&widget), style_(std::move(style)) { keep(); }
  void set_style(Style style) {
    style_ = std::move(style);
    keep();
  }
  void keep() {
    auto& widget = *static_cast<QWidget*>(parent());
    // Not the widget's own palette: that has the colours of its style sheet; and one that is hidden lags behind.
    const QString sheet = style_(QApplication::palette());
    // The same one, set once more, would style the widget and all in it anew.
    if (widget.styleSheet() != sheet) widget.setStyleSheet(sheet);
  }

 private:
  Style style_;
};

StyleKeeper* keeper_of(const QObject& widget) {
  for (QObject* child : widget.children())
    if (auto* keeper = dynamic_cast<StyleKeeper*>(child)) return keeper;
  return nullptr;
}

/// One for all: a filter of the application sees every event.
class PaletteWatch : public QObject {
 public:
  using QObject::QObject;
  bool eventFilter(QObject* watched, QEvent* event) override {
    // Afterwards, when every widget has its new palette.
    if (event->type() == QEvent::ApplicationPaletteChange && watched == parent())
      QTimer::singleShot(0, this, [] {
        for (const QWidget* widget : QApplication::allWidgets())
          if (StyleKeeper* keeper = keeper_of(*widget)) keeper->keep();
      });
    return false;
  }
};

void watch_palette() {
  static QPointer<PaletteWatch> watch;
  if (watch) return;
  watch = new PaletteWatch(qApp);
  qApp->installEventFilter(watch);
}
}  // namespace

bool is_dark(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
}

QColor good_color(const QPalette& palette) {
  return is_dark(palette) ? QColor(0x5f, 0xc8, 0x83) : QColor(0x1b, 0x7f, 0x45);
}
QColor warning_color(const QPalette& palette) {
  return is_dark(palette) ? QColor(0xf0, 0xb4, 0x4c) : QColor(0xa8, 0x62, 0x00);
}
QColor bad_color(const QPalette& palette) {
  return is_dark(palette) ? QColor(0xff, 0x7b, 0x72) : QColor(0xb4, 0x23, 0x18);
}

QColor state_color(motion::PairState state, const QPalette& palette) {
  switch (state) {
    case motion::PairState::Accepted:
      return good_color(palette);
    case motion::PairState::Rejected:
      return is_dark(palette) ? QColor(0x8b, 0x90, 0x98) : QColor(0x80, 0x85, 0x8d);
    case motion::PairState::Proposed:
      break;
  }
  return is_dark(palette) ? QColor(0x6c, 0xb0, 0xf5) : QColor(0x1f, 0x6f, 0xc4);
}

QString state_text(const motion::Pair& pair) {
  const bool by_user = pair.decided_by == motion::DecidedBy::User;
  switch (pair.state) {
    case motion::PairState::Accepted:
      return by_user ? ThemeText::tr("✓ accepted by you") : ThemeText::tr("✓ accepted");
    case motion::PairState::Rejected:
      return by_user ? ThemeText::tr("✕ rejected by you") : ThemeText::tr("✕ rejected");
    case motion::PairState::Proposed:
      break;
  }
  return ThemeText::tr("• proposed");
}

QColor severity_color(drive::Severity severity, const QPalette& palette) {
  if (severity == drive::Severity::Problem) return bad_color(palette);
  if (severity == drive::Severity::Warning) return warning_color(palette);
  return palette.color(QPalette::WindowText);
}

QString severity_sign(drive::Severity severity) {
  if (severity == drive::Severity::Problem) return QStringLiteral("✕");
  if (severity == drive::Severity::Warning) return QStringLiteral("▲");
  return QStringLiteral("•");
}

QColor tint(const QColor& color, const QPalette& palette) {
  const QColor base = palette.color(QPalette::Base);
  constexpr double kShare = 0.16;
  const auto mix = [](int a, int b) { return static_cast<int>(a * kShare + b * (1.0 - kShare)); };
  return {mix(color.red(), base.red()), mix(color.green(), base.green()), mix(color.blue(), base.blue())};
}

QColor faded_color(const QPalette& palette) { return palette.color(QPalette::Disabled, QPalette::WindowText); }

void prepare_theme() { QCoreApplication::setAttribute(Qt::AA_UseStyleSheetPropagationInWidgetStyles); }

void set_style(QWidget& widget, const Style& style) {
  watch_palette();
  if (StyleKeeper* keeper = keeper_of(widget))
    keeper->set_style(style);
  else
    new StyleKeeper(widget, style);
}

Style text_in(QColor (*color)(const QPalette&)) {
  return [color](const QPalette& palette) { return QString("color: " + color(palette).name()); };
}

Style marked_box(QColor (*color)(const QPalette&), const QString& more) {
  return [color, more](const QPalette& palette) {
    return QStringLiteral("%1; border-left: 4px solid %2; background: %3")
        .arg(more, color(palette).name(), tint(color(palette), palette).name());
  };
}

}  // namespace remount::widgets
