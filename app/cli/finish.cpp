#include "app/cli/finish.h"

#include <filesystem>

#include "app/cli/summary.h"
#include "messages/command_line.h"

namespace remount::cli {

bool keeps_old_file(bool cancelled, const std::string& path, Console& console) {
  if (!cancelled || path.empty() || !std::filesystem::exists(path)) return false;
  console.complain(say::cli_cancelled_file_stays(path));
  return true;
}

bool keeps_old_file(const calibration::CalibrationResult& result, const std::string& path, Console& console) {
  return keeps_old_file(result.status == calibration::Status::Cancelled, path, console);
}

int finish(const results::ResultFile& file, const std::string& output, Console& console) {
  const bool kept = keeps_old_file(file.result, output, console);
  if (!output.empty() && !kept) results::save_result(file, output);
  console.print_text(summary(file, console.options().language));
  if (!kept) console.print(output.empty() ? say::cli_result_not_written() : say::cli_result_written(output));
  if (calibration::is_usable(file.result)) return kSolved;
  console.complain(say::cli_no_usable_result(std::string(to_string(file.result.status)), file.result.message));
  return kNoResult;
}

}  // namespace remount::cli
