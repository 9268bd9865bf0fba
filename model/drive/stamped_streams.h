// Streams with clean stamps: ascending, each once, of one place on earth.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "algorithms/motion/ins_sample.h"
#include "algorithms/motion/sensor_samples.h"
#include "model/drive/finding.h"

namespace remount::drive {

struct ScanFile {
  std::filesystem::path path;
  std::int64_t stamp_ns = 0;
};

/// A scan that is an item of something else: a message of a bag.
struct IndexedScan {
  std::size_t index = 0;
  std::int64_t stamp_ns = 0;
};

/// Makes stamps strictly ascending: stamps that are no time at all and single stamps far in the future are taken out,
/// then every item that is not later than the one before it; of fixes and INS samples with one stamp the best by what
/// they say of themselves stays, of others the first. What was taken out becomes findings "<code>-duplicate-stamps",
/// "<code>-reversed-stamps" and "<code>-impossible-stamps". Throws Error(Format) where no stamp is possible.
template <class Item>
void keep_ascending(std::vector<Item>& items, const std::string& code, const std::string& where,
                    std::vector<Finding>& findings);

/// Adds "<code>-duplicate-stamps" where entries repeat the stamp before them.
/// @param best the best of each stamp was used, not the first
void report_one_stamp(std::size_t count, bool best, const std::string& code, const std::string& where,
                      std::vector<Finding>& findings);

/// Leaves out samples that lie more than 2 degrees from the median: glitches that no drive contains, and that no one
/// grid could hold. What was taken out becomes a finding "ins-far-away", of fixes "gnss-far-away".
/// Throws Error(Format) where nothing is left.
void keep_near(std::vector<motion::InsSample>& ins, const std::string& where, std::vector<Finding>& findings);
void keep_near(std::vector<motion::GnssFix>& fixes, const std::string& where, std::vector<Finding>& findings);

/// Median difference of ascending stamps in seconds; 0 where there are fewer than two.
template <class Item>
double median_period_s(const std::vector<Item>& items) {
  std::vector<std::int64_t> steps;
  for (std::size_t i = 1; i < items.size(); ++i) steps.push_back(items[i].stamp_ns - items[i - 1].stamp_ns);
  if (steps.empty()) return 0.0;
  return seconds(median_of(std::move(steps)));
}

}  // namespace remount::drive
