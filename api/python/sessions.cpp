#include <limits>
#include <span>

#include "api/python/python_parts.h"
#include "remount/error.h"
#include "remount/registration.h"
#include "remount/settings.h"
#include "remount/simulation.h"

namespace remount::python {
namespace {

using Stamps = py::object;
using Stack = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::vector<api::Pose> poses_of(const std::pair<Stamps, Stack>& given, const std::string& name) {
  const std::vector<api::Matrix4> matrices = unstacked(given.second, name);
  const std::vector<std::int64_t> stamps_ns = stamps_of(given.first, name);
  if (stamps_ns.size() != matrices.size())
    throw api::Error(api::ErrorCode::Contract, name, "expected one stamp for each transform");
  std::vector<api::Pose> poses;
  for (std::size_t i = 0; i < matrices.size(); ++i) poses.push_back({stamps_ns[i], matrices[i]});
  return poses;
}

py::tuple stamped(const std::vector<api::Pose>& poses) {
  py::array_t<std::int64_t> stamps_ns(static_cast<py::ssize_t>(poses.size()));
  std::vector<api::Matrix4> matrices;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    stamps_ns.mutable_at(static_cast<py::ssize_t>(i)) = poses[i].stamp_ns;
    matrices.push_back(poses[i].pose);
  }
  return py::make_tuple(stamps_ns, stacked(matrices));
}

/// What a loader raised, as the library tells it. An interrupt goes on as one, where the main thread looks for it.
api::Error error_of(const py::error_already_set& raised, const std::string& where) {
  if (raised.matches(PyExc_KeyboardInterrupt)) PyErr_SetInterrupt();
  if (raised.matches(py::module_::import("remount.errors").attr("Error"))) {
    const auto part = [&](const char* name) { return py::str(raised.value().attr(name)).cast<std::string>(); };
    for (const api::ErrorCode code : {api::ErrorCode::Format, api::ErrorCode::Unsupported, api::ErrorCode::Contract})
      if (part("code") == to_string(code)) return {code, part("place"), part("expectation")};
    return {api::ErrorCode::Io, part("place"), part("expectation")};
  }
  const auto type = py::str(raised.type().attr("__name__")).cast<std::string>();
  const auto said = py::str(raised.value()).cast<std::string>();
  return {api::ErrorCode::Io, where, said.empty() ? type : type + ": " + said};
}

/// Scans that a function of Python loads; its owner may end without Python's lock.
class PythonScans final : public api::ScanSource {
 public:
  PythonScans(std::vector<std::int64_t> stamps_ns, py::object load)
      : stamps_ns_(std::move(stamps_ns)), load_(std::move(load)) {}
  PythonScans(const PythonScans&) = delete;
  PythonScans& operator=(const PythonScans&) = delete;
  ~PythonScans() override {
    const py::gil_scoped_acquire locked;
    load_ = py::object();
  }

  std::size_t size() const override { return stamps_ns_.size(); }
  std::int64_t stamp_ns(std::size_t scan) const override { return stamps_ns_.at(scan); }
  api::Scan load(std::size_t scan) const override {
    const py::gil_scoped_acquire locked;
    try {
      return scan_of(load_(scan), name(scan));
    } catch (const py::error_already_set& raised) {
      throw error_of(raised, name(scan));
    }
  }

 private:
  std::vector<std::int64_t> stamps_ns_;
  py::object load_;
};

api::ScanTimes scan_times_of(const std::string& name) {
  if (name == "at_stamp") return api::ScanTimes::AtStamp;
  if (name == "per_point") return api::ScanTimes::PerPoint;
  if (name == "unknown") return api::ScanTimes::Unknown;
  throw api::Error(api::ErrorCode::Contract, name, "expected \"at_stamp\", \"per_point\" or \"unknown\"");
}

using InsArrays = std::tuple<Stamps, Stack, Stack>;

/// Stamps, positions (latitude, longitude, height) and quaternions.
std::vector<api::InsSample> samples_of(const InsArrays& given) {
  const auto& [stamps, positions, xyzw] = given;
  const std::vector<std::int64_t> stamps_ns = stamps_of(stamps, "ins");
  const auto rows = static_cast<py::ssize_t>(stamps_ns.size());
  const bool columns = positions.ndim() == 2 && xyzw.ndim() == 2 && positions.shape(1) == 3 && xyzw.shape(1) == 4;
  if (!columns || positions.shape(0) != rows || xyzw.shape(0) != rows)
    throw api::Error(api::ErrorCode::Contract, "ins",
                     "expected stamps (n,), positions (n, 3): latitude and longitude in rad and height in m, and "
                     "quaternions enu_from_ins (n, 4): x, y, z, w");
  std::vector<api::InsSample> samples(stamps_ns.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto row = static_cast<py::ssize_t>(i);
    samples[i].stamp_ns = stamps_ns[i];
    samples[i].latitude_rad = positions.at(row, 0);
    samples[i].longitude_rad = positions.at(row, 1);
    samples[i].height_m = positions.at(row, 2);
    for (int k = 0; k < 4; ++k) samples[i].enu_from_ins_xyzw[k] = xyzw.at(row, k);
  }
  return samples;
}

api::Session make_session(const std::string& name, const std::optional<InsArrays>& ins,
                          const std::optional<std::pair<Stamps, Stack>>& world_from_ins,
                          const py::object& scan_stamps_ns, const py::object& load_scan, const std::string& scan_times,
                          const std::optional<std::pair<Stamps, Stack>>& odometry,
                          const std::optional<api::Matrix4>& nominal_ins_from_lidar, const py::object& progress) {
  api::Recording recording;
  recording.name = name;
  if (ins) recording.ins = samples_of(*ins);
  if (world_from_ins) recording.world_from_ins = poses_of(*world_from_ins, "world_from_ins");
  if (!load_scan.is_none())
    recording.scans = std::make_shared<PythonScans>(stamps_of(scan_stamps_ns, "scan_stamps_ns"), load_scan);
  recording.scan_times = scan_times_of(scan_times);
  if (odometry) recording.odometry_from_lidar = poses_of(*odometry, "odometry_from_lidar");
  recording.nominal_ins_from_lidar = nominal_ins_from_lidar;
  const api::Progress told = progress_of(progress);
  return run_interruptibly(told, [&] { return api::make_session(recording, told); });
}

template <class Value>
py::object column_of(const std::vector<Value>& values) {
  if (values.empty()) return py::none();
  return py::array_t<Value>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::dict scan_columns(const api::Session& session, std::size_t scan) {
  const api::Scan loaded = [&] {
    const py::gil_scoped_release unlocked;
    return session.load_scan(scan);
  }();
  py::dict columns;
  columns["points"] = points_of(loaded);
  columns["time_from_stamp_s"] = column_of(loaded.time_from_stamp_s);
  columns["intensity"] = column_of(loaded.intensity);
  columns["ring"] = column_of(loaded.ring);
  return columns;
}

py::object keyframes_of(const api::Session& session, const py::object& settings) {
  const api::Settings chosen = settings_of(settings);
  const std::vector<api::Keyframe> keyframes = [&] {
    const py::gil_scoped_release unlocked;
    return session.keyframes(chosen);
  }();
  py::list scans, stamps_ns, travelled_m;
  for (const api::Keyframe& keyframe : keyframes) {
    scans.append(keyframe.scan);
    stamps_ns.append(keyframe.stamp_ns);
    travelled_m.append(keyframe.travelled_m);
  }
  return structured_array(keyframes.size(),
                          {{"scan", "i8", scans}, {"stamp_ns", "i8", stamps_ns}, {"travelled_m", "f8", travelled_m}});
}

/// Throws api::Error(Contract) for what is no column.
template <class Value>
py::array_t<Value, py::array::c_style | py::array::forcecast> column_as(const py::object& given,
                                                                        const std::string& name) {
  const py::array_t<Value, py::array::c_style | py::array::forcecast> values(given);
  if (values.ndim() != 1) throw api::Error(api::ErrorCode::Contract, name, "expected one number for each point, (n,)");
  return values;
}

std::vector<float> numbers_of(const py::object& column, const std::string& name) {
  if (column.is_none()) return {};
  const auto values = column_as<float>(column, name);
  return {values.data(), values.data() + values.size()};
}

/// Throws api::Error(Contract) where a number is none of a ring.
std::vector<std::uint16_t> rings_of(const py::object& column, const std::string& name) {
  if (column.is_none()) return {};
  const auto values = column_as<double>(column, name);
  std::vector<std::uint16_t> rings;
  for (const double value : std::span(values.data(), static_cast<std::size_t>(values.size()))) {
    if (!(value >= 0.0 && value <= std::numeric_limits<std::uint16_t>::max()))
      throw api::Error(api::ErrorCode::Contract, name, "expected numbers from 0 to 65535");
    rings.push_back(static_cast<std::uint16_t>(value));
  }
  return rings;
}

std::string session_repr(const api::Session& session) {
  std::string text = "<remount.Session " + session.name() + " (" + session.format() + ")";
  for (const api::Stream& stream : session.sensors()) text += ", " + stream.sensor + " " + std::to_string(stream.count);
  return text + ">";
}

void add_values(py::module_& module) {
  py::class_<api::Finding>(module, "Finding")
      .def_property_readonly("severity", [](const api::Finding& finding) { return to_string(finding.severity); })
      .def_readonly("code", &api::Finding::code)
      .def_property_readonly("place", [](const api::Finding& finding) { return words_of(finding.place); })
      .def_property_readonly("explanation", [](const api::Finding& finding) { return words_of(finding.explanation); })
      .def("__repr__", [](const api::Finding& finding) {
        return "<" + std::string(to_string(finding.severity)) + " " + finding.code + ": " +
               words_of(finding.explanation) + ">";
      });
  py::class_<api::Stream>(module, "Stream")
      .def_readonly("sensor", &api::Stream::sensor)
      .def_readonly("count", &api::Stream::count)
      .def_readonly("first_ns", &api::Stream::first_ns)
      .def_readonly("last_ns", &api::Stream::last_ns)
      .def_readonly("rate_hz", &api::Stream::rate_hz)
      .def_readonly("gaps", &api::Stream::gaps)
      .def_readonly("longest_gap_s", &api::Stream::longest_gap_s)
      .def("__repr__",
           [](const api::Stream& stream) { return "<" + stream.sensor + ": " + std::to_string(stream.count) + ">"; });
  py::class_<api::Registration>(module, "Registration")
      .def_readonly("target_from_source", &api::Registration::target_from_source)
      .def_readonly("converged", &api::Registration::converged)
      .def_readonly("iterations", &api::Registration::iterations)
      .def_readonly("rmse_m", &api::Registration::rmse_m)
      .def_readonly("overlap", &api::Registration::overlap)
      .def_readonly("information", &api::Registration::information)
      .def_property_readonly("failure", [](const api::Registration& found) { return words_of(found.failure); })
      .def_property_readonly("undetermined",
                             [](const api::Registration& found) { return words_of(found.undetermined); })
      .def("__repr__", [](const api::Registration& found) {
        return "<remount.Registration, overlap " + std::to_string(found.overlap) + ", rmse " +
               std::to_string(found.rmse_m) + " m>";
      });
}

api::Registration register_arrays(const py::object& source, const py::object& target,
                                  const std::optional<api::Matrix4>& start, const py::object& settings,
                                  const py::object& progress) {
  const api::Settings chosen = settings_of(settings);
  const api::Scan source_scan = scan_of(source, "source"), target_scan = scan_of(target, "target");
  const api::Matrix4 begin = start.value_or(api::Matrix4::Identity());
  const api::Progress told = progress_of(progress);
  return run_interruptibly(told, [&] { return api::register_scans(source_scan, target_scan, begin, chosen, told); });
}

void add_simulation(py::module_& module) {
  py::class_<api::SimulatedDrive>(module, "SimulatedDrive")
      .def_property_readonly("session", &api::SimulatedDrive::session)
      .def_property_readonly("ins_from_lidar", &api::SimulatedDrive::ins_from_lidar)
      .def_property_readonly("enu_from_ins",
                             [](const api::SimulatedDrive& drive) { return stamped(drive.enu_from_ins()); })
      .def(
          "write",
          [](const api::SimulatedDrive& drive, const std::filesystem::path& folder, const std::string& format,
             const py::object& progress) {
            const api::Progress told = progress_of(progress);
            run_interruptibly(told, [&] { api::write_drive(drive, folder, format, told); });
          },
          py::arg("folder"), py::arg("format") = "native", py::arg("progress") = py::none())
      .def("__repr__", [](const api::SimulatedDrive& drive) {
        return "<remount.SimulatedDrive, " + std::to_string(drive.session().scan_count()) + " scans>";
      });
  module.def(
      "simulate",
      [](const std::optional<api::Matrix4>& ins_from_lidar, const py::kwargs& options) {
        std::map<std::string, api::OptionValue> values;
        for (const auto& [name, value] : options) {
          const auto text = name.cast<std::string>();
          values.emplace(text, option_value_of(value, text));
        }
        const py::gil_scoped_release unlocked;
        return api::simulate(values, ins_from_lidar);
      },
      py::kw_only(), py::arg("ins_from_lidar") = py::none());
  module.def("drive_formats", api::drive_formats);
}

}  // namespace

std::vector<std::int64_t> stamps_of(const py::object& given, const std::string& name) {
  const py::array array = py::array::ensure(given);
  if (array && array.ndim() == 1 && array.size() == 0) return {};  // NumPy calls what has nothing in it numbers
  if (!array || array.ndim() != 1 || (array.dtype().kind() != 'i' && array.dtype().kind() != 'u'))
    throw api::Error(api::ErrorCode::Contract, name, "expected stamps as whole nanoseconds: integers, (n,)");
  const py::array_t<std::int64_t, py::array::c_style | py::array::forcecast> stamps_ns(array);
  return {stamps_ns.data(), stamps_ns.data() + stamps_ns.size()};
}

py::array_t<float> points_of(const api::Scan& scan) {
  py::array_t<float> points({scan.points_in_lidar.size(), std::size_t{3}});
  auto values = points.mutable_unchecked<2>();
  for (std::size_t i = 0; i < scan.points_in_lidar.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) values(static_cast<py::ssize_t>(i), axis) = scan.points_in_lidar[i][axis];
  return points;
}

api::Scan scan_of(const py::object& given, const std::string& name) {
  const bool columns = py::isinstance<py::dict>(given);
  const auto column = [&](const char* key) -> py::object {
    const py::dict dictionary = columns ? py::dict(given) : py::dict();
    return dictionary.contains(key) ? py::object(dictionary[key]) : py::object(py::none());
  };
  const py::array_t<float, py::array::c_style | py::array::forcecast> points(columns ? column("points") : given);
  if (points.ndim() != 2 || points.shape(1) != 3)
    throw api::Error(api::ErrorCode::Contract, name, "expected points as an array of (n, 3), m");
  api::Scan scan;
  const auto values = points.unchecked<2>();
  for (py::ssize_t i = 0; i < points.shape(0); ++i)
    scan.points_in_lidar.emplace_back(values(i, 0), values(i, 1), values(i, 2));
  scan.time_from_stamp_s = numbers_of(column("time_from_stamp_s"), name + ": time_from_stamp_s");
  scan.intensity = numbers_of(column("intensity"), name + ": intensity");
  scan.ring = rings_of(column("ring"), name + ": ring");
  return scan;
}

void add_sessions(py::module_& module) {
  add_values(module);
  py::class_<api::Session>(module, "Session")
      .def_property_readonly("name", &api::Session::name)
      .def_property_readonly("path",
                             [](const api::Session& session) -> std::optional<std::filesystem::path> {
                               if (session.path().empty()) return std::nullopt;
                               return session.path();
                             })
      .def_property_readonly("format", &api::Session::format)
      .def_property_readonly("lidar", &api::Session::lidar)
      .def_property_readonly("nominal_ins_from_lidar", &api::Session::nominal_ins_from_lidar)
      .def_property_readonly("sensors", &api::Session::sensors)
      .def_property_readonly("findings", &api::Session::findings)
      .def_property_readonly("local_from_ins",
                             [](const api::Session& session) {
                               return stamped([&] {
                                 const py::gil_scoped_release unlocked;
                                 return session.local_from_ins();
                               }());
                             })
      .def("keyframes", keyframes_of, py::arg("settings") = py::none())
      .def("scan", scan_columns, py::arg("scan"))
      .def("scan_stamp_ns", &api::Session::scan_stamp_ns, py::arg("scan"))
      .def("__len__", &api::Session::scan_count)
      .def("__repr__", session_repr);
  module.def(
      "open",
      [](const std::filesystem::path& path, const std::string& lidar, const std::map<std::string, std::string>& topics,
         const py::object& progress) {
        const api::Progress told = progress_of(progress);
        return run_interruptibly(told, [&] { return api::open_session(path, {lidar, topics}, told); });
      },
      py::arg("path"), py::kw_only(), py::arg("lidar") = "", py::arg("topics") = std::map<std::string, std::string>(),
      py::arg("progress") = py::none());
  module.def(
      "lidars_of",
      [](const std::filesystem::path& path, const py::object& progress) {
        const api::Progress told = progress_of(progress);
        return run_interruptibly(told, [&] { return api::lidars_of(path, told); });
      },
      py::arg("path"), py::kw_only(), py::arg("progress") = py::none());
  module.def("make_session", make_session, py::arg("name"), py::kw_only(), py::arg("ins") = py::none(),
             py::arg("world_from_ins") = py::none(), py::arg("scan_stamps_ns") = py::tuple(),
             py::arg("load_scan") = py::none(), py::arg("scan_times") = "at_stamp",
             py::arg("odometry_from_lidar") = py::none(), py::arg("nominal_ins_from_lidar") = py::none(),
             py::arg("progress") = py::none());
  module.def("register", register_arrays, py::arg("source"), py::arg("target"), py::kw_only(),
             py::arg("target_from_source_start") = py::none(), py::arg("settings") = py::none(),
             py::arg("progress") = py::none());
  add_simulation(module);
}

}  // namespace remount::python
