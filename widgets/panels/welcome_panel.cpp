#include "widgets/panels/welcome_panel.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace remount {

WelcomePanel::WelcomePanel(QWidget* parent)
    : QWidget(parent), text_(new QLabel(this)), sample_(new QPushButton(tr("Open the sample session"), this)) {
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::RichText);
  text_->setText(
      tr("<h2>Where does the LiDAR sit now?</h2>"
         "<p>Drop the folder of a recorded drive here, or open one. A drive holds LiDAR scans (or LiDAR poses) and the "
         "log of the GNSS/INS. Several drives of one vehicle are calibrated together.</p>"
         "<ol><li>Open the sessions.</li><li>Say roughly where the LiDAR sits, or leave it unknown.</li>"
         "<li>Calibrate (F5).</li><li>Look at the pairs; accept or reject the doubtful ones.</li>"
         "<li>Export the result.</li></ol>"));
  text_->setMaximumWidth(520);
  auto* open = new QPushButton(tr("Open session…"), this);
  open->setDefault(true);
  connect(open, &QPushButton::clicked, this, &WelcomePanel::open_requested);
  connect(sample_, &QPushButton::clicked, this, &WelcomePanel::sample_requested);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(open);
  buttons->addWidget(sample_);
  buttons->addStretch();
  auto* column = new QVBoxLayout;
  column->addStretch(2);
  column->addWidget(text_);
  column->addLayout(buttons);
  column->addStretch(3);
  auto* row = new QHBoxLayout(this);
  row->addStretch();
  row->addLayout(column, 10);
  row->addStretch();
}

void WelcomePanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  // A layout that is short of space would cut the last lines off; the page scrolls instead.
  text_->setMinimumHeight(text_->heightForWidth(text_->width()));
}

void WelcomePanel::set_sample_available(bool available) { sample_->setVisible(available); }

}  // namespace remount
