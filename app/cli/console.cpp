#include "app/cli/console.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "algorithms/messages/catalogue.h"
#include "messages/command_line.h"
#include "messages/general.h"
#include "model/checks/data_check.h"
#include "model/formats/files/atomic_save.h"
#include "model/formats/files/printable_text.h"
#include "model/formats/files/regular_file.h"
#include "model/formats/files/system_words.h"
#include "remount_version.h"

namespace remount::cli {
namespace {

using Clock = std::chrono::steady_clock;

double seconds(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

/// Fine enough to be seen to count down.
Message duration_left(double duration_s) {
  const int tens = static_cast<int>(duration_s / 10.0);
  return duration_s < 90.0 ? say::cli_seconds(Duration{duration_s})
                           : say::cli_minutes_seconds(Duration{60.0 * (tens / 6)}, Duration{10.0 * (tens % 6)});
}

sigset_t stop_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

/// Waits for Ctrl-C in a thread of its own: nothing has to be done within a signal handler. The first one asks for a
/// stop, and what was finished is kept; another ends the program, but not one that comes with the first: timeout(1),
/// and shells with job control, signal the process and its group.
void watch_signals(const std::stop_token& done, std::stop_source& stop) {
  constexpr std::chrono::seconds kOneWish{1};
  const sigset_t set = stop_signals();
  const timespec wait{0, 100'000'000};
  Clock::time_point asked;
  while (!done.stop_requested()) {
    if (::sigtimedwait(&set, nullptr, &wait) < 0) continue;
    if (!stop.stop_requested())
      asked = Clock::now();
    else if (Clock::now() - asked > kOneWish)
      ::_exit(kNoResult);
    stop.request_stop();
  }
}

/// Opening a FIFO that nobody reads would wait for a reader. Keeps one that is read open meanwhile: the reader would
/// take the end of this look for the end of the log. Throws Error(Io).
formats::FileDescriptor look_for_reader(const std::filesystem::path& path) {
  std::error_code missing;  // which opening tells of
  if (!std::filesystem::is_fifo(path, missing)) return {};
  formats::FileDescriptor reader(::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC));
  if (reader.get() < 0) throw Error(ErrorCode::Io, path.string(), say::cli_log_fifo());
  return reader;
}

}  // namespace

Console::Console()
    : terminal_(::isatty(STDERR_FILENO) == 1),
      started_(Clock::now()),
      stage_started_(started_),
      progress_(stop_.get_token(), [this](const ProgressUpdate& update) { show(update); }) {
  const sigset_t set = stop_signals();
  ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
  signals_ = std::jthread([this](const std::stop_token& done) { watch_signals(done, stop_); });
}

Console::~Console() { clear_line(); }

double Console::elapsed_s() const { return seconds(Clock::now() - started_); }

void Console::start(const std::string& command_line) {
  if (options_.log_file.empty()) return;
  const formats::FileDescriptor reader = look_for_reader(options_.log_file);
  formats::check_replaces_its_like(options_.log_file, "remount-cli ");
  log_.open(options_.log_file, options_.append_log ? std::ios::app : std::ios::trunc);
  if (!log_) throw Error(ErrorCode::Io, options_.log_file, say::cli_log_not_written(formats::system_words(errno)));
  log("remount-cli " + std::string(kVersion) + "\n" + command_line);
}

void Console::log(std::string_view text) {
  if (!log_.is_open()) return;
  char stamp[32];
  std::snprintf(stamp, sizeof(stamp), "[%9.3f] ", elapsed_s());
  errno = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    log_ << stamp << formats::printable(text.substr(0, end)) << "\n";
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  if (log_.flush()) return;
  lose(log_lost_, say::cli_log_lost(options_.log_file));
  log_.close();
}

void Console::lose(bool& lost, const Message& what) {
  const int reason = errno;
  if (lost) return;
  lost = true;
  clear_line();
  const Message told = reason != 0 ? say::cli_because(what, formats::system_words(reason)) : what;
  std::fprintf(stderr, "remount-cli: %s\n", formats::printable(words(told)).c_str());
}

int Console::end(int code) const { return (output_lost_ || log_lost_) && code == kSolved ? kUnreadable : code; }

void Console::clear_line() {
  if (line_shown_) std::fputs("\r\033[K", stderr);
  line_shown_ = false;
}

void Console::show(const ProgressUpdate& update) {
  const std::scoped_lock lock(mutex_);
  const Clock::time_point now = Clock::now();
  // A stage may come twice in a row; workers report a little out of order, but never half a stage.
  const bool new_stage = update.stage != stage_ || update.done < last_done_ / 2;
  last_done_ = update.done;
  if (new_stage) {
    stage_ = update.stage;
    stage_started_ = now;
    remaining_ = {};
    log(words(stage_()));
  }
  if (!terminal_ || options_.quiet) return;
  if (!new_stage && seconds(now - shown_) < 0.1 && update.done != update.total) return;
  shown_ = now;
  std::string line = formats::printable(words(stage_()), formats::LineBreaks::Escaped);
  if (update.total > 0) {
    line.append(" ").append(std::to_string(update.done)).append("/").append(std::to_string(update.total));
    const auto left_s = remaining_.left_s(seconds(now - stage_started_), static_cast<double>(update.done),
                                          static_cast<double>(update.total));
    if (left_s) line = words(say::cli_left(line, duration_left(*left_s)));
  }
  clear_line();
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  line_shown_ = true;
}

int exit_code_of(const Error& error) { return error.code() == ErrorCode::Contract ? kUsage : kUnreadable; }

void Console::print(const Message& message) { print_text(words(message)); }

void Console::print_text(const std::string& text) {
  const std::scoped_lock lock(mutex_);
  clear_line();
  log(text);
  if (options_.quiet) return;
  write(text);
  if (!text.ends_with('\n')) write("\n");
}

void Console::deliver(std::string_view text) {
  const std::scoped_lock lock(mutex_);
  clear_line();
  write(text);
}

void Console::write(std::string_view text) {
  const std::string shown = formats::printable(text);
  errno = 0;
  std::fwrite(shown.data(), 1, shown.size(), stdout);
  if (std::fflush(stdout) != 0 || std::ferror(stdout)) lose(output_lost_, say::cli_output_lost());
}

void Console::complain(const Message& message) {
  const std::string text = words(message);
  const std::scoped_lock lock(mutex_);
  clear_line();
  log(text);
  std::fprintf(stderr, "remount-cli: %s\n", formats::printable(text).c_str());
}

void Console::complain(const Error& error) {
  const std::string where = formats::printable(error.where(), formats::LineBreaks::Escaped);
  complain(where.empty() ? error.what_happened() : say::of_file(where, error.what_happened()));
}

void Console::warn(const Message& message) { complain(say::cli_warning(message)); }

void Console::report(const std::vector<drive::Finding>& findings) {
  for (const drive::Finding& finding : findings) {
    const checks::FindingKind* kind = checks::finding_kind(finding.code);
    const std::string where = formats::printable(words(finding.where.words()), formats::LineBreaks::Escaped);
    const Message told = kind && !advises(finding.explanation)
                             ? say::cli_finding_with_remedy(where, finding.explanation, finding.code, kind->remedy())
                             : say::cli_finding(where, finding.explanation, finding.code);
    const bool note = finding.severity == drive::Severity::Note;
    const std::string text = words(note                                           ? say::cli_note(told)
                                   : finding.severity == drive::Severity::Problem ? say::cli_problem(told)
                                                                                  : say::cli_warning(told));
    const std::scoped_lock lock(mutex_);
    clear_line();
    log(text);
    if (!note && !options_.quiet) std::fprintf(stderr, "%s\n", formats::printable(text).c_str());
  }
}

}  // namespace remount::cli
