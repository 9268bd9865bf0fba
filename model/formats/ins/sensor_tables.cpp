#include "model/formats/ins/sensor_tables.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "algorithms/core/index.h"
#include "algorithms/core/symmetric_eigen.h"
#include "algorithms/geometry/rotation.h"
#include "messages/ins_logs.h"
#include "messages/sessions.h"
#include "model/drive/bad_items.h"
#include "model/drive/plausible_values.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/files/csv_table.h"
#include "model/formats/files/cut_line.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/number_text.h"
#include "model/formats/files/text_file.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 3> kRates{"gyro_x_radps", "gyro_y_radps", "gyro_z_radps"};
constexpr std::array<std::string_view, 3> kForces{"force_x_mps2", "force_y_mps2", "force_z_mps2"};
constexpr std::array<std::string_view, 3> kPlace{"latitude_deg", "longitude_deg", "height_m"};
constexpr std::array<std::string_view, 3> kVariances{"var_east_m2", "var_north_m2", "var_up_m2"};
constexpr std::array<std::string_view, 3> kCovariances{"cov_east_north_m2", "cov_east_up_m2", "cov_north_up_m2"};

/// One line of a table, its fields by the names of their columns.
class Row {
 public:
  Row(const fs::path& path, const CsvHeader& header) : path_(path), header_(header) {}

  void take(std::string_view line, std::size_t number) {
    line_ = number;
    split_csv(line, fields_);
    if (fields_.size() != header_.size()) fail(say::csv_fields(fields_.size(), header_.size()));
  }
  [[noreturn]] void fail(Message what) const { throw Error(ErrorCode::Format, at_line(path_, line_), std::move(what)); }

  bool has(std::string_view column) const { return header_.has(column); }
  std::int64_t stamp_ns() const {
    const std::string_view text = field("time_ns");
    const auto stamp = parse_integer(text);
    if (!stamp) fail(say::sensor_no_time(std::string(text.substr(0, 40))));
    return *stamp;
  }
  double number(std::string_view column) const {
    const double value = require_number(field(column), column, path_, line_);
    if (drive::means_not_known(value))
      fail(say::log_not_known(Message::verbatim(std::string(column)), std::string(field(column).substr(0, 40))));
    return value;
  }
  Eigen::Vector3d numbers(const std::array<std::string_view, 3>& columns) const {
    return {number(columns[0]), number(columns[1]), number(columns[2])};
  }
  /// NaN where the field is empty, "nan" or a number that stands for a missing one: this line does not state it.
  double number_or_nan(std::string_view column) const {
    const std::string_view text = field(column);
    if (text.empty() || text == "nan") return std::numeric_limits<double>::quiet_NaN();
    const double value = require_number(text, column, path_, line_);
    return drive::means_not_known(value) ? std::numeric_limits<double>::quiet_NaN() : value;
  }

 private:
  std::string_view field(std::string_view column) const { return fields_[index_at(header_.find(column))]; }

  const fs::path& path_;
  const CsvHeader& header_;
  std::vector<std::string_view> fields_;
  std::size_t line_ = 0;
};

/// Each line of the file's text as a sample; `sensor` is what findings are named after.
template <class Sample, class Parse>
std::vector<Sample> parse_table(std::string_view text, const fs::path& path, const std::string& sensor,
                                const std::vector<std::string_view>& columns, std::vector<drive::Finding>& findings,
                                Parse&& parse) {
  text = without_cut_line(text, path.string(), findings);
  LineReader lines(text);
  std::string_view line;
  if (!lines.next(line)) throw Error(ErrorCode::Format, path.string(), say::csv_no_header());
  const CsvHeader header(line);
  header.require("time_ns", path);
  for (const std::string_view column : columns) header.require(column, path);
  Row row(path, header);
  std::vector<Sample> samples;
  drive::BadItems bad;
  while (lines.next(line)) {
    if (trim(line).empty() || line.starts_with('#')) continue;
    try {
      row.take(line, lines.line_number());
      samples.push_back(parse(row));
    } catch (const Error& error) {
      bad.add(error);
    }
  }
  if (samples.empty()) throw Error(ErrorCode::Format, path.string(), bad.after(say::csv_no_usable_line()));
  bad.report(findings, "bad-" + sensor, path.string(), say::left_out_lines);
  if constexpr (std::is_same_v<Sample, motion::GnssFix>) drive::keep_near(samples, path.string(), findings);
  drive::keep_ascending(samples, sensor, path.string(), findings);
  return samples;
}

std::vector<std::string_view> all(std::initializer_list<std::array<std::string_view, 3>> groups) {
  std::vector<std::string_view> columns;
  for (const auto& group : groups) columns.insert(columns.end(), group.begin(), group.end());
  return columns;
}

Eigen::Matrix3d covariance(const Row& row) {
  Eigen::Matrix3d covariance = row.numbers(kVariances).asDiagonal();
  if (row.has(kCovariances[0])) {
    const Eigen::Vector3d beside = row.numbers(kCovariances);
    covariance(0, 1) = covariance(1, 0) = beside[0];
    covariance(0, 2) = covariance(2, 0) = beside[1];
    covariance(1, 2) = covariance(2, 1) = beside[2];
  }
  const Eigen::Vector3d variances = symmetric_eigen(covariance).eigenvalues();
  if (!(variances.minCoeff() > 0.0)) row.fail(say::sensor_covariance());
  return covariance;
}

void add_line(std::string& text, std::int64_t stamp_ns, std::initializer_list<double> values) {
  text += std::to_string(stamp_ns);
  for (const double value : values) (text += ',') += exact_text(value);
  text += "\n";
}

std::string header_line(const std::vector<std::string_view>& columns) {
  std::string text = "time_ns";
  for (const std::string_view column : columns) (text += ',') += column;
  return text + "\n";
}

}  // namespace

std::vector<motion::ImuSample> read_imu_table(const fs::path& path, std::vector<drive::Finding>& findings) {
  return parse_table<motion::ImuSample>(read_text_file(path), path, "imu", all({kRates}), findings, [](const Row& row) {
    motion::ImuSample sample{row.stamp_ns(), row.numbers(kRates),
                             Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN())};
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (row.has(kForces[axis]))
        sample.specific_force_mps2[static_cast<Eigen::Index>(axis)] = row.number_or_nan(kForces[axis]);
    return sample;
  });
}

std::vector<motion::GnssFix> read_gnss_table(const fs::path& path, std::vector<drive::Finding>& findings) {
  return parse_gnss_table(read_text_file(path), path, findings);
}

std::vector<motion::GnssFix> parse_gnss_table(std::string_view text, const fs::path& path,
                                              std::vector<drive::Finding>& findings) {
  return parse_table<motion::GnssFix>(text, path, "gnss", all({kPlace, kVariances}), findings, [&](const Row& row) {
    if (row.has(kCovariances[0]) != row.has(kCovariances[1]) || row.has(kCovariances[0]) != row.has(kCovariances[2]))
      row.fail(say::sensor_covariances_together());
    const Eigen::Vector3d place = row.numbers(kPlace);
    motion::GnssFix fix{row.stamp_ns(), degrees_to_radians(place[0]), degrees_to_radians(place[1]), place[2],
                        covariance(row)};
    if (!drive::plausible_geodetic(fix.latitude_rad, fix.longitude_rad, fix.height_m))
      row.fail(say::log_place_impossible());
    return fix;
  });
}

std::vector<motion::WheelSample> read_wheel_table(const fs::path& path, std::vector<drive::Finding>& findings) {
  return parse_table<motion::WheelSample>(
      read_text_file(path), path, "wheels", {"rear_left_mps", "rear_right_mps"}, findings, [](const Row& row) {
        return motion::WheelSample{row.stamp_ns(), row.number("rear_left_mps"), row.number("rear_right_mps")};
      });
}

std::vector<motion::BarometerSample> read_barometer_table(const fs::path& path, std::vector<drive::Finding>& findings) {
  return parse_table<motion::BarometerSample>(read_text_file(path), path, "barometer", {"height_m"}, findings,
                                              [](const Row& row) {
                                                return motion::BarometerSample{row.stamp_ns(), row.number("height_m")};
                                              });
}

std::string imu_table(const std::vector<motion::ImuSample>& samples) {
  std::string text = header_line(all({kRates, kForces}));
  for (const motion::ImuSample& sample : samples) {
    const Eigen::Vector3d &rate = sample.angular_rate_radps, &force = sample.specific_force_mps2;
    add_line(text, sample.stamp_ns, {rate.x(), rate.y(), rate.z(), force.x(), force.y(), force.z()});
  }
  return text;
}

std::string gnss_table(const std::vector<motion::GnssFix>& fixes) {
  std::string text = header_line(all({kPlace, kVariances, kCovariances}));
  for (const motion::GnssFix& fix : fixes) {
    const Eigen::Matrix3d& covariance = fix.covariance_enu_m2;
    add_line(
        text, fix.stamp_ns,
        {radians_to_degrees(fix.latitude_rad), radians_to_degrees(fix.longitude_rad), fix.height_m, covariance(0, 0),
         covariance(1, 1), covariance(2, 2), covariance(0, 1), covariance(0, 2), covariance(1, 2)});
  }
  return text;
}

std::string wheel_table(const std::vector<motion::WheelSample>& samples) {
  std::string text = header_line({"rear_left_mps", "rear_right_mps"});
  for (const motion::WheelSample& sample : samples)
    add_line(text, sample.stamp_ns, {sample.rear_left_mps, sample.rear_right_mps});
  return text;
}

std::string barometer_table(const std::vector<motion::BarometerSample>& samples) {
  std::string text = header_line({"height_m"});
  for (const motion::BarometerSample& sample : samples) add_line(text, sample.stamp_ns, {sample.height_m});
  return text;
}

}  // namespace remount::formats
