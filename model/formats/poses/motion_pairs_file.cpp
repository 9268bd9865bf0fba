#include "model/formats/poses/motion_pairs_file.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "algorithms/core/error.h"
#include "messages/poses.h"
#include "model/conventions/impossible_motion.h"
#include "model/formats/files/csv_table.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/text_file.h"

namespace remount::formats {
namespace {

constexpr double kRotationTolerance = 1e-3;
/// A pair takes far more memory than the shortest line that can hold one: so many, and one more for so many bytes.
constexpr std::size_t kAlwaysPairs = 200'000, kBytesOfPair = 400;

/// Columns of one 3x4 matrix, row by row.
std::array<std::size_t, 12> matrix_columns(const CsvHeader& header, char letter, const std::filesystem::path& path) {
  std::array<std::size_t, 12> columns{};
  for (std::size_t i = 0; i < 12; ++i)
    columns[i] = header.require(std::string(1, letter) + std::to_string(i / 4) + std::to_string(i % 4), path);
  return columns;
}

class PairsReader {
 public:
  PairsReader(const std::filesystem::path& path, const CsvHeader& header, const std::string& text)
      : path_(path),
        header_size_(header.size()),
        set_(header.has("set") ? header.find("set") : header.find("seq")),
        i_(header.find("i")),
        j_(header.find("j")),
        p_(matrix_columns(header, 'P', path)),
        q_(matrix_columns(header, 'Q', path)),
        most_pairs_(kAlwaysPairs + text.size() / kBytesOfPair) {
    const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    found_.pairs.reserve(std::min(most_pairs_, lines + 1));
  }

  void add(const std::vector<std::string_view>& fields, std::size_t line) {
    if (fields.size() != header_size_)
      throw Error(ErrorCode::Format, at_line(path_, line), say::motions_fields(fields.size(), header_size_));
    if (found_.pairs.size() >= most_pairs_)
      throw Error(ErrorCode::Format, at_line(path_, line), say::motions_too_many(most_pairs_));
    const motion::SessionIndex set = set_index(set_ < 0 ? "" : fields[index_at(set_)]);
    const std::size_t row = found_.pairs.size();
    motion::Pair pair;
    // P = ins_i_from_ins_j, so that b of the pair is i and a is j.
    pair.keyframe_a = keyframe(set, scan(fields, j_, 2 * row + 1, line));
    pair.keyframe_b = keyframe(set, scan(fields, i_, 2 * row, line));
    pair.ins_b_from_ins_a = rigid(fields, p_, 'P', line);
    pair.lidar_b_from_lidar_a = rigid(fields, q_, 'Q', line);
    pair.baseline_m = pair.ins_b_from_ins_a.translation().norm();
    pair.rotation_rad = so3_log(pair.ins_b_from_ins_a.linear()).norm();
    pair.registration.attempted = pair.registration.converged = true;
    pair.registration.overlap = 1.0;
    found_.pairs.push_back(pair);
  }

  MotionPairs take() { return std::move(found_); }

 private:
  motion::SessionIndex set_index(std::string_view name) {
    const auto known = std::find(found_.sets.begin(), found_.sets.end(), name);
    const auto place = index_at<motion::SessionIndex>(known - found_.sets.begin());
    if (known == found_.sets.end()) found_.sets.emplace_back(name);
    return place;
  }

  motion::ScanIndex scan(const std::vector<std::string_view>& fields, int column, std::size_t otherwise,
                         std::size_t line) const {
    if (column < 0) return motion::ScanIndex(otherwise);
    const std::string_view text = fields[index_at(column)];
    const auto value = parse_integer(text);
    if (!value || *value < 0 || *value > 2000000000)
      throw Error(ErrorCode::Format, at_line(path_, line), say::motions_index(std::string(text.substr(0, 40))));
    return index_at<motion::ScanIndex>(*value);
  }

  motion::KeyframeIndex keyframe(motion::SessionIndex set, motion::ScanIndex scan) {
    const auto [place, is_new] = keyframes_.try_emplace({set, scan}, found_.keyframes.size());
    if (is_new) found_.keyframes.push_back({set, scan, signed_of(scan), 0.0});
    return place->second;
  }

  RigidTransform rigid(const std::vector<std::string_view>& fields, const std::array<std::size_t, 12>& columns,
                       char letter, std::size_t line) const {
    Eigen::Matrix<double, 3, 4> matrix;
    for (std::size_t i = 0; i < 12; ++i)
      matrix(static_cast<int>(i / 4), static_cast<int>(i % 4)) = require_number(
          fields[columns[i]], std::string(1, letter) + std::to_string(i / 4) + std::to_string(i % 4), path_, line);
    return motion_of_matrix(matrix, std::string(1, letter), at_line(path_, line));
  }

  const std::filesystem::path& path_;
  std::size_t header_size_;
  int set_, i_, j_;
  std::array<std::size_t, 12> p_, q_;
  MotionPairs found_;
  std::map<std::pair<motion::SessionIndex, motion::ScanIndex>, motion::KeyframeIndex> keyframes_;
  std::size_t most_pairs_;
};

}  // namespace

RigidTransform motion_of_matrix(const Eigen::Matrix<double, 3, 4>& matrix, const std::string& name,
                                const std::string& where) {
  const Eigen::Matrix3d printed = matrix.leftCols<3>();
  const double off = (printed * printed.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(off <= kRotationTolerance) || printed.determinant() < 0.0)
    throw Error(ErrorCode::Format, where, say::motions_no_rotation(name));
  if (!conventions::is_possible_position(matrix.col(3)))
    throw Error(ErrorCode::Format, where, say::motions_too_far(name));
  return make_rigid(nearest_rotation(printed), matrix.col(3));
}

MotionPairs read_motion_pairs(const std::filesystem::path& path) {
  const std::string text = read_text_file(path, std::uint64_t{1} << 30U);
  LineReader lines(text);
  std::optional<PairsReader> reader;
  std::vector<std::string_view> fields;
  for (std::string_view line; lines.next(line);) {
    if (trim(line).empty() || trim(line).starts_with("#")) continue;
    if (!reader) {
      reader.emplace(path, CsvHeader(line), text);
      continue;
    }
    split_csv(line, fields);
    reader->add(fields, lines.line_number());
  }
  if (!reader) throw Error(ErrorCode::Format, path.string(), say::motions_empty());
  MotionPairs found = reader->take();
  if (found.pairs.empty()) throw Error(ErrorCode::Format, path.string(), say::motions_no_pair());
  return found;
}

}  // namespace remount::formats
