#include "app/cli/batch_run.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <map>
#include <optional>
#include <thread>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "messages/command_line.h"
#include "messages/general.h"
#include "model/fleet/failed_job.h"
#include "model/fleet/job_warnings.h"
#include "model/formats/files/system_words.h"
#include "model/results/vehicle_file.h"

namespace remount::cli {
namespace {

using Clock = std::chrono::steady_clock;
using FileTime = std::filesystem::file_time_type;

std::vector<std::string> command_of(const fleet::Fleet& fleet, std::size_t job, int threads, Language language) {
  return {"remount-cli",
          "batch",
          fleet.path.string(),
          "--job",
          std::to_string(job + 1),
          "--quiet",
          "--threads",
          std::to_string(threads),
          "--log",
          fleet.jobs[job].log.string(),
          "--append-log",  // of a job that is done already, its calibration's log stays
          "--language",
          std::string(kLanguageTags[index_of(language)])};
}

/// In the child, between fork and exec: system calls alone.
[[noreturn]] void become(char* const* arguments, pid_t parent) {
  // Ctrl-C on the terminal is for the parent, which tells its children once: a second signal would end them at once.
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(kNoResult);
  const int nothing = ::open("/dev/null", O_RDWR);
  if (nothing >= 0)
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nothing, descriptor);
  ::execv("/proc/self/exe", arguments);
  ::_exit(kUnreadable);
}

pid_t start(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const pid_t parent = ::getpid(), child = ::fork();
  if (child == 0) become(arguments.data(), parent);
  if (child < 0) throw Error(ErrorCode::Io, command.front(), say::batch_no_process(formats::system_words(errno)));
  return child;
}

/// The processes that run, and what became of those that have ended.
class Jobs {
 public:
  Jobs(const fleet::Fleet& fleet, int threads, Console& console)
      : fleet_(fleet), threads_(threads), console_(console) {}
  ~Jobs() {
    stop();
    while (!running_.empty() && collect()) continue;
  }
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;

  std::size_t running() const { return running_.size(); }
  const BatchEnd& end() const { return end_; }

  void start_next(std::size_t job) {
    try {
      fleet::make_job_folder(fleet_.jobs[job]);
      const std::optional<FileTime> before = modification_time(fleet_.jobs[job].result);
      running_[start(command_of(fleet_, job, threads_, console_.options().language))] = {job, Clock::now(), before};
    } catch (const Error& error) {
      console_.complain(say::of_file(fleet::title_of(fleet_, fleet_.jobs[job]), error.message()));
      ++told_;
      ++end_.unreadable;
    }
  }
  void stop() {
    if (!stopped_)
      for (const auto& [process, job] : running_) ::kill(process, SIGTERM);
    stopped_ = stopped_ || !running_.empty();
  }
  /// Waits a little for one that ends; false where none is left to wait for.
  bool collect() {
    int status = 0;
    const pid_t process = ::waitpid(-1, &status, WNOHANG);
    if (process < 0 && errno != EINTR) return false;
    if (process <= 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    else if (const auto found = running_.find(process); found != running_.end())
      tell(found->second, status), running_.erase(found);
    return true;
  }

 private:
  struct Running {
    std::size_t job = 0;
    Clock::time_point since;
    std::optional<FileTime> result_before;
  };

  static std::optional<FileTime> modification_time(const std::filesystem::path& file) {
    std::error_code none;
    const FileTime time = std::filesystem::last_write_time(file, none);
    return none ? std::nullopt : std::optional(time);
  }

  void tell(const Running& running, int status) {
    const fleet::FleetJob& job = fleet_.jobs[running.job];
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (code < 0) {
      const Message died = say::batch_process_died(WTERMSIG(status), ::strsignal(WTERMSIG(status)));
      if (!stopped_) fleet::note_failure(fleet_, job, died);  // a process that dies cannot say so itself
    }
    ++told_;
    const Duration took{std::chrono::duration<double>(Clock::now() - running.since).count()};
    const Message text = say::batch_job_ended(told_, fleet_.jobs.size(), running.job + 1, fleet::title_of(fleet_, job),
                                              outcome(running, code), took);
    code == kSolved ? console_.print(text) : console_.complain(text);
    if (stopped_) return;
    if (code == kNoResult) ++end_.no_result;
    if (code != kSolved && code != kNoResult) ++end_.unreadable;
  }

  Message outcome(const Running& running, int code) const {
    const fleet::FleetJob& job = fleet_.jobs[running.job];
    const bool kept = running.result_before && running.result_before == modification_time(job.result);
    if (code == kSolved) return with_warnings(kept ? say::batch_solved_before() : say::batch_solved(), job);
    if (stopped_) return say::batch_job_stopped();
    if (code == kNoResult && !job.lidars.empty()) {
      const Message without = say::batch_lidar_without_result(job.result.string());
      return kept ? say::batch_nothing_changed(without) : without;
    }
    if (code == kNoResult)
      return kept ? say::batch_no_result_before(job.result.string()) : say::batch_no_result(job.result.string());
    if (const Message why = fleet::failure_message(job); !why.empty()) return say::batch_failed(why);
    return say::batch_failed_with_code(code, job.log.string());
  }

  /// A job that is solved may have more to tell than that.
  static Message with_warnings(Message outcome, const fleet::FleetJob& job) {
    try {
      const fleet::JobWarnings warnings = fleet::warnings_in(results::load_any_result(job.result));
      if (warnings.count == 0) return outcome;
      std::vector<std::string> problems;
      for (const drive::Finding& problem : warnings.problems) problems.push_back(fleet::name_of_problem(problem));
      return problems.empty() ? say::batch_with_warnings(std::move(outcome), warnings.count)
                              : say::batch_with_problems(std::move(outcome), warnings.count, std::move(problems));
    } catch (const Error&) {
      return outcome;  // the table says why it cannot be read
    }
  }

  const fleet::Fleet& fleet_;
  int threads_ = 0;
  Console& console_;
  std::map<pid_t, Running> running_;
  std::size_t told_ = 0;
  bool stopped_ = false;
  BatchEnd end_;
};

}  // namespace

BatchEnd run_jobs(const fleet::Fleet& fleet, std::size_t at_once, int threads, Console& console) {
  Jobs jobs(fleet, threads, console);
  std::size_t next = 0;
  while (next < fleet.jobs.size() || jobs.running() > 0) {
    if (console.cancelled()) {
      jobs.stop();
      next = fleet.jobs.size();
    }
    while (next < fleet.jobs.size() && jobs.running() < at_once) jobs.start_next(next++);
    if (jobs.running() > 0 && !jobs.collect()) break;
  }
  BatchEnd end = jobs.end();
  end.cancelled = console.cancelled();
  return end;
}

}  // namespace remount::cli
