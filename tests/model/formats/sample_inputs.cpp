#include "tests/model/formats/sample_inputs.h"

#include <functional>
#include <variant>

#include "model/formats/sessions/native_session_writer.h"
#include "model/results/beam_file.h"
#include "model/results/exporters/exporter.h"
#include "model/settings/settings_file.h"
#include "model/simulator/simulator.h"
#include "tests/fuzz/readers.h"
#include "tests/model/formats/bags/bag_maker.h"
#include "tests/model/formats/bags/maker_messages.h"
#include "tests/model/formats/bags/sqlite_fixture.h"
#include "tests/model/formats/las_bytes.h"
#include "tests/model/formats/laz/made_scans.h"
#include "tests/model/formats/sample_captures.h"
#include "tests/model/formats/sample_files.h"
#include "tests/model/formats/sample_recordings.h"
#include "tests/model/formats/sample_tables.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {

namespace fs = std::filesystem;

using namespace samples;

namespace {

// ---- Drives

simulator::SimulationOptions tiny_options() {
  simulator::SimulationOptions options;
  options.duration_s = 0.6;
  options.beams = 4;
  options.azimuth_steps = 24;
  options.ins_rate_hz = options.imu.rate_hz = options.wheels.rate_hz = 20.0;
  options.clockwise = false;
  return options;
}

simulator::SimulatedDrive tiny_drive() { return simulator::simulate_drive(tiny_options()); }

/// The files of a folder but for the truth, which no reader looks at.
std::string packed_folder(const fs::path& folder, const std::vector<PackedFile>& more = {}) {
  std::vector<PackedFile> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().filename() != "truth.yaml")
      files.push_back({fs::relative(entry.path(), folder).string(), bytes_of(entry.path())});
  std::sort(files.begin(), files.end(), [](const PackedFile& a, const PackedFile& b) { return a.name < b.name; });
  files.insert(files.end(), more.begin(), more.end());
  return pack_files(files);
}

/// A session with two LiDARs of different kinds.
std::string written_vehicle() {
  const simulator::SimulationOptions options = tiny_options();
  simulator::LidarMount front{"front", options}, rear{"rear", options};
  rear.options.lidar.model = simulator::lidar_named("avia");
  rear.options.lidar.points_per_scan = 60;
  const TemporaryFolder folder;
  Progress progress;
  simulator::write_vehicle(simulator::simulate_vehicle(options, {front, rear}), folder.path() / "s", "native", 1,
                           progress);
  return packed_folder(folder.path() / "s");
}

std::string written_drive(const simulator::SimulatedDrive& drive, const std::string& format) {
  const TemporaryFolder folder;
  Progress progress;
  simulator::write_drive(drive, folder.path() / "s", format, 1, progress);
  return packed_folder(folder.path() / "s");
}

/// INS and scans with stamps of their own, or equal ones; with the files that KITTI has beside those that are written.
std::string kitti(bool sync) {
  const TemporaryFolder folder;
  Progress progress;
  drive::Session session = tiny_drive().session;
  if (sync) {
    session.ins.resize(std::min(session.ins.size(), session.scans->size()));
    for (std::size_t i = 0; i < session.ins.size(); ++i) session.ins[i].stamp_ns = session.scans->stamp_ns(i);
  }
  write_kitti_raw_session(session, folder.path(), 1, progress);
  std::vector<PackedFile> more{
      {"calib_imu_to_velo.txt", "calib_time: 25-May-2012\nR: 1 0 0 0 1 0 0 0 1\nT: -0.8 0.3 -0.8\n"}};
  for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
    if (entry.path().parent_path().filename() == "velodyne_points" && entry.path().filename() == "timestamps.txt")
      for (const char* which : {"_start.txt", "_end.txt"})
        more.push_back({fs::relative(entry.path().parent_path(), folder.path()) / ("timestamps" + std::string(which)),
                        "2011-09-26 13:02:25.1\n2011-09-26 13:02:25.2\n2011-09-26 13:02:25.3\n"});
  return packed_folder(folder.path(), more);
}

/// A drive whose scans are compensated, as publishers of data sets have them.
std::string written_compensated(const std::string& format) {
  simulator::SimulationOptions options = tiny_options();
  options.motion_distortion = false;
  simulator::SimulatedDrive drive = simulator::simulate_drive(options);
  drive.session.nominal_ins_from_lidar = drive.ins_from_lidar;
  return written_drive(drive, format);
}

/// The messages of a drive as another kind of bag.
class Rebagged {
 public:
  explicit Rebagged(const char* format) {
    Progress progress;
    simulator::write_drive(tiny_drive(), folder_.path() / "s", format, 1, progress);
    bag_ = bags::open_bag(folder_.path() / "s", progress);
    for (const bags::BagTopic& topic : bag_->topics()) {
      for (const bags::BagEntry& entry : topic.entries)
        messages_.push_back({static_cast<std::uint32_t>(topics_.size()), entry.log_time_ns, bag_->message(entry)});
      topics_.emplace_back(topic.name, topic.type);
    }
    std::stable_sort(messages_.begin(), messages_.end(),
                     [](const auto& a, const auto& b) { return a.time_ns < b.time_ns; });
  }
  /// @param packed each message is compressed, as rosbag2 does
  std::string through(std::unique_ptr<bags::BagWriter> (*make)(const fs::path&, bags::ChunkCompression),
                      bags::ChunkCompression compression, bool packed = false) {
    const fs::path path = folder_.path() / "again";
    const std::unique_ptr<bags::BagWriter> writer = make(path, compression);
    for (const auto& [name, type] : topics_)
      writer->add_topic(name, bags::message_definition(type, writer->encoding()));
    for (const bags::TestMessage& message : messages_)
      writer->write(message.topic, message.time_ns,
                    packed ? bags::pack_chunk(bags::ChunkCompression::Zstd, message.bytes) : message.bytes);
    writer->finish();
    return bytes_of(path);
  }
  std::string database(bool packed) {
    const fs::path path = folder_.path() / "again.db3";
    fs::remove(path);
    bags::write_database(path, topics_, messages_, packed);
    return bytes_of(path);
  }

 private:
  TemporaryFolder folder_;
  std::shared_ptr<const bags::BagFile> bag_;
  std::vector<std::pair<std::string, std::string>> topics_;
  std::vector<bags::TestMessage> messages_;
};

/// Scans, and what drivers of several makers say of one drive.
std::string bag_of_makers() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "makers.bag";
  bags::BagMaker bag(path, bags::ChunkCompression::None);
  bag.add_scans("/points", 6, 4);
  for (int i = 0; i < 10; ++i) {
    const motion::InsSample sample = bags::BagMaker::on_circle(i);
    const auto add = [&](const char* topic, const char* type, std::string bytes) {
      bag.add(sample.stamp_ns + 1'000'000, topic, type, std::move(bytes));
    };
    add("/sbg/nav", "sbg_driver/SbgEkfNav", bags::sbg_nav(sample, bags::kRos1));
    add("/sbg/euler", "sbg_driver/SbgEkfEuler", bags::sbg_euler(sample, true, bags::kRos1));
    add("/insnavgeod", "septentrio_gnss_driver/INSNavGeod", bags::ins_nav_geod(sample, true, bags::kRos1));
    add("/gsof49", "applanix_msgs/NavigationSolutionGsof49", bags::gsof49(sample, 4, bags::kRos1));
    add("/gsof50", "applanix_msgs/NavigationPerformanceGsof50", bags::gsof50(sample.stamp_ns, bags::kRos1));
    bags::MessageWriter sentence(bags::kRos1);
    sentence.header(sample.stamp_ns, "gps")
        .string(i % 2 == 0 ? "$GPHDT,90.0,T*0C" : "$GPZDA,122640.00,13,09,2020,00,00*66");
    add("/nmea", "nmea_msgs/Sentence", sentence.bytes());
    add("/ncom", "oxts_msgs/Ncom",
        bags::oxts_ncom({.millisecond = 58'000 + 50 * i, .channel = i % 6}, sample.stamp_ns, bags::kRos1));
  }
  bag.finish();
  return bytes_of(path);
}

std::unique_ptr<bags::BagWriter> rosbag1(const fs::path& path, bags::ChunkCompression compression) {
  return bags::make_rosbag1_writer(path, compression, 4000);
}
std::unique_ptr<bags::BagWriter> mcap(const fs::path& path, bags::ChunkCompression compression) {
  return bags::make_mcap_writer(path, bags::MessageEncoding::Cdr, compression, 4000);
}

/// With zero for the checksums, which says that there are none: damage is looked at then, not turned away at the door.
std::string unchecked(std::string mcap) {
  constexpr std::size_t kMagic = 8, kHead = 9, kChunkTimesAndSize = 24;
  for (std::size_t at = kMagic; at + kHead < mcap.size();) {
    std::uint64_t length = 0;
    std::memcpy(&length, mcap.data() + at + 1, sizeof length);
    const char op = mcap[at];
    at += kHead;
    const bool last = op == 15 || op == 2;  // of the data and of the summary, at the end of their records
    if (op == 6 || last) mcap.replace(last ? at + length - 4 : at + kChunkTimesAndSize, 4, 4, '\0');
    if (op == 2) break;
    at += length;
  }
  return mcap;
}

std::string rosbag2_folder(const std::string& first, const std::string& second) {
  const std::string metadata =
      "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: mcap\n  relative_file_paths:\n"
      "    - drive_0.mcap\n    - drive_1.mcap\n";
  return pack_files({{"metadata.yaml", metadata}, {"drive_0.mcap", first}, {"drive_1.mcap", second}});
}

// ---- The list

/// What takes long to make is made when it is asked for: ctest runs each test in a process of its own.
struct Recipe {
  std::string reader, name;
  std::variant<std::string, std::function<std::string()>> bytes;
};
using Recipes = std::vector<Recipe>;

void add_drives(Recipes& list) {
  const auto written = [](const char* format) {
    static const simulator::SimulatedDrive drive = tiny_drive();
    return written_drive(drive, format);
  };
  list.push_back({"native", "drive", [=] { return written("native"); }});
  list.push_back({"native", "lidars", written_vehicle});
  list.push_back({"opencalib", "drive", [=] { return written("opencalib"); }});
  list.push_back({"novatel", "drive", [=] { return written("novatel-inspvax"); }});
  list.push_back({"poses", "drive", [=] { return written("poses"); }});
  list.push_back({"smartloc", "drive", [=] { return written("smartloc"); }});
  list.push_back({"kitti-raw", "extract", [] { return kitti(false); }});
  list.push_back({"kitti-raw", "sync", [] { return kitti(true); }});
  list.push_back({"kitti-odometry", "drive", [] { return written_compensated("kitti-odometry"); }});
  list.push_back({"nuscenes", "drive", [] { return written_compensated("nuscenes"); }});
}

void add_bags(Recipes& list) {
  const auto ros1 = []() -> Rebagged& {
    static Rebagged messages("rosbag1");
    return messages;
  };
  const auto novatel = []() -> Rebagged& {
    static Rebagged messages("mcap-novatel");
    return messages;
  };
  const auto ros2 = []() -> Rebagged& {
    static Rebagged messages("mcap");
    return messages;
  };
  const auto packed = [=] { return unchecked(ros2().through(mcap, bags::ChunkCompression::Lz4)); };
  list.push_back({"rosbag1", "none", [=] { return ros1().through(rosbag1, bags::ChunkCompression::None); }});
  list.push_back({"rosbag1", "makers", bag_of_makers});
  list.push_back({"rosbag1", "packets", [] {
                    return bag_of_packets(
                        [](const fs::path& path) { return rosbag1(path, bags::ChunkCompression::None); });
                  }});
  list.push_back({"mcap", "packets", [] {
                    return unchecked(
                        bag_of_packets([](const fs::path& path) { return mcap(path, bags::ChunkCompression::None); }));
                  }});
  list.push_back({"rosbag1", "bz2", [=] { return ros1().through(rosbag1, bags::ChunkCompression::Bzip2); }});
  list.push_back({"rosbag1", "lz4", [=] { return ros1().through(rosbag1, bags::ChunkCompression::Lz4); }});
  list.push_back({"mcap", "none", [=] { return unchecked(ros2().through(mcap, bags::ChunkCompression::None)); }});
  list.push_back({"mcap", "lz4", packed});
  list.push_back({"mcap", "novatel", [=] { return unchecked(novatel().through(mcap, bags::ChunkCompression::None)); }});
  list.push_back({"mcap", "zstd", [=] { return unchecked(ros2().through(mcap, bags::ChunkCompression::Zstd)); }});
  list.push_back({"mcap", "with-checksums", [=] { return ros2().through(mcap, bags::ChunkCompression::Zstd); }});
  list.push_back(
      {"mcap", "packed-messages", [=] { return unchecked(ros2().through(mcap, bags::ChunkCompression::None, true)); }});
  list.push_back({"rosbag2-database", "plain", [=] { return ros2().database(false); }});
  list.push_back({"rosbag2-database", "packed", [=] { return ros2().database(true); }});
  list.push_back({"rosbag2-packed", "drive",
                  [=] { return bags::pack_chunk(bags::ChunkCompression::Zstd, ros2().database(false)); }});
  list.push_back({"rosbag2-packed", "mcap", [=] { return bags::pack_chunk(bags::ChunkCompression::Zstd, packed()); }});
  list.push_back({"rosbag2-folder", "drive", [=] { return rosbag2_folder(packed(), packed()); }});
}

void add_texts(Recipes& list) {
  const PackedFile lidar{"lidar.txt", poses(" ", 40)};
  list.push_back({"opencalib", "poses",
                  pack_files({{"novatel-pose.txt", pose_lines(20)}, {"top_lidar-pose.txt", pose_lines(20)}})});
  std::vector<PackedFile> scans{{"novatel-pose.txt", pose_lines(3)}};
  for (int i = 0; i < 3; ++i)
    scans.push_back({"pcd/2021-10-26-16-21-10-" + std::to_string(i) + "00.pcd", compressed_pcd(20)});
  list.push_back({"opencalib", "scans", pack_files(scans)});
  list.push_back({"novatel", "log", pack_files({{"a.log", inspvax_log(12)}, lidar})});
  list.push_back({"novatel", "inspva", pack_files({{"a.log", inspva_log(12)}, lidar})});
  list.push_back({"novatel", "binary", pack_files({{"a.gps", novatel_binary(13)}, lidar})});
  list.push_back({"novatel", "csv", pack_files({{"ins.csv", inspvax_csv(12)}, {"aft_mapped.csv", odometry_csv(12)}})});
  list.push_back({"ins-log", "sbet", pack_files({{"sbet_a.out", sbet(40)}, {"smrmsg_a.out", smrmsg(30)}, lidar})});
  list.push_back({"ins-log", "ncom", pack_files({{"drive.ncom", ncom(40)}, lidar})});
  list.push_back({"ins-log", "sbf", pack_files({{"drive.sbf", sbf_log(40)}, lidar})});
  list.push_back({"ins-log", "explorer", pack_files({{"ie.txt", explorer_table(20)}, lidar})});
  list.push_back({"ins-log", "oxts-csv", pack_files({{"oxts.csv", oxts_csv(20)}})});
  list.push_back({"gnss-log", "rtklib", pack_files({{"rover.pos", rtklib(12)}, lidar})});
  list.push_back({"poses", "hand-eye", pack_files({{"hand.csv", poses(",", 40)}, {"camera.txt", poses(" ", 40)}})});
  list.push_back({"poses", "apollo", pack_files({{"ins.csv", apollo_odometry(20)}, lidar})});
  list.push_back({"smartloc", "truth", smartloc(12)});
  list.push_back({"gnss-log", "nmea", pack_files({{"gnss.nmea", nmea(12)}, lidar})});
  list.push_back({"gnss-log", "gpx", pack_files({{"track.gpx", gpx(6)}, lidar})});
}

void add_made(std::vector<Sample> samples, Recipes& list) {
  for (Sample& sample : samples)
    list.push_back({std::move(sample.reader), std::move(sample.name), std::move(sample.bytes)});
}

void add_scans(Recipes& list) {
  list.push_back({"pcd", "ascii", ascii_pcd(10)});
  list.push_back({"pcd", "binary", binary_pcd(10)});
  list.push_back({"pcd", "compressed", compressed_pcd(20)});
  for (const char* encoding : {"ascii", "binary_little_endian", "binary_big_endian"})
    list.push_back({"ply", encoding, ply(encoding, 6)});
  LasOptions options;
  options.times = {300'000'000.25, 300'000'000.34};
  list.push_back({"las", "1.2", las(options)});
  options.minor = 4, options.format = 6;
  list.push_back({"las", "1.4", las(options)});
  list.push_back({"las", "packed-points", laz::made_scan(3)});
  list.push_back({"las", "packed-layers", laz::made_scan(7)});
  list.push_back({"kitti-bin", "scan", kitti_bin(10)});
  list.push_back({"scan-text", "scan", "1 2 3 0.5\n4 5 6 0.25\n7 8 9 1\n"});
  list.push_back(
      {"scan-text", "named", "// X [m];Y [m];Z [m];Reflectivity;Laser_ID;Time [us]\n1;2;3;7;0;0\n4;5;6;8;1;500\n"});
  list.push_back({"scan-text", "pts", "3\n1 2 3 -900 10 20 30\n4 5 6 -800 10 20 30\n7 8 9 12 0 0 0\n"});
}

void add_documents(Recipes& list) {
  list.push_back({"project", "calibrated", project()});
  list.push_back({"settings", "defaults", settings::settings_text(settings::Settings{}, false)});
  list.push_back({"result-yaml", "result", results::exporter("yaml").write(result(), {})});
  list.push_back({"result-json", "result", results::exporter("json").write(result(), {})});
  for (const auto& format : results::exporters())
    if (format->holds_mounting()) list.push_back({"mounting", std::string(format->id()), format->write(result(), {})});
  list.push_back({"vehicle", "vehicle", results::exporter("yaml").write_all(vehicle(), {})});
  for (const auto& format : results::exporters())
    if (format->names_frames())
      list.push_back({"mounting", std::string(format->id()) + "-several", format->write_all(vehicle(), {})});
  cloud::BeamEstimate beams;
  beams.nodes = cloud::BeamNodes::all_around();
  beams.errors.setConstant(beams.nodes.errors(), 0.002), beams.sigmas.setConstant(beams.nodes.errors(), 0.0005);
  beams.elevation = {0.002, 0.0004, true};
  list.push_back({"beams", "corrections", to_yaml(results::beams_document(beams))});
  list.push_back({"velodyne", "xml",
                  "<?xml version=\"1.0\"?>\n<!DOCTYPE boost_serialization>\n<boost_serialization><DB class_id=\"0\">\n"
                  "<enabled_><item>1</item><item>0</item></enabled_><points_><!-- two -->\n"
                  "<item><px class_id=\"9\"><id_>0</id_><vertCorrection_>-7.25</vertCorrection_>"
                  "<distCorrection_>118.5</distCorrection_><distCorrectionX_>123</distCorrectionX_></px></item>\n"
                  "<item><px><id_>1</id_><vertCorrection_>2</vertCorrection_><distCorrection_>0</distCorrection_></px>"
                  "</item></points_></DB></boost_serialization>\n"});
  list.push_back({"velodyne", "yaml",
                  "lasers:\n- {laser_id: 0, vert_correction: -0.125, dist_correction: 1.25, dist_correction_x: 1.5}\n"
                  "- laser_id: 1\n  vert_correction: 0.25\n  dist_correction: 0\nnum_lasers: 2\n"});
  list.push_back({"mounting", "six-numbers", "# x y z yaw pitch roll\n0.9, -0.25, 0.75, 90, 0, 0\n"});
  list.push_back({"motion-pairs", "pairs", motion_pairs(5)});
  list.push_back({"fleet", "fleet",
                  "format: remount-fleet/1\nresults: r\ndrift: {sigmas: 3}\nsettings: {pairing: {max_gap_s: 3}}\n"
                  "vehicles:\n  - {name: v, nominal: [1, 2, 3, 4, 5, 6], sessions: [a, [b, c]]}\n"});
  list.push_back({"fleet", "fleet-lidars",
                  "format: remount-fleet/1\nlidars: all\nvehicles:\n  - name: v\n"
                  "    nominal: {front: [1, 2, 3, 4, 5, 6], rear: [0, 0, 1, 0, 0, 0]}\n"
                  "    sessions: [a, {sessions: [b, c], lidars: [front, rear]}]\n"});
}

std::vector<Recipe>& recipes() {
  static Recipes all = [] {
    Recipes list;
    add_drives(list);
    add_bags(list);
    add_texts(list);
    add_made(table_samples(), list);
    add_made(captured_samples(), list);
    add_made(recorded_samples(), list);
    add_scans(list);
    add_documents(list);
    return list;
  }();
  return all;
}

Sample made(Recipe& recipe) {
  if (const auto* make = std::get_if<std::function<std::string()>>(&recipe.bytes)) recipe.bytes = (*make)();
  return {recipe.reader, recipe.name, std::get<std::string>(recipe.bytes)};
}

}  // namespace

std::vector<Sample> sample_inputs(std::string_view reader) {
  std::vector<Sample> chosen;
  for (Recipe& recipe : recipes())
    if (reader.empty() || recipe.reader == reader) chosen.push_back(made(recipe));
  return chosen;
}

std::vector<std::string> sample_names() {
  std::vector<std::string> names;
  for (const Recipe& recipe : recipes()) names.push_back(recipe.reader + "_" + recipe.name);
  return names;
}

Sample sample_input(std::size_t index) { return made(recipes().at(index)); }

}  // namespace remount::formats
