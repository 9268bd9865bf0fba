#include "app/cli/finish.h"

#include <filesystem>

#include "algorithms/messages/render.h"
#include "app/cli/summary.h"

namespace remount {

bool keeps_old_file(const CalibrationResult& result, const std::string& path, Console& console) {
  if (result.status != Status::Cancelled || path.empty() || !std::filesystem::exists(path)) return false;
  console.complain("cancelled: " + path + " stays as it was");
  return true;
}

int finish(const ResultFile& file, const std::string& output, Console& console) {
  const bool kept = keeps_old_file(file.result, output, console);
  if (!output.empty() && !kept) save_result(file, output);
  console.print(summary(file));
  if (!kept)
    console.print(output.empty() ? std::string("the result was not written: give -o RESULT.yaml")
                                 : "result: " + output);
  if (is_usable(file.result)) return kSolved;
  console.complain("no usable result (" + std::string(to_string(file.result.status)) +
                   "): " + english(file.result.message));
  return kNoResult;
}

}  // namespace remount
