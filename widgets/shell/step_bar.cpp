#include "widgets/shell/step_bar.h"

#include <QHBoxLayout>
#include <QToolButton>

#include "widgets/basics/theme.h"

namespace remount::widgets {
namespace {
QColor highlight(const QPalette& palette) { return palette.color(QPalette::Highlight); }
}  // namespace

StepBar::StepBar(QWidget* parent) : QWidget(parent) {
  const std::array<QString, kStepCount> help{
      tr("Open the recorded sessions of one vehicle"), tr("Choose scans and pair those that see the same objects"),
      tr("Align the two scans of every pair"),         tr("Look at the pairs and decide on doubtful ones"),
      tr("The mounting that explains the pairs"),      tr("See by other means than residuals that it is right"),
      tr("Write the result for other software")};
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  layout->setSpacing(4);
  for (std::size_t i = 0; i < kStepCount; ++i) {
    buttons_[i] = new QToolButton(this);
    helps_[i] = help[i];
    // Their texts are cut where the window is narrow, rather than it being made wider.
    buttons_[i]->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    buttons_[i]->setMinimumWidth(60);
    connect(buttons_[i], &QToolButton::clicked, this, [this, i] { emit step_clicked(static_cast<Step>(i)); });
    layout->addWidget(buttons_[i], 1);
  }
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  show_steps({});
}

void StepBar::show_steps(const std::array<StepInfo, kStepCount>& steps) {
  steps_ = steps;
  restyle();
}

void StepBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  restyle();
}

void StepBar::restyle() {
  const std::array<QString, kStepCount> titles{tr("Load"),  tr("Pairs"), tr("Align"), tr("Review"),
                                               tr("Solve"), tr("Check"), tr("Export")};
  for (std::size_t i = 0; i < kStepCount; ++i) {
    const StepInfo& step = steps_[i];
    QColor (*color)(const QPalette&) = faded_color;
    QString sign = QString::number(i + 1), state = tr("waiting");
    switch (step.state) {
      case StepState::Waiting:
        break;
      case StepState::Next:
        color = highlight, state = tr("next");
        break;
      case StepState::Running:
        color = highlight, sign = QStringLiteral("…"), state = tr("running");
        break;
      case StepState::Done:
        color = good_color, sign = QStringLiteral("✓"), state = tr("done");
        break;
      case StepState::Attention:
        color = warning_color, sign = QStringLiteral("▲"), state = tr("needs attention");
        break;
    }
    const QString detail = step.detail.isEmpty() ? state : step.detail;
    constexpr int kPadding_px = 14;
    const auto fitting = [&, width = buttons_[i]->width() - kPadding_px](const QString& text) {
      return buttons_[i]->fontMetrics().elidedText(text, Qt::ElideRight, width);
    };
    buttons_[i]->setText(fitting(sign + QStringLiteral("  ") + titles[i]) + '\n' + fitting(detail));
    buttons_[i]->setToolTip(helps_[i] + '\n' + detail);
    buttons_[i]->setAccessibleName(tr("Step %1: %2, %3").arg(titles[i], state, detail));
    const bool plain = step.state == StepState::Waiting;
    set_style(*buttons_[i], [color, plain](const QPalette& palette) {
      const QColor edge = color(palette);
      return QStringLiteral(
                 "QToolButton { border: none; border-bottom: 3px solid %1; padding: 4px 6px; background: %2; "
                 "color: %3; } QToolButton:hover, QToolButton:focus { background: %4; }")
          .arg(edge.name(), plain ? QStringLiteral("transparent") : tint(edge, palette).name(),
               (plain ? edge : palette.color(QPalette::WindowText)).name(),
               palette.color(QPalette::Button).darker(is_dark(palette) ? 80 : 106).name());
    });
  }
}

}  // namespace remount::widgets
