#include "app/cli/finish.h"

#include "app/cli/summary.h"

namespace remount {

int finish(const ResultFile& file, const std::string& output, Console& console) {
  if (!output.empty()) save_result(file, output);
  console.print(summary(file));
  console.print(output.empty() ? std::string("the result was not written: give -o RESULT.yaml") : "result: " + output);
  if (is_usable(file.result)) return kSolved;
  console.complain("no usable result (" + std::string(to_string(file.result.status)) + "): " + file.result.message);
  for (const std::string& advice : file.result.advice) console.complain("advice: " + advice);
  return kNoResult;
}

}  // namespace remount
