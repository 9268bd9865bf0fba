// The terminal, the log file and Ctrl-C of a run on the command line.
#pragma once

#include <chrono>
#include <fstream>
#include <functional>
#include <mutex>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "algorithms/core/error.h"
#include "algorithms/core/progress.h"
#include "algorithms/core/remaining_time.h"
#include "model/drive/session.h"

namespace remount::cli {

/// What every verb may end with; docs/manual/command-line.md explains them to users.
enum ExitCode { kSolved = 0, kUsage = 1, kUnreadable = 2, kNoResult = 3 };

/// What an error ends a verb with: an option that cannot be, or an input.
int exit_code_of(const Error& error);

struct ConsoleOptions {
  bool quiet = false;
  std::string log_file;
  bool append_log = false;
  int threads = 0;  ///< 0: one per core
  Language language = Language::English;
};

/// Shows progress on one line of a terminal that is rewritten, keeps the log, and turns Ctrl-C into a stop request:
/// the first is obeyed at the next opportunity, the second ends the program at once. What files and their names hold
/// reaches terminal and log in a printable form (model/formats/files/printable_text.h). Messages are said in the
/// language of the options.
class Console {
 public:
  /// Must be made before any other thread, so that only its own receives the signals.
  Console();
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  ConsoleOptions& options() { return options_; }
  const ConsoleOptions& options() const { return options_; }
  /// Opens the log file; call once the options are parsed. Throws Error(Io).
  void start(const std::string& command_line);

  Progress& progress() { return progress_; }
  bool cancelled() const { return stop_.stop_requested(); }

  /// A message in the language of the options.
  std::string words(const Message& message) const { return render(message, options_.language); }

  /// To stdout unless --quiet, and to the log.
  void print(const Message& message);
  /// The same for text that is made of messages already, as tables are.
  void print_text(const std::string& text);
  /// What was asked for, to stdout even with --quiet, and not to the log.
  void deliver(std::string_view text);
  /// To stderr always, and to the log.
  void complain(const Message& message);
  /// The same, as a warning.
  void warn(const Message& message);
  /// The place of an error is one line, whatever the names of its files.
  void complain(const Error& error);
  /// What a verb ends with that would end with `code`: kUnreadable instead of kSolved where something that was printed
  /// or logged got lost on the way, for a full disk.
  int end(int code) const;
  /// Notes go to the log only, the rest to stderr as well (unless --quiet).
  void report(const std::vector<drive::Finding>& findings);

 private:
  void show(const ProgressUpdate& update);
  void clear_line();
  void log(std::string_view text);
  /// Says so with the reason that errno holds, once for each kind of output.
  void lose(bool& lost, const Message& what);
  void write(std::string_view text);
  double elapsed_s() const;

  ConsoleOptions options_;
  std::stop_source stop_;
  std::ofstream log_;
  bool terminal_ = false;
  bool line_shown_ = false;
  bool output_lost_ = false, log_lost_ = false;
  Stage stage_ = nullptr;
  std::size_t last_done_ = 0;
  RemainingTime remaining_;  // of the stage
  std::chrono::steady_clock::time_point started_, stage_started_, shown_;
  std::mutex mutex_;
  Progress progress_;
  std::jthread signals_;
};

}  // namespace remount::cli
