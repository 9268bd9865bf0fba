#include "model/formats/packets/velodyne_calibration.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "messages/captures.h"
#include "model/formats/documents/parse_document.h"
#include "model/formats/files/input_file.h"

namespace remount::formats {
namespace {

constexpr std::size_t kMostCalibrated = 256;

// With the name under which it is known in errors.
struct FactoryText {
  std::string_view text;
  const std::string& where;

  std::size_t line_at(std::size_t at) const {
    return 1 + static_cast<std::size_t>(std::count(
                   text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(at, text.size())), '\n'));
  }
  [[noreturn]] void fail(std::size_t at, const Message& what) const {
    throw Error(ErrorCode::Format, at_line(where, line_at(at)), what);
  }
  NumberInText number(std::string_view name, std::size_t begin, std::size_t end) const {
    const std::string_view shown = trim(text.substr(begin, end - begin));
    std::optional<double> value = parse_number(shown);  // lines are counted where one is to be named alone
    if (!value) value = require_number(shown, name, where, line_at(begin));
    return {static_cast<std::size_t>(shown.data() - text.data()), shown.size(), *value};
  }
};

// Elements of an XML text one after another, as boost writes them: numbers have no entities, and attributes no '>'.
class XmlWalk {
 public:
  struct Element {
    std::string_view name;
    std::size_t begin, contents;
  };

  explicit XmlWalk(const FactoryText& file) : file_(file) {}

  /// open(path) where an element begins, close(path, end of its contents) where it ends; the path ends with it.
  template <class Open, class Close>
  void run(Open&& open, Close&& close) {
    for (std::size_t at = next(0); at != std::string_view::npos; at = next(at)) {
      const std::size_t end = end_of(at, ">");
      std::string_view tag = file_.text.substr(at + 1, end - at - 2);
      if (tag.starts_with('/')) {
        tag = trim(tag.substr(1));
        if (path_.empty() || path_.back().name != tag)
          file_.fail(at, say::xml_closes_none(std::string(tag.substr(0, 40))));
        close(path_, at);
        path_.pop_back();
      } else if (!tag.ends_with('/')) {
        constexpr std::size_t kDeepest = 32;
        if (path_.size() == kDeepest) file_.fail(at, say::xml_too_deep(kDeepest));
        path_.push_back({tag.substr(0, tag.find_first_of(" \t\r\n")), at, end});
        open(path_);
      }
      at = end;
    }
    if (!path_.empty())
      file_.fail(path_.back().begin, say::xml_not_closed(std::string(path_.back().name.substr(0, 40))));
  }

 private:
  // The byte behind `closing`.
  std::size_t end_of(std::size_t at, std::string_view closing) const {
    const std::size_t end = file_.text.find(closing, at);
    if (end == std::string_view::npos) file_.fail(at, say::xml_not_closed(std::string(file_.text.substr(at, 20))));
    return end + closing.size();
  }
  // The next tag that is none of a comment or a declaration.
  std::size_t next(std::size_t at) const {
    while ((at = file_.text.find('<', at)) != std::string_view::npos) {
      const std::string_view rest = file_.text.substr(at);
      if (rest.starts_with("<!--"))
        at = end_of(at, "-->");
      else if (rest.starts_with("<?") || rest.starts_with("<!"))
        at = end_of(at, ">");
      else
        break;
    }
    return at;
  }

  const FactoryText& file_;
  std::vector<Element> path_;
};

constexpr double kFarthest_m = 10.0;

double sensible(const FactoryText& file, std::size_t at, double value, double most, const char* name) {
  if (!(std::abs(value) <= most)) file.fail(at, say::velodyne_number_outside(name, value, -most, most));
  return value;
}

// What bounds a LiDAR: beyond it another unit was meant.
void require_sensible(const FactoryText& file, const VelodyneCalibration& calibration, const CalibratedLaser& laser) {
  if (std::abs(laser.elevation.value) * calibration.elevation_unit_rad > kPi / 2.0)
    file.fail(laser.elevation.begin,
              say::velodyne_elevation_outside(Angle{laser.elevation.value * calibration.elevation_unit_rad}));
  for (const NumberInText& distance : laser.distances)
    if (std::abs(distance.value) * calibration.distance_unit_m > kFarthest_m)
      file.fail(distance.begin, say::velodyne_distance_outside(Length{distance.value * calibration.distance_unit_m},
                                                               Length{kFarthest_m}));
}

// A distance near along x or y that is 0 is none.
void add_distance(const NumberInText& distance, CalibratedLaser& laser) {
  if (laser.distances.empty() || distance.value != 0.0) laser.distances.push_back(distance);
}

constexpr std::string_view kNearDistances[] = {"distCorrectionX_", "distCorrectionY_"};

// Lasers of "db.xml", and which of them are in use.
class XmlLasers {
 public:
  explicit XmlLasers(const FactoryText& file) : file_(file) {}

  /// Of ranges; 0: the file does not say.
  double unit_cm() const { return unit_cm_; }
  void open(const std::vector<XmlWalk::Element>& path) {
    if (path.back().name == "px") fields_.clear();
  }
  void close(const std::vector<XmlWalk::Element>& path, std::size_t end) {
    const XmlWalk::Element& element = path.back();
    const std::string_view parent = path.size() > 1 ? path[path.size() - 2].name : std::string_view();
    if (element.name == "px") add(element.begin);
    if (element.name == "distLSB_" && parent == "DB")
      unit_cm_ = file_.number(element.name, element.contents, end).value;
    if (parent == "px") fields_[element.name] = {element.contents, end};
    if (parent == "enabled_" && element.name == "item") {
      if (in_use_.size() == kMostCalibrated) file_.fail(element.begin, say::velodyne_too_many(kMostCalibrated));
      in_use_.push_back(file_.number(element.name, element.contents, end).value != 0.0);
    }
  }
  std::vector<CalibratedLaser> taken() const {
    std::vector<CalibratedLaser> lasers;
    for (const auto& [id, laser] : lasers_)
      if (in_use_.empty() || (id < static_cast<double>(in_use_.size()) && in_use_[static_cast<std::size_t>(id)]))
        lasers.push_back(laser);
    return lasers;
  }

 private:
  NumberInText field(std::string_view name, std::size_t at) const {
    const auto found = fields_.find(name);
    if (found == fields_.end()) file_.fail(at, say::velodyne_laser_lacks(std::string(name)));
    return file_.number(name, found->second.first, found->second.second);
  }
  void add(std::size_t at) {
    CalibratedLaser laser;
    const double id = field("id_", at).value;
    if (id < 0.0 || id >= static_cast<double>(kMostCalibrated))
      file_.fail(at, say::velodyne_laser_id(id, kMostCalibrated - 1));
    laser.id = static_cast<std::size_t>(id);
    laser.elevation = field("vertCorrection_", at);
    add_distance(field("distCorrection_", at), laser);
    for (const std::string_view near : kNearDistances)
      if (fields_.contains(near)) add_distance(field(near, at), laser);
    const auto number = [&](std::string_view name) { return fields_.contains(name) ? field(name, at).value : 0.0; };
    laser.azimuth = sensible(file_, at, number("rotCorrection_"), 360.0, "rotCorrection_");
    laser.height = sensible(file_, at, number("vertOffsetCorrection_"), 100.0 * kFarthest_m, "vertOffsetCorrection_");
    laser.aside = sensible(file_, at, number("horizOffsetCorrection_"), 100.0 * kFarthest_m, "horizOffsetCorrection_");
    laser.near_x = number(kNearDistances[0]), laser.near_y = number(kNearDistances[1]);
    laser.two_points = laser.near_x != 0.0 || laser.near_y != 0.0;
    if (lasers_.size() == kMostCalibrated) file_.fail(at, say::velodyne_too_many(kMostCalibrated));
    lasers_.emplace_back(id, std::move(laser));
  }

  const FactoryText& file_;
  std::map<std::string_view, std::pair<std::size_t, std::size_t>> fields_;  // of the laser that is read
  std::vector<std::pair<double, CalibratedLaser>> lasers_;
  std::vector<bool> in_use_;
  double unit_cm_ = 0.0;
};

// Where the numbers of a key stand in a text of YAML, one after another. What was parsed says whether they are these.
class NumbersOfKey {
 public:
  NumbersOfKey(const FactoryText& file, std::string_view key) : file_(file), key_(key) {}

  NumberInText next(const DocumentView& item) {
    const double value = item.at(key_).number();
    const std::string opening = std::string(key_) + ":";
    while ((at_ = file_.text.find(opening, at_)) != std::string_view::npos) {
      const std::size_t begin = at_ + opening.size(),
                        end = std::min(file_.text.find_first_of(",}#\r\n", begin), file_.text.size());
      const bool whole = at_ == 0 || std::string_view(" \t\n{,").find(file_.text[at_ - 1]) != std::string_view::npos;
      at_ = begin;
      if (!whole) continue;
      const NumberInText number = file_.number(key_, begin, end);
      if (number.value != value) break;
      return number;
    }
    item.at(key_).fail(say::velodyne_yaml_written_otherwise(std::string(key_)));
  }

 private:
  const FactoryText& file_;
  std::string key_;
  std::size_t at_ = 0;
};

// What is read and not written.
void read_geometry(const DocumentView& item, CalibratedLaser& laser) {
  const auto number = [&](std::string_view name, double most) {
    if (!item.has(name)) return 0.0;
    const double value = item.at(name).number();
    if (!(std::abs(value) <= most))
      item.at(name).fail(say::velodyne_number_outside(std::string(name), value, -most, most));
    return value;
  };
  if (item.has("laser_id")) {
    const double id = item.at("laser_id").number();
    if (!(id >= 0.0 && id < kMostCalibrated)) item.at("laser_id").fail(say::velodyne_laser_id(id, kMostCalibrated - 1));
    laser.id = static_cast<std::size_t>(id);
  }
  laser.azimuth = number("rot_correction", 2.0 * kPi);
  laser.height = number("vert_offset_correction", kFarthest_m);
  laser.aside = number("horiz_offset_correction", kFarthest_m);
  laser.near_x = number("dist_correction_x", kFarthest_m), laser.near_y = number("dist_correction_y", kFarthest_m);
  const bool has_two = laser.near_x != 0.0 || laser.near_y != 0.0;
  laser.two_points =
      has_two && (!item.has("two_pt_correction_available") || item.at("two_pt_correction_available").boolean());
}

std::vector<CalibratedLaser> yaml_lasers(const FactoryText& file, double& unit_m) {
  const DocumentNode document = parse_yaml(file.text, file.where);
  const DocumentView root(document, file.where);
  std::vector<CalibratedLaser> lasers;
  NumbersOfKey elevations(file, "vert_correction"), distances(file, "dist_correction"),
      near_x(file, "dist_correction_x"), near_y(file, "dist_correction_y");
  if (root.has("distance_resolution")) unit_m = root.at("distance_resolution").number();
  for (const DocumentView& item : root.at("lasers").items()) {
    if (lasers.size() == kMostCalibrated) item.fail(say::velodyne_too_many(kMostCalibrated));
    CalibratedLaser laser;
    laser.elevation = elevations.next(item);
    laser.id = lasers.size();
    read_geometry(item, laser);
    add_distance(distances.next(item), laser);
    if (item.has("dist_correction_x")) add_distance(near_x.next(item), laser);
    if (item.has("dist_correction_y")) add_distance(near_y.next(item), laser);
    lasers.push_back(std::move(laser));
  }
  return lasers;
}

bool is_xml(std::string_view text) { return trim(text.substr(0, 4096)).starts_with('<'); }

}  // namespace

VelodyneCalibration read_velodyne_calibration(std::string text, const std::string& where) {
  VelodyneCalibration calibration;
  calibration.text = std::move(text);
  const FactoryText file{calibration.text, where};
  if (is_xml(file.text)) {
    calibration.elevation_unit_rad = degrees_to_radians(1.0), calibration.distance_unit_m = 0.01;
    XmlLasers lasers(file);
    XmlWalk(file).run([&](const auto& path) { lasers.open(path); },
                      [&](const auto& path, std::size_t end) { lasers.close(path, end); });
    calibration.lasers = lasers.taken();
    if (lasers.unit_cm() != 0.0) calibration.range_unit_m = 0.01 * lasers.unit_cm();
  } else {
    calibration.lasers = yaml_lasers(file, calibration.range_unit_m);
  }
  if (calibration.lasers.empty()) throw Error(ErrorCode::Format, where, say::velodyne_no_laser());
  if (!(calibration.range_unit_m >= 1e-4 && calibration.range_unit_m <= 0.1))
    throw Error(ErrorCode::Format, where, say::velodyne_unit_outside(calibration.range_unit_m));
  for (const CalibratedLaser& laser : calibration.lasers) require_sensible(file, calibration, laser);
  return calibration;
}

}  // namespace remount::formats
