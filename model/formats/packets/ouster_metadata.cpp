#include "model/formats/packets/ouster_metadata.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "messages/captures.h"
#include "model/formats/documents/parse_document.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/printable_text.h"
#include "model/formats/files/text_file.h"
#include "model/formats/packets/files_beside.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kElevations = "beam_altitude_angles";

/// Of files that are flat, the file itself.
DocumentView section_of(const DocumentView& root, std::string_view name) {
  const auto found = root.find(name);
  return found && found->is_map() ? *found : root;
}

/// A whole number, written as such or as a text, as serial numbers are.
std::optional<std::uint64_t> whole_number(const DocumentView& map, std::string_view key) {
  const auto found = map.find(key);
  if (!found) return std::nullopt;
  const std::optional<std::int64_t> number = parse_integer(found->node().text);
  return number && *number > 0 ? std::optional(static_cast<std::uint64_t>(*number)) : std::nullopt;
}

std::string text_of(const DocumentView& map, std::string_view key) {
  const auto found = map.find(key);
  return found ? found->node().text : std::string();
}

double number_within(const DocumentView& view, double least, double most) {
  const double number = view.number();
  if (number < least || number > most) view.fail(say::capture_number_within(least, most, number));
  return number;
}

std::vector<double> angles_of(const DocumentView& beams, std::string_view key, std::size_t pixels, double most_deg) {
  const DocumentView list = beams.at(key);
  if (!list.is_sequence() || list.items().size() != pixels) static_cast<void>(list.numbers(pixels));  // throws
  std::vector<double> angles_rad;
  for (const DocumentView& angle : list.items())
    angles_rad.push_back(degrees_to_radians(number_within(angle, -most_deg, most_deg)));
  return angles_rad;
}

/// Sixteen numbers row by row, mm.
RigidTransform transform_of(const DocumentView& view) {
  constexpr double kMostOff = 1e-3, kFarthest_mm = 10'000.0;
  const std::vector<double> numbers = view.numbers(16);
  const Eigen::Matrix4d matrix = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.data());
  const Eigen::Matrix3d turn = matrix.topLeftCorner<3, 3>();
  const bool rigid = (turn * turn.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < kMostOff &&
                     turn.determinant() > 0.0 && (matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).norm() < kMostOff &&
                     matrix.topRightCorner<3, 1>().cwiseAbs().maxCoeff() < kFarthest_mm;
  if (!rigid) view.fail(say::capture_ouster_transform());
  RigidTransform transform = RigidTransform::Identity();
  transform.linear() = nearest_rotation(turn);
  transform.translation() = 1e-3 * matrix.topRightCorner<3, 1>();
  return transform;
}

/// "1024x10": columns of a turn, turns of a second.
std::optional<std::uint32_t> columns_of_mode(const std::string& mode) {
  const auto columns = parse_integer(std::string_view(mode).substr(0, mode.find('x')));
  return columns ? std::optional(static_cast<std::uint32_t>(std::clamp<std::int64_t>(*columns, 0, 65535)))
                 : std::nullopt;
}

void read_layout(const DocumentView& root, OusterMetadata& metadata) {
  constexpr std::int64_t kMostPixels = 1024, kMostColumns = 8192, kMostInPacket = 256;
  const DocumentView config = section_of(root, "config_params"), beams = section_of(root, "beam_intrinsics");
  auto format = root.find("lidar_data_format");
  if (!format) format = root.find("data_format");
  // The sensors' first firmware answers with a text here that it knows no such thing.
  if (format && !format->is_map()) format.reset();
  metadata.profile = ouster_profile("LEGACY");
  if (const auto profile = format ? format->find("udp_profile_lidar") : std::nullopt) {
    std::vector<std::string_view> names;
    for (const OusterProfile& known : ouster_profiles()) names.push_back(known.name);
    metadata.profile = &ouster_profiles()[profile->choice(names)];
  }
  OusterLayout& layout = metadata.layout;
  layout.pixel_bytes = metadata.profile->pixel_bytes;
  layout.header = metadata.profile->legacy() ? OusterHeader::None : OusterHeader::Standard;
  const bool fusa = format && format->has("header_type") ? text_of(*format, "header_type") == "FUSA"
                                                         : metadata.profile->name.starts_with("FUSA");
  if (fusa && !metadata.profile->legacy()) layout.header = OusterHeader::Fusa;
  const DocumentView elevations = beams.at(kElevations);
  layout.pixels = format && format->has("pixels_per_column")
                      ? static_cast<std::size_t>(format->at("pixels_per_column").integer(1, kMostPixels))
                      : elevations.items().size();
  if (layout.pixels == 0 || layout.pixels > static_cast<std::size_t>(kMostPixels))
    elevations.fail(
        say::capture_number_within(1, static_cast<double>(kMostPixels), static_cast<double>(layout.pixels)));
  if (format && format->has("columns_per_packet"))
    layout.columns = static_cast<std::size_t>(format->at("columns_per_packet").integer(1, kMostInPacket));
  if (format && format->has("columns_per_frame"))
    metadata.columns_per_turn = static_cast<std::uint32_t>(format->at("columns_per_frame").integer(1, kMostColumns));
  else if (const auto columns = columns_of_mode(text_of(config, "lidar_mode")))
    metadata.columns_per_turn = *columns;
  if (metadata.columns_per_turn == 0 || metadata.columns_per_turn > kMostColumns)
    static_cast<void>(config.at("lidar_mode").choice({"512x10", "512x20", "1024x10", "1024x20", "2048x10", "4096x5"}));
}

/// Where beams begin, of firmware that does not say it: the first generation has no `data_format` either.
double usual_beams_ahead_mm(const OusterMetadata& metadata, bool first_generation) {
  if (metadata.product.starts_with("OS-0")) return 27.67;
  if (metadata.product.starts_with("OS-2")) return 13.762;
  return first_generation || !metadata.product.starts_with("OS-1") ? 12.163 : 15.806;
}

void read_beams(const DocumentView& root, OusterMetadata& metadata) {
  constexpr double kMostBeams_mm = 1000.0;
  const DocumentView beams = section_of(root, "beam_intrinsics"), lidar = section_of(root, "lidar_intrinsics");
  metadata.elevations_rad = angles_of(beams, kElevations, metadata.layout.pixels, 90.0);
  metadata.azimuths_rad = angles_of(beams, "beam_azimuth_angles", metadata.layout.pixels, 360.0);
  const auto filled = [](const std::optional<DocumentView>& view) {
    return view && view->is_sequence() && !view->items().empty() ? view : std::nullopt;
  };
  if (const auto begin = filled(beams.find("beam_to_lidar_transform"))) {
    const RigidTransform lidar_from_beams = transform_of(*begin);
    metadata.beams_ahead_m = lidar_from_beams.translation().x();
    metadata.beams_above_m = lidar_from_beams.translation().z();
  } else if (const auto ahead = beams.find("lidar_origin_to_beam_origin_mm"); ahead && !ahead->is_null()) {
    metadata.beams_ahead_m = 1e-3 * number_within(*ahead, -kMostBeams_mm, kMostBeams_mm);
  } else {
    const auto format = root.find("data_format");
    metadata.beams_ahead_m = 1e-3 * usual_beams_ahead_mm(metadata, !format || !format->is_map());
  }
  constexpr double kUsualHeight_m = 0.03618;
  metadata.sensor_from_lidar = RigidTransform::Identity();
  metadata.sensor_from_lidar.linear().diagonal() << -1.0, -1.0, 1.0;
  metadata.sensor_from_lidar.translation().z() = kUsualHeight_m;
  if (const auto sensor = filled(lidar.find("lidar_to_sensor_transform")))
    metadata.sensor_from_lidar = transform_of(*sensor);
}

}  // namespace

std::optional<OusterMetadata> parse_ouster_metadata(const std::string& bytes, const fs::path& file) {
  const std::string text = utf8_text(bytes);
  if (text.find(kElevations) == std::string::npos) return std::nullopt;
  const DocumentNode document = parse_json(text, file.string());
  const DocumentView root(document, file.string());
  if (!root.is_map() || !section_of(root, "beam_intrinsics").has(kElevations)) return std::nullopt;
  const DocumentView elevations = section_of(root, "beam_intrinsics").at(kElevations);
  if (elevations.is_sequence() && !elevations.items().empty() && elevations.items().front().is_sequence())
    throw Error(ErrorCode::Unsupported, file.string(), say::capture_ouster_flash());
  OusterMetadata metadata;
  metadata.file = file;
  const DocumentView info = section_of(root, "sensor_info"), config = section_of(root, "config_params");
  constexpr std::size_t kLongestProduct = 32;
  metadata.product = printable(text_of(info, "prod_line").substr(0, kLongestProduct), LineBreaks::Escaped);
  metadata.serial = whole_number(info, "prod_sn");
  if (const auto id = whole_number(info, "initialization_id"))
    metadata.initialization = static_cast<std::uint32_t>(*id);
  if (const auto port = whole_number(config, "udp_port_lidar"); port && *port <= 65535)
    metadata.port = static_cast<std::uint16_t>(*port);
  const std::string mode = text_of(config, "timestamp_mode");
  metadata.clock_follows = mode == "TIME_FROM_PTP_1588" || mode == "TIME_FROM_SYNC_PULSE_IN";
  read_layout(root, metadata);
  read_beams(root, metadata);
  return metadata;
}

namespace {

/// The serial number that packets have, as far as they are laid out so; 0: none.
std::uint64_t serial_in_packets(const OusterMetadata& metadata, const OusterTraits& traits) {
  return metadata.layout.header == OusterHeader::None       ? 0
         : metadata.layout.header == OusterHeader::Standard ? traits.serial
                                                            : traits.fusa_serial;
}

bool has_its_serial(const OusterMetadata& metadata, const OusterTraits& traits) {
  const std::uint64_t serial = serial_in_packets(metadata, traits);
  return serial != 0 && metadata.serial == serial;
}

bool fits(const OusterMetadata& metadata, const OusterTraits& traits, const BesidePackets& beside) {
  if (metadata.layout.packet_bytes() != traits.packet_bytes) return false;
  // A sensor may have got another address since, but no other serial number.
  if (has_its_serial(metadata, traits)) return true;
  const bool of_another = metadata.serial && serial_in_packets(metadata, traits) != 0;
  return !of_another && !names_other_address(metadata.file, beside);
}

constexpr int kRankOfAddress = 8;  // more than all else together

int rank_of(const OusterMetadata& metadata, const OusterTraits& traits, const BesidePackets& beside) {
  const std::uint32_t initialization = metadata.layout.header == OusterHeader::Standard ? traits.initialization
                                       : metadata.layout.header == OusterHeader::Fusa   ? traits.fusa_initialization
                                                                                        : 0;
  const bool same_start = initialization != 0 && metadata.initialization == initialization;
  const bool same_port = metadata.port == beside.route.port;
  return kRankOfAddress * rank_of_address(metadata.file, beside) + (same_start ? 4 : 0) + (same_port ? 2 : 0) +
         (metadata.file.stem() == beside.recording.stem() ? 1 : 0);
}

bool same_sensor(const OusterMetadata& a, const OusterMetadata& b) {
  return a.profile == b.profile && a.layout.header == b.layout.header && a.columns_per_turn == b.columns_per_turn &&
         a.elevations_rad == b.elevations_rad && a.azimuths_rad == b.azimuths_rad &&
         a.beams_ahead_m == b.beams_ahead_m && a.beams_above_m == b.beams_above_m &&
         a.sensor_from_lidar.isApprox(b.sensor_from_lidar) && a.clock_follows == b.clock_follows;
}

Message described(const OusterMetadata& metadata) {
  return say::capture_ouster_described(name_beside(metadata.file), metadata.product,
                                       metadata.serial ? std::to_string(*metadata.serial) : "?",
                                       metadata.layout.packet_bytes());
}

}  // namespace

OusterMetadata find_ouster_metadata(const BesidePackets& beside, const OusterTraits& traits, const std::string& where) {
  const auto files = read_files_beside(beside, ".json", kMaxManifestBytes, parse_ouster_metadata);
  const std::string wanted = beside.recording.stem().string() + ".json";
  std::vector<const OusterMetadata*> best;
  int rank = -1;
  for (const OusterMetadata& metadata : files.found) {
    if (!fits(metadata, traits, beside)) continue;
    const int its = rank_of(metadata, traits, beside);
    if (its > rank) best.clear();
    if (its >= rank) best.push_back(&metadata);
    rank = std::max(rank, its);
  }
  const std::string better = rank >= kRankOfAddress ? address_text(beside.route) + ".json" : wanted;
  for (const OusterMetadata* other : best)
    if (!same_sensor(*best.front(), *other))
      throw Error(ErrorCode::Unsupported, where,
                  say::capture_ouster_several(name_beside(best.front()->file), name_beside(other->file), better));
  const bool certain = !best.empty() && has_its_serial(*best.front(), traits);
  for (const auto& broken : files.broken)
    if (!certain && (best.empty() || kRankOfAddress * rank_of_address(broken.file, beside) > rank)) throw broken.error;
  if (!best.empty()) return *best.front();
  if (files.found.empty()) throw Error(ErrorCode::Unsupported, where, say::capture_ouster_no_metadata(wanted));
  std::vector<Message> others;
  constexpr std::size_t kMostNamed = 5;
  for (const OusterMetadata& metadata : files.found)
    if (others.size() < kMostNamed) others.push_back(described(metadata));
  throw Error(ErrorCode::Unsupported, where,
              say::capture_ouster_other_metadata(traits.packet_bytes, std::move(others), wanted));
}

}  // namespace remount::formats
