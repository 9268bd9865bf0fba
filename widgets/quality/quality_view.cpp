#include "widgets/quality/quality_view.h"

#include <QCheckBox>
#include <QSignalBlocker>

#include "widgets/quality/clearance_view.h"
#include "widgets/quality/sharpness_view.h"
#include "widgets/result/hold_out_view.h"
#include "widgets/result/sigma_budget_view.h"
#include "widgets/text/readable.h"

namespace remount::widgets {

QualityView::QualityView(QWidget* parent)
    : QTabWidget(parent),
      obstacles_(new ClearanceView),
      sharpness_(new SharpnessView),
      hold_out_(new HoldOutView),
      sigmas_(new SigmaBudgetView),
      confirm_(new QCheckBox(tr("Result confirmed"), this)) {
  setDocumentMode(true);
  addTab(obstacles_, tr("Obstacles"));
  addTab(sharpness_, tr("Map sharpness"));
  addTab(hold_out_, tr("Session against session"));
  addTab(sigmas_, tr("What sigma is made of"));
  confirm_->setToolTip(
      tr("For you to tick when these pages have convinced you. The step \"Check\" is done then; another result is "
         "unconfirmed again."));
  connect(confirm_, &QCheckBox::toggled, this, &QualityView::confirmed);
  keep_box_visible(*confirm_);
  setCornerWidget(confirm_);
  show_confirmed(false, false);
  connect(this, &QTabWidget::currentChanged, this, &QualityView::looked_at);
}

void QualityView::show_confirmed(bool confirmed, bool possible) {
  const QSignalBlocker quiet(confirm_);
  confirm_->setChecked(confirmed);
  confirm_->setEnabled(possible);
}

void QualityView::set_on_top(bool on_top) {
  on_top_ = on_top;
  if (seen()) emit looked_at();
}

void QualityView::showEvent(QShowEvent* event) {
  QTabWidget::showEvent(event);
  emit looked_at();
}

}  // namespace remount::widgets
