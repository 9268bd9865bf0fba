#include "model/guesses/manifest.h"

#include <algorithm>
#include <set>

#include "algorithms/geometry/rotation.h"
#include "algorithms/messages/render.h"
#include "messages/guesses.h"
#include "model/drive/lidar_offer.h"
#include "model/formats/files/printable_text.h"
#include "model/formats/files/time_unit.h"

namespace remount::guesses {

namespace fs = std::filesystem;

namespace {

using formats::ColumnRef;
using formats::DocumentNode;
using formats::InsTableLayout;
using formats::TableText;
using formats::TimeColumns;
using formats::TimeScale;

Message kind_words(GuessKind kind) {
  switch (kind) {
    case GuessKind::Rows:
      return say::guess_kind_rows();
    case GuessKind::Time:
      return say::guess_kind_time();
    case GuessKind::Position:
      return say::guess_kind_position();
    case GuessKind::Attitude:
      return say::guess_kind_attitude();
    case GuessKind::PositionSigma:
      return say::guess_kind_position_sigma();
    case GuessKind::AttitudeSigma:
      return say::guess_kind_attitude_sigma();
    case GuessKind::Quality:
      return say::guess_kind_quality();
    case GuessKind::Scans:
      return say::guess_kind_scans();
    case GuessKind::Stamps:
      return say::guess_kind_stamps();
    case GuessKind::Timing:
      return say::guess_kind_timing();
    default:
      return say::guess_kind_clock();
  }
}

class ManifestWriter {
 public:
  ManifestWriter(const Description& description, const fs::path& folder, Language language)
      : description_(description), folder_(folder.empty() ? "." : folder), language_(language) {}

  DocumentNode write() {
    DocumentNode root = DocumentNode::map();
    DocumentNode& format = root.add("format", DocumentNode::string("remount-session/1"));
    format.comment = head();
    root.add("name", DocumentNode::string(name()));
    const std::vector<ScansGuess>& lidars = description_.lidars;
    if (lidars.size() == 1) {
      add_lidar(lidars.front(), root);
    } else if (!lidars.empty()) {
      DocumentNode& several = root.add("lidars", DocumentNode::map());
      for (const ScansGuess& lidar : lidars) add_lidar(lidar, several.add(lidar_name(lidar), DocumentNode::map()));
    }
    if (description_.ins) add_ins(*description_.ins, root);
    return root;
  }

 private:
  /// What could end a comment is escaped.
  std::string words(const Message& message) const {
    return formats::printable(render(message, language_), formats::LineBreaks::Escaped);
  }
  std::string path(const fs::path& file) const {
    const fs::path relative = fs::weakly_canonical(file).lexically_relative(fs::weakly_canonical(folder_));
    return relative.empty() ? file.string() : relative.string();
  }
  std::string name() const {
    const std::string folder = fs::weakly_canonical(folder_).filename().string();
    return folder.empty() ? "drive" : folder;
  }

  std::string head() const {
    std::string text = words(say::guess_manifest_head()) + "\n";
    for (const Message& missing : description_.missing) text += words(say::guess_manifest_missing(missing)) + "\n";
    constexpr std::size_t kMostShown = 20;
    for (std::size_t i = 0; i < std::min(description_.not_used.size(), kMostShown); ++i) {
      const NotUsed& one = description_.not_used[i];
      text += words(say::guess_manifest_not_used(path(one.path), one.why)) + "\n";
    }
    return text;
  }

  std::string comment(const Guess& guess) const {
    const Message sureness = guesses::words(guess.sureness);
    std::string text = guess.columns.empty()
                           ? words(say::guess_line(kind_words(guess.kind), sureness))
                           : words(say::guess_line_of_columns(kind_words(guess.kind), guess.columns, sureness));
    text += "\n";
    for (const Message& evidence : guess.evidence) text += "  " + words(evidence) + "\n";
    for (const Message& alternative : guess.alternatives) text += "  " + words(say::guess_or(alternative)) + "\n";
    return text;
  }
  std::string comments(const std::vector<Guess>& guesses, std::initializer_list<GuessKind> kinds) const {
    std::string text;
    for (const Guess& guess : guesses)
      if (std::ranges::find(kinds, guess.kind) != kinds.end()) text += comment(guess);
    return text;
  }

  /// Letters, digits, '_' and '-', and no name twice.
  std::string lidar_name(const ScansGuess& lidar) {
    std::string name = lidar.name.substr(0, drive::kLongestLidarName - 4);
    for (char& c : name)
      if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-'))
        c = '_';
    if (name.empty()) name = "lidar";
    std::string free = name;
    for (int i = 2; !names_.insert(free).second; ++i) free = name + "_" + std::to_string(i);
    return free;
  }

  static DocumentNode column(const ColumnRef& ref) {
    return ref.name.empty() ? DocumentNode::integer(static_cast<std::int64_t>(ref.index))
                            : DocumentNode::string(ref.name);
  }
  static void add_named(const ColumnRef& ref, DocumentNode& node) {
    node.add(ref.name.empty() ? "index" : "name", column(ref));
  }
  static DocumentNode one_line() {
    DocumentNode node = DocumentNode::map();
    node.on_one_line = true;
    return node;
  }

  static void add_table(const TableText& text, DocumentNode& node) {
    if (text.separator == ',' && text.skip_lines == 0 && !text.no_value) return;
    DocumentNode& table = node.add("table", one_line());
    const char* separator = text.separator == ';'    ? "semicolon"
                            : text.separator == '\t' ? "tab"
                            : text.separator == ' '  ? "blanks"
                            : text.separator == '|'  ? "bar"
                                                     : "comma";
    table.add("separator", DocumentNode::string(separator));
    if (text.decimal_commas) table.add("decimals", DocumentNode::string("comma"));
    if (text.skip_lines > 0) table.add("skip_lines", DocumentNode::integer(static_cast<std::int64_t>(text.skip_lines)));
    if (text.no_value) table.add("no_value", DocumentNode::number(*text.no_value));
  }

  static std::string unit_name(std::int64_t unit_ns) { return std::string(formats::time_unit_name(unit_ns)); }

  static DocumentNode time_node(const TimeColumns& time) {
    DocumentNode node = one_line();
    add_named(time.time, node);
    node.add("unit", DocumentNode::string(time.is_date ? "date" : unit_name(time.time_unit_ns)));
    node.add("scale", DocumentNode::string(time.time_scale == TimeScale::Unix  ? "unix"
                                           : time.time_scale == TimeScale::Gps ? "gps"
                                                                               : "gps-week"));
    if (time.gps_week) node.add("week", column(*time.gps_week));
    if (time.day) node.add("day", column(*time.day));
    if (time.calendar) {
      const auto& [year, month, day, hour, minute] = *time.calendar;
      for (const auto& [key, ref] :
           {std::pair("year", &year), {"month", &month}, {"day", &day}, {"hour", &hour}, {"minute", &minute}})
        node.add(key, column(*ref));
    }
    if (time.date_order != formats::DateOrder::YearFirst)
      node.add("order", DocumentNode::string(std::string(date_order_name(time.date_order))));
    if (time.nanoseconds)
      node.add(time.rest_unit_ns == 1       ? "nanoseconds"
               : time.rest_unit_ns == 1'000 ? "microseconds"
                                            : "milliseconds",
               column(*time.nanoseconds));
    if (time.offset_ns != 0) node.add("offset_s", DocumentNode::number(1e-9 * static_cast<double>(time.offset_ns)));
    return node;
  }

  void add_lidar(const ScansGuess& lidar, DocumentNode& node) const {
    if (lidar.pose_format) {
      DocumentNode& poses = node.add("lidar_poses", one_line());
      poses.comment = comments(lidar.guesses, {GuessKind::Scans});
      poses.add("file", DocumentNode::string(path(lidar.directory)));
      poses.add("format", DocumentNode::string(*lidar.pose_format));
      return;
    }
    DocumentNode& scans = node.add("scans", DocumentNode::map());
    scans.comment = comments(lidar.guesses, {GuessKind::Scans});
    if (lidar.capture) {
      scans.add("capture", DocumentNode::string(path(lidar.directory)));
      return;
    }
    scans.add("directory", DocumentNode::string(path(lidar.directory)));
    scans.add("type", DocumentNode::string(type_name(lidar.format)));
    if (lidar.timed) scans.add("stamps", stamps(lidar)).comment = comments(lidar.guesses, {GuessKind::Stamps});
    scans.add("timing", DocumentNode::string(lidar.per_point ? "per-point" : "unknown")).comment =
        comments(lidar.guesses, {GuessKind::Timing});
  }

  DocumentNode stamps(const ScansGuess& lidar) const {
    if (lidar.stamps) return DocumentNode::string(path(*lidar.stamps));
    if (lidar.in_names) {
      DocumentNode names = one_line();
      names.add("names", DocumentNode::string(unit_name(lidar.in_names->unit_ns)));
      if (lidar.in_names->offset_ns != 0)
        names.add("offset_s", DocumentNode::number(1e-9 * static_cast<double>(lidar.in_names->offset_ns)));
      return names;
    }
    if (lidar.in_points) return DocumentNode::string("from-points");
    if (!lidar.table) return DocumentNode::string("from-names");
    DocumentNode table = DocumentNode::map();
    table.add("file", DocumentNode::string(path(lidar.table->table)));
    add_table(lidar.table->text, table);
    table.add("time", time_node(lidar.table->time));
    if (lidar.table->scan) table.add("scan", column(*lidar.table->scan));
    return table;
  }

  void add_ins(const InsGuess& ins, DocumentNode& root) const {
    const bool metric = ins.pose_format || (!ins.log && ins.layout.metric_position);
    DocumentNode& node = root.add(metric ? "ins_poses" : "ins", DocumentNode::map());
    node.comment = (description_.clock ? comment(*description_.clock) : "") + comments(ins.guesses, {GuessKind::Rows});
    node.add("file", DocumentNode::string(path(ins.file)));
    if (ins.pose_format) node.add("format", DocumentNode::string(*ins.pose_format));
    if (ins.log || ins.pose_format) return;
    add_table(ins.layout.text, node);
    DocumentNode& columns = node.add("columns", DocumentNode::map());
    columns.add("time", time_node(ins.layout)).comment = comments(ins.guesses, {GuessKind::Time});
    add_position(ins, columns);
    if (!ins.attitude)
      columns.add("attitude", attitude(ins.layout)).comment = comments(ins.guesses, {GuessKind::Attitude});
    if (ins.layout.position_sigma_enu)
      columns.add("position_sigma_m", three({"east", "north", "up"}, *ins.layout.position_sigma_enu)).comment =
          comments(ins.guesses, {GuessKind::PositionSigma});
    if (ins.layout.attitude_sigma_yaw_pitch_roll)
      columns.add("attitude_sigma", three({"yaw", "pitch", "roll"}, *ins.layout.attitude_sigma_yaw_pitch_roll))
          .comment = comments(ins.guesses, {GuessKind::AttitudeSigma});
    if (ins.layout.quality)
      columns.add("quality", column(*ins.layout.quality)).comment = comments(ins.guesses, {GuessKind::Quality});
    if (ins.attitude) add_attitudes(*ins.attitude, node);
  }

  void add_attitudes(const AttitudeGuess& attitudes, DocumentNode& ins) const {
    const formats::InsTableLayout& layout = attitudes.layout;
    DocumentNode& node = ins.add("attitude", DocumentNode::map());
    node.comment = comments(attitudes.guesses, {GuessKind::Rows});
    node.add("file", DocumentNode::string(path(attitudes.file)));
    add_table(layout.text, node);
    DocumentNode& columns = node.add("columns", DocumentNode::map());
    columns.add("time", time_node(layout)).comment = comments(attitudes.guesses, {GuessKind::Time});
    columns.add("attitude", attitude(layout)).comment = comments(attitudes.guesses, {GuessKind::Attitude});
    if (layout.attitude_sigma_yaw_pitch_roll)
      columns.add("attitude_sigma", three({"yaw", "pitch", "roll"}, *layout.attitude_sigma_yaw_pitch_roll)).comment =
          comments(attitudes.guesses, {GuessKind::AttitudeSigma});
  }

  static DocumentNode three(const std::array<const char*, 3>& keys, const std::array<ColumnRef, 3>& refs) {
    DocumentNode node = one_line();
    for (std::size_t i = 0; i < 3; ++i) node.add(keys[i], column(refs[i]));
    return node;
  }

  void add_position(const InsGuess& ins, DocumentNode& columns) const {
    const InsTableLayout& layout = ins.layout;
    const std::string said = comments(ins.guesses, {GuessKind::Position});
    if (layout.metric_position) {
      columns.add("position", three({"east", "north", layout.metric_down ? "down" : "up"}, *layout.metric_position))
          .comment = said;
      return;
    }
    const auto add = [&](const char* key, const ColumnRef& ref, const std::optional<ColumnRef>& side,
                         double sign) -> DocumentNode& {
      DocumentNode& node = columns.add(key, one_line());
      add_named(ref, node);
      node.add("unit", DocumentNode::string(std::string(to_string(layout.position_unit))));
      if (side) node.add("side", column(*side));
      if (sign < 0.0) node.add("negated", DocumentNode::boolean(true));
      return node;
    };
    add("latitude", layout.latitude, layout.latitude_side, layout.place_signs[0]).comment = said;
    add("longitude", layout.longitude, layout.longitude_side, layout.place_signs[1]);
    DocumentNode& height = columns.add("height", one_line());
    add_named(layout.height, height);
    height.add("unit", DocumentNode::string("m"));
  }

  static DocumentNode attitude(const InsTableLayout& layout) {
    DocumentNode node = one_line();
    std::size_t i = 0;
    if (layout.quaternion) {
      node.add("convention", DocumentNode::string(drive::to_string(*layout.quaternion)));
      for (const char* key : {"x", "y", "z", "w"}) node.add(key, column(layout.quaternion_xyzw[i++]));
      return node;
    }
    node.add("convention", DocumentNode::string(drive::to_string(layout.attitude)));
    node.add("unit", DocumentNode::string(layout.attitude_unit_rad == 1.0 ? "rad" : "deg"));
    DocumentNode negated = DocumentNode::sequence();
    for (const char* key : {"yaw", "pitch", "roll"}) {
      if (layout.yaw_pitch_roll_signs[i] < 0.0) negated.add(DocumentNode::string(key));
      node.add(key, column(layout.yaw_pitch_roll[i++]));
    }
    if (!negated.items.empty()) node.add("negated", std::move(negated));
    return node;
  }

  const Description& description_;
  const fs::path folder_;
  const Language language_;
  std::set<std::string> names_;
};

}  // namespace

DocumentNode manifest_of(const Description& description, const fs::path& folder, Language language) {
  return ManifestWriter(description, folder, language).write();
}

}  // namespace remount::guesses
