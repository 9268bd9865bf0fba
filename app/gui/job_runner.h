// Long work off the UI thread. Values cross threads, widgets never do, and the UI thread never waits.
#pragma once

#include <QObject>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <thread>

#include "algorithms/core/progress.h"

namespace remount {

struct JobFailure {
  QString where, what;
};

class JobRunner : public QObject {
  Q_OBJECT
 public:
  using Deliver = std::function<void()>;                  ///< runs on the UI thread
  using Work = std::function<Deliver(Progress&)>;         ///< runs on a worker with copies of what it needs
  using Failed = std::function<void(const JobFailure&)>;  ///< runs on the UI thread

  using QObject::QObject;
  /// Asks every job to stop and waits for them; the window is closed by then.
  ~JobRunner() override;

  /// Starts at once and returns the job's number. Exceptions of `work` end here and reach `failed`.
  int start(Work work, Failed failed);
  void cancel(int job);  ///< asks; the job ends when it notices
  void cancel_all();
  bool running(int job) const { return jobs_.contains(job); }

 signals:
  void progressed(int job, const QString& stage, qulonglong done, qulonglong total);
  void finished(int job);

 private:
  void run(int job, std::stop_token stop, const Work& work, const Failed& failed);
  std::map<int, std::jthread> jobs_;
  std::deque<std::jthread> ending_;  // have delivered; not joined yet
  int next_ = 1;
};

}  // namespace remount
