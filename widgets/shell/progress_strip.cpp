#include "widgets/shell/progress_strip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QTimer>
#include <QToolButton>
#include <algorithm>

#include "widgets/basics/busy_bar.h"
#include "widgets/text/model_text.h"

namespace remount::widgets {
namespace {
constexpr int kBarSteps = 1000;  // of the bar
}  // namespace

QString remaining_text(double left_s) {
  if (left_s < 90.0)
    return ProgressStrip::tr("about %1 s left in this step").arg(std::max(1, static_cast<int>(left_s + 0.5)));
  const int tens = static_cast<int>(left_s / 10.0);
  return ProgressStrip::tr("about %1 min %2 s left in this step").arg(tens / 6).arg(10 * (tens % 6));
}

QString elapsed_text(qint64 elapsed_ms) {
  const int seconds = static_cast<int>(elapsed_ms / 1000);
  return seconds < 60 ? ProgressStrip::tr("%1 s").arg(seconds)
                      : ProgressStrip::tr("%1 min %2 s").arg(seconds / 60).arg(seconds % 60);
}

ProgressStrip::ProgressStrip(QWidget* parent)
    : QWidget(parent),
      text_(new QLabel(this)),
      elapsed_(new QLabel(this)),
      bar_(new BusyBar(this)),
      cancel_(new QToolButton(this)),
      second_(new QTimer(this)) {
  bar_->setMaximumWidth(220);
  bar_->setTextVisible(false);
  bar_->setAccessibleName(tr("Progress"));
  cancel_->setText(tr("Cancel"));
  cancel_->setToolTip(tr("Stop (Esc); what was there before is kept"));
  text_->setAccessibleName(tr("Present work"));
  text_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // a long path does not widen the window
  connect(cancel_, &QToolButton::clicked, this, &ProgressStrip::cancel_clicked);
  second_->setInterval(1000);
  second_->setTimerType(Qt::PreciseTimer);  // others come early, and "1 s" is left out
  connect(second_, &QTimer::timeout, this, &ProgressStrip::tick);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 0, 0, 0);
  elapsed_->setAccessibleName(tr("Time that the present step has taken"));
  layout->addWidget(text_, 1);
  layout->addWidget(elapsed_);
  layout->addWidget(bar_);
  layout->addWidget(cancel_);
  setMinimumHeight(cancel_->sizeHint().height());  // the window does not jump when it appears
  stop(tr("Ready"));
}

void ProgressStrip::start(const QString& what) {
  stage_ = {};
  total_ = 0;
  since_stage_.start();
  text_->setText(what);
  bar_->setRange(0, 0);
  bar_->show();
  cancel_->show();
  cancel_->setEnabled(true);
  tick();
  second_->start();
}

void ProgressStrip::wait(const QString& what, const QElapsedTimer& since) {
  stage_ = {};
  total_ = 0;
  since_stage_ = since;
  text_->setText(what);
  bar_->setRange(0, 0);
  cancel_->hide();
  tick();
  second_->start();
}

void ProgressStrip::tick() {
  constexpr qint64 kSoon_ms = 1000;  // what is done by then flashes nothing
  const qint64 taken_ms = since_stage_.elapsed();
  if (!stage_.empty()) say();
  if (total_ > 0)
    bar_->setValue(
        static_cast<int>(kBarSteps * std::min(1.0, static_cast<double>(done_) / static_cast<double>(total_))));
  if (cancel_->isHidden()) bar_->setVisible(taken_ms >= kSoon_ms);
  elapsed_->setText(elapsed_text(taken_ms));
  elapsed_->setVisible(total_ == 0 && taken_ms >= kSoon_ms);
}

void ProgressStrip::show_progress(const Message& stage, qulonglong done, qulonglong total) {
  if (!cancel_->isVisibleTo(this) || !cancel_->isEnabled()) return;
  constexpr qint64 kOften_ms = 200;  // what changes more often nobody reads, and each change makes the window anew
  const bool again = stage == stage_ && total == total_ && done < total && since_shown_.isValid();
  if (again && since_shown_.elapsed() < kOften_ms) {
    done_ = done;
    return;
  }
  since_shown_.start();
  if (stage != stage_) {
    stage_ = stage;
    since_stage_.start();
    remaining_ = {};
    done_at_start_ = done;
  }
  done_ = done;
  total_ = total;
  bar_->setRange(0, total > 0 ? kBarSteps : 0);
  tick();
  second_->start();
}

void ProgressStrip::say() {
  QString text = total_ > 0 ? tr("%1: %2 of %3").arg(model_text(stage_)).arg(done_).arg(total_) : model_text(stage_);
  const auto covered = [this](qulonglong count) {
    return static_cast<double>(count) - static_cast<double>(done_at_start_);
  };
  const auto left_s =
      remaining_.left_s(1e-3 * static_cast<double>(since_stage_.elapsed()), covered(done_), covered(total_));
  if (left_s) text += QStringLiteral(", ") + remaining_text(*left_s);
  text_->setText(text);
}

void ProgressStrip::show_cancelling() {
  second_->stop();
  cancel_->setEnabled(false);
  text_->setText(tr("Cancelling…"));
}

void ProgressStrip::stop(const QString& what) {
  second_->stop();
  text_->setText(what);
  elapsed_->hide();
  bar_->hide();
  cancel_->hide();
}

}  // namespace remount::widgets
