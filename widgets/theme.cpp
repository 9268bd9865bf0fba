#include "widgets/theme.h"

#include <QCoreApplication>
#include <QWidget>

namespace remount {
namespace {
struct Words {
  Q_DECLARE_TR_FUNCTIONS(remount::theme)
};
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

QColor state_color(PairState state, const QPalette& palette) {
  switch (state) {
    case PairState::Accepted:
      return good_color(palette);
    case PairState::Rejected:
      return is_dark(palette) ? QColor(0x8b, 0x90, 0x98) : QColor(0x80, 0x85, 0x8d);
    case PairState::Proposed:
      break;
  }
  return is_dark(palette) ? QColor(0x6c, 0xb0, 0xf5) : QColor(0x1f, 0x6f, 0xc4);
}

QString state_text(const Pair& pair) {
  const bool by_user = pair.decided_by == DecidedBy::User;
  switch (pair.state) {
    case PairState::Accepted:
      return by_user ? Words::tr("✓ accepted by you") : Words::tr("✓ accepted");
    case PairState::Rejected:
      return by_user ? Words::tr("✕ rejected by you") : Words::tr("✕ rejected");
    case PairState::Proposed:
      break;
  }
  return Words::tr("• proposed");
}

QColor severity_color(Severity severity, const QPalette& palette) {
  if (severity == Severity::Problem) return bad_color(palette);
  if (severity == Severity::Warning) return warning_color(palette);
  return palette.color(QPalette::WindowText);
}

QString severity_sign(Severity severity) {
  if (severity == Severity::Problem) return QStringLiteral("✕");
  if (severity == Severity::Warning) return QStringLiteral("▲");
  return QStringLiteral("•");
}

QColor tinted(const QColor& color, const QPalette& palette) {
  const QColor base = palette.color(QPalette::Base);
  constexpr double kShare = 0.16;
  const auto mix = [](int a, int b) { return static_cast<int>(a * kShare + b * (1.0 - kShare)); };
  return {mix(color.red(), base.red()), mix(color.green(), base.green()), mix(color.blue(), base.blue())};
}

void set_style(QWidget& widget, const QString& style_sheet) {
  if (widget.styleSheet() != style_sheet) widget.setStyleSheet(style_sheet);
}

}  // namespace remount
