// IMU, GNSS, wheels and barometer in CSV files with fixed columns, as a native session holds them: see
// resources/formats/native-session.md.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/motion/sensor_samples.h"
#include "model/drive/session.h"

namespace remount {

// Samples with strictly ascending stamps. Lines that cannot be used become findings "bad-imu", "bad-gnss",
// "bad-wheels", "bad-barometer". Throws Error where the file cannot be read, a column is missing, or no line is usable.
std::vector<ImuSample> read_imu_table(const std::filesystem::path& path, std::vector<Finding>& findings);
std::vector<GnssFix> read_gnss_table(const std::filesystem::path& path, std::vector<Finding>& findings);
std::vector<WheelSample> read_wheel_table(const std::filesystem::path& path, std::vector<Finding>& findings);
std::vector<BarometerSample> read_barometer_table(const std::filesystem::path& path, std::vector<Finding>& findings);
/// As read_gnss_table, of a text that was read already; `path` is for messages.
std::vector<GnssFix> parse_gnss_table(std::string_view text, const std::filesystem::path& path,
                                      std::vector<Finding>& findings);

// The text of such files. Reads back to the same stamps and numbers; latitude and longitude to 1e-12 degrees.
std::string imu_table(const std::vector<ImuSample>& samples);
std::string gnss_table(const std::vector<GnssFix>& fixes);
std::string wheel_table(const std::vector<WheelSample>& samples);
std::string barometer_table(const std::vector<BarometerSample>& samples);

}  // namespace remount
