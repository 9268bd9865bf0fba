#include "app/gui/jobs/job_runner.h"

#include <QElapsedTimer>
#include <QTimer>

#include "app/gui/jobs/error_words.h"
#ifdef Q_OS_LINUX
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace remount::gui {
namespace {
constexpr int kUntilEnded_ms = 3000;
constexpr qint64 kReportInterval_ms = 50;  // a fast stage reports thousands of times a second

/// Runs `work` and turns every exception into a failure.
JobRunner::Deliver guard(const JobRunner::Work& work, const JobRunner::Failed& failed, Progress& progress) {
  JobFailure failure;
  try {
    return work(progress);
  } catch (const std::exception& error) {
    failure = failure_of(error);
  }
  return [failed, failure] { failed(failure); };
}

/// Where work takes every core, the window would wait for its turn like one more worker: this thread, and those that it
/// starts, step back.
void yield_to_the_window() {
#ifdef Q_OS_LINUX
  constexpr int kNice = 10;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);
#endif
}

}  // namespace

JobRunner::~JobRunner() {
  cancel_all();
  jobs_.clear();  // joins
  ending_.clear();
}

int JobRunner::start(Work work, Failed failed) {
  const int job = next_++;
  jobs_.emplace(job, std::jthread([this, job, work = std::move(work), failed = std::move(failed)](
                                      std::stop_token stop) { run(job, std::move(stop), work, failed); }));
  return job;
}

void JobRunner::run(int job, std::stop_token stop, const Work& work, const Failed& failed) {
  yield_to_the_window();
  QElapsedTimer since_report;
  Stage last_stage = nullptr;
  Progress progress(std::move(stop), [&](const ProgressUpdate& update) {
    if (update.stage == last_stage && since_report.isValid() && since_report.elapsed() < kReportInterval_ms) return;
    last_stage = update.stage;
    since_report.start();
    const qulonglong done = update.done, total = update.total;
    post([this, job, stage = update.stage(), done, total] { emit progressed(job, stage, done, total); });
  });
  Deliver deliver = guard(work, failed, progress);
  post([this, job, deliver = std::move(deliver)] {
    // The thread has delivered and ends by itself; on a busy machine that takes its time, and joining it now would
    // stall this one.
    ending_.push_back(std::move(jobs_.extract(job).mapped()));
    QTimer::singleShot(kUntilEnded_ms, this, [this] { ending_.pop_front(); });
    if (deliver) deliver();
    emit finished(job);
  });
}

void JobRunner::post(Deliver deliver) {
  {
    const std::scoped_lock guard(mutex_);
    posted_.push_back(std::move(deliver));
  }
  QMetaObject::invokeMethod(this, &JobRunner::take_posted, Qt::QueuedConnection);
}

void JobRunner::take_posted() {
  Deliver deliver;
  {
    const std::scoped_lock guard(mutex_);
    deliver = std::move(posted_.front());
    posted_.pop_front();
  }
  deliver();
}

void JobRunner::cancel(int job) {
  const auto found = jobs_.find(job);
  if (found != jobs_.end()) found->second.request_stop();
}

void JobRunner::cancel_all() {
  for (auto& [job, thread] : jobs_) thread.request_stop();
}

}  // namespace remount::gui
