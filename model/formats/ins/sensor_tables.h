// IMU, GNSS, wheels and barometer in CSV files with fixed columns, as a native session holds them: see
// resources/formats/native-session.md.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/motion/sensor_samples.h"
#include "model/drive/session.h"

namespace remount::formats {

// Samples with strictly ascending stamps. Lines that cannot be used become findings "bad-imu", "bad-gnss",
// "bad-wheels", "bad-barometer". Throws Error where the file cannot be read, a column is missing, or no line is usable.
std::vector<motion::ImuSample> read_imu_table(const std::filesystem::path& path, std::vector<drive::Finding>& findings);
std::vector<motion::GnssFix> read_gnss_table(const std::filesystem::path& path, std::vector<drive::Finding>& findings);
std::vector<motion::WheelSample> read_wheel_table(const std::filesystem::path& path,
                                                  std::vector<drive::Finding>& findings);
std::vector<motion::BarometerSample> read_barometer_table(const std::filesystem::path& path,
                                                          std::vector<drive::Finding>& findings);
/// As read_gnss_table, of a text that was read already; `path` is for messages.
std::vector<motion::GnssFix> parse_gnss_table(std::string_view text, const std::filesystem::path& path,
                                              std::vector<drive::Finding>& findings);

// The text of such files. Reads back to the same stamps and numbers; latitude and longitude to 1e-12 degrees.
std::string imu_table(const std::vector<motion::ImuSample>& samples);
std::string gnss_table(const std::vector<motion::GnssFix>& fixes);
std::string wheel_table(const std::vector<motion::WheelSample>& samples);
std::string barometer_table(const std::vector<motion::BarometerSample>& samples);

}  // namespace remount::formats
