// Long work off the UI thread. Values cross threads, widgets never do, and the UI thread never waits.
#pragma once

#include <QObject>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

#include "algorithms/core/progress.h"

namespace remount::gui {

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
  /// From any thread: what is posted runs on the UI thread, in order, each in a turn of its own.
  void post(Deliver deliver);

 signals:
  void progressed(int job, const Message& stage, qulonglong done, qulonglong total);
  void finished(int job);

 private:
  void run(int job, std::stop_token stop, const Work& work, const Failed& failed);
  void take_posted();
  std::map<int, std::jthread> jobs_;
  std::deque<std::jthread> ending_;  // have delivered; not joined yet
  int next_ = 1;
  // Not left to Qt's own queue: how that locks, a tool that looks for data races does not see, and would have to be
  // told to overlook all that the UI thread does.
  std::mutex mutex_;
  std::deque<Deliver> posted_;
};

}  // namespace remount::gui
