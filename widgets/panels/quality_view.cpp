#include "widgets/panels/quality_view.h"

#include "widgets/panels/clearance_view.h"
#include "widgets/panels/hold_out_view.h"
#include "widgets/panels/sharpness_view.h"

namespace remount {

QualityView::QualityView(QWidget* parent)
    : QTabWidget(parent), obstacles_(new ClearanceView), sharpness_(new SharpnessView), hold_out_(new HoldOutView) {
  setDocumentMode(true);
  addTab(obstacles_, tr("Obstacles"));
  addTab(sharpness_, tr("Map sharpness"));
  addTab(hold_out_, tr("Session against session"));
  connect(this, &QTabWidget::currentChanged, this, &QualityView::looked_at);
}

void QualityView::set_on_top(bool on_top) {
  on_top_ = on_top;
  if (seen()) emit looked_at();
}

void QualityView::showEvent(QShowEvent* event) {
  QTabWidget::showEvent(event);
  emit looked_at();
}

}  // namespace remount
