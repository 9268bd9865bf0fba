#include "widgets/panels/message_banner.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "widgets/theme.h"

namespace remount {

MessageBanner::MessageBanner(QWidget* parent) : QFrame(parent), text_(new QLabel(this)) {
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  text_->setAccessibleName(tr("Message"));
  auto* close = new QToolButton(this);
  close->setText(QStringLiteral("✕"));
  close->setAutoRaise(true);
  close->setAccessibleName(tr("Dismiss the message"));
  close->setToolTip(tr("Dismiss"));
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 6, 6, 6);
  layout->addWidget(text_, 1);
  layout->addWidget(close, 0, Qt::AlignTop);
  hide();
}

void MessageBanner::show_message(Severity severity, const QString& where, const QString& what) {
  const QColor color = severity_color(severity, palette());
  setStyleSheet(QStringLiteral("remount--MessageBanner { background: %1; border-left: 4px solid %2; }")
                    .arg(tinted(color, palette()).name(), color.name()));
  QString text = severity_sign(severity) + QStringLiteral("  ");
  if (!where.isEmpty()) text += where + '\n';
  text_->setText(text + what);
  show();
}

}  // namespace remount
