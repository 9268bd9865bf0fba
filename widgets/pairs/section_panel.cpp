#include "widgets/pairs/section_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace remount::widgets {

SectionPanel::SectionPanel(QWidget* parent)
    : QWidget(parent),
      kind_(new QComboBox(this)),
      next_(new QToolButton(this)),
      place_(new QLabel(this)),
      plot_(new SectionPlot(this)) {
  kind_->addItems({tr("Wall"), tr("Ground"), tr("Pole")});
  kind_->setAccessibleName(tr("Surface that is cut"));
  kind_->setToolTip(tr("Walls show sideways errors and yaw, the ground height, roll and pitch, poles both level axes"));
  connect(kind_, &QComboBox::currentIndexChanged, this, [this] { emit kind_chosen(kind()); });
  next_->setText(tr("Next place"));
  next_->setToolTip(tr("The next of the surfaces that both scans see well"));
  connect(next_, &QToolButton::clicked, this, &SectionPanel::next_clicked);
  connect(plot_, &SectionPlot::moved, this, &SectionPanel::moved);
  place_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // the panel may be narrower than its words
  auto* row = new QHBoxLayout;
  row->addWidget(kind_);
  row->addWidget(next_);
  row->addWidget(place_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 4, 6, 4);
  column->addLayout(row);
  column->addWidget(plot_, 1);
  show_message(tr("Select a pair to see a section through its two scans."));
}

quality::SectionKind SectionPanel::kind() const { return static_cast<quality::SectionKind>(kind_->currentIndex()); }

void SectionPanel::show_section(const quality::Section& section, std::vector<ShownCut> cuts,
                                std::optional<std::size_t> place, std::size_t places) {
  next_->setEnabled(places > 1 || (places == 1 && !place));
  const double distance_m = section.centre_in_lidar_b.norm();
  place_->setText(place
                      ? tr("place %1 of %2, %3 m from the LiDAR").arg(*place + 1).arg(places).arg(distance_m, 0, 'f', 1)
                      : tr("chosen place, %1 m from the LiDAR").arg(distance_m, 0, 'f', 1));
  plot_->show_cuts(section, std::move(cuts));
}

void SectionPanel::show_message(const QString& text) {
  next_->setEnabled(false);
  place_->clear();
  plot_->show_message(text);
}

}  // namespace remount::widgets
