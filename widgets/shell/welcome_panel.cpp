#include "widgets/shell/welcome_panel.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace remount::widgets {

WelcomePanel::WelcomePanel(QWidget* parent)
    : QWidget(parent),
      text_(new QLabel(this)),
      open_(new QPushButton(tr("Open"), this)),
      sample_(new QPushButton(tr("Open the sample session"), this)),
      recent_title_(new QLabel(tr("<b>Opened lately</b>"), this)),
      recent_(new QVBoxLayout) {
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::RichText);
  text_->setText(
      tr("<h2>Where does the LiDAR sit now?</h2>"
         "<p>Drop the folder or the file of a recorded drive here, or open one. A drive holds LiDAR scans (or LiDAR "
         "poses) and the log of the GNSS/INS. Several drives of one vehicle are calibrated together.</p>"
         "<ol><li>Open the sessions.</li><li>Say roughly where the LiDAR sits, or leave it unknown.</li>"
         "<li>Calibrate (F5).</li><li>Look at the pairs; accept or reject the doubtful ones.</li>"
         "<li>Export the result.</li></ol>"));
  text_->setMaximumWidth(520);
  open_->setDefault(true);
  connect(sample_, &QPushButton::clicked, this, &WelcomePanel::sample_requested);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(open_);
  buttons->addWidget(sample_);
  buttons->addStretch();
  auto* column = new QVBoxLayout;
  column->addStretch(2);
  column->addWidget(text_);
  column->addLayout(buttons);
  column->addSpacing(8);
  column->addWidget(recent_title_);
  recent_->setSpacing(0);
  column->addLayout(recent_);
  column->addStretch(3);
  auto* row = new QHBoxLayout(this);
  row->addStretch();
  row->addLayout(column, 10);
  row->addStretch();
  show_recent({}, {});
}

void WelcomePanel::set_open_menu(QMenu& menu) { open_->setMenu(&menu); }

void WelcomePanel::show_recent(const QStringList& paths, const QStringList& labels) {
  constexpr qsizetype kShown = 5;
  while (QLayoutItem* item = recent_->takeAt(0)) {
    item->widget()->deleteLater();
    delete item;
  }
  for (qsizetype i = 0; i < std::min(kShown, paths.size()); ++i) {
    auto* open = new QPushButton(this);
    open->setText(fontMetrics().elidedText(labels.at(i), Qt::ElideMiddle, text_->maximumWidth()).replace('&', "&&"));
    open->setFlat(true);
    open->setStyleSheet(QStringLiteral("text-align: left; padding: 2px 4px"));
    open->setToolTip(paths.at(i));
    open->setAccessibleName(tr("Open %1").arg(labels.at(i)));
    connect(open, &QPushButton::clicked, this, [this, path = paths.at(i)] { emit recent_requested(path); });
    recent_->addWidget(open, 0, Qt::AlignLeft);
  }
  recent_title_->setVisible(!paths.isEmpty());
}

void WelcomePanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  // A layout that is short of space would cut the last lines off; the page scrolls instead.
  text_->setMinimumHeight(text_->heightForWidth(text_->width()));
}

void WelcomePanel::set_sample_available(bool available) { sample_->setVisible(available); }

}  // namespace remount::widgets
