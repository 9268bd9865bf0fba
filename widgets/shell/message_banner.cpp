#include "widgets/shell/message_banner.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <algorithm>

#include "widgets/basics/theme.h"

namespace remount::widgets {

MessageBanner::MessageBanner(QWidget* parent)
    : QFrame(parent), text_(new QLabel), scroll_(new QScrollArea(this)), offer_(new QPushButton(this)) {
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  text_->setAccessibleName(tr("Message"));
  text_->setAlignment(Qt::AlignTop);
  scroll_->setWidget(text_);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setMinimumHeight(2 * fontMetrics().lineSpacing());  // where the window is low, the rest scrolls
  scroll_->setMaximumHeight(scroll_->minimumHeight());         // until it is shown
  scroll_->viewport()->setAutoFillBackground(false);
  text_->setAutoFillBackground(false);
  auto* close = new QToolButton(this);
  close->setText(QStringLiteral("✕"));
  close->setAutoRaise(true);
  close->setAccessibleName(tr("Dismiss the message"));
  close->setToolTip(tr("Dismiss"));
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 6, 6, 6);
  layout->addWidget(scroll_, 1);
  layout->addWidget(offer_, 0, Qt::AlignTop);
  layout->addWidget(close, 0, Qt::AlignTop);
  offer_->hide();
  connect(offer_, &QPushButton::clicked, this, [this] {
    const std::function<void()> act = act_;
    hide();
    if (act) act();
  });
  hide();
}

void MessageBanner::offer(const QString& label, const std::function<void()>& act) {
  act_ = act;
  offer_->setText(label);
  offer_->show();
  fit_height();
}

void MessageBanner::show_message(drive::Severity severity, const QString& where, const QString& what) {
  set_style(*this, [severity](const QPalette& palette) {
    const QColor color = severity_color(severity, palette);
    return QStringLiteral("remount--widgets--MessageBanner { background: %1; border-left: 4px solid %2; }")
        .arg(tint(color, palette).name(), color.name());
  });
  QString text = severity_sign(severity) + QStringLiteral("  ");
  if (!where.isEmpty()) text += where + '\n';
  text_->setText(text + what);
  act_ = {};
  offer_->hide();
  show();
  scroll_->verticalScrollBar()->setValue(0);
  fit_height();
}

// As high as the whole message, up to a few lines and a third of the window; beyond them it scrolls.
void MessageBanner::fit_height() {
  constexpr int kMostLines = 9;
  const int width = scroll_->viewport()->width();
  const int wanted = text_->heightForWidth(width) + 2;
  const int most = std::min(kMostLines * text_->fontMetrics().lineSpacing(), window()->height() / 3);
  scroll_->setMaximumHeight(std::max(scroll_->minimumHeight(), std::min(wanted, most)));
}

void MessageBanner::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  fit_height();
}

}  // namespace remount::widgets
