#include "app/gui/workbench/activity.h"

#include <utility>

namespace remount::gui {

Activity::Activity(JobRunner& jobs) : jobs_(jobs) {
  connect(&jobs_, &JobRunner::progressed, this, &Activity::take_progress);
  connect(&jobs_, &JobRunner::finished, this, &Activity::take_end);
}

void Activity::start(Kind kind, JobRunner::Work work, JobRunner::Failed failed) {
  if (kind == Kind::Calibrating) stage_ = so_far_ = {};
  Entry& started = entry(kind);
  ++started.turn;
  started.job = jobs_.start(std::move(work), std::move(failed));
  emit changed();
}

void Activity::cancel(Kind kind) { jobs_.cancel(entry(kind).job); }

void Activity::drop(Kind kind) {
  cancel(kind);
  entry(kind).job = 0;
  ++entry(kind).turn;
}

void Activity::take_so_far(const Message& x) {
  so_far_ = x;
  emit changed();
}

void Activity::take_progress(int job, const Message& stage, qulonglong done, qulonglong total) {
  const bool of_run = job == entry(Kind::Calibrating).job;
  if (of_run && stage != stage_) {
    stage_ = stage;
    emit changed();
  }
  if (of_run || job == entry(Kind::Opening).job) emit progressed(stage, done, total);
}

void Activity::take_end(int job) {
  emit changed();
  if (job == entry(Kind::Opening).job && !opening()) emit opening_ended();
}

}  // namespace remount::gui
