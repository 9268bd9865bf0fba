#include <cmath>
#include <limits>

#include "api/python/python_parts.h"
#include "remount/calibrate.h"
#include "remount/error.h"
#include "remount/exporters.h"

namespace remount::python {
namespace {

using Stack = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::vector<std::string> sentences(const std::vector<api::Text>& texts) {
  std::vector<std::string> out;
  for (const api::Text& text : texts) out.push_back(words_of(text));
  return out;
}

api::Matrix4 unknown_motion() { return api::Matrix4::Constant(std::numeric_limits<double>::quiet_NaN()); }

/// (n, 6): translation (m) and rotation vector (rad); not a number where it is not known.
py::array_t<double> residual_rows(const std::vector<api::Pair>& pairs) {
  py::array_t<double> rows({pairs.size(), std::size_t{6}});
  auto values = rows.mutable_unchecked<2>();
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (int k = 0; k < 6; ++k)
      values(static_cast<py::ssize_t>(i), k) =
          pairs[i].motion ? pairs[i].motion->residual[k] : std::numeric_limits<double>::quiet_NaN();
  return rows;
}

template <class ValueOf>
py::list list_of(const std::vector<api::Pair>& pairs, const ValueOf& value_of) {
  py::list values;
  for (const api::Pair& pair : pairs) values.append(value_of(pair));
  return values;
}

py::object pair_array(const api::Result& result) {
  using api::Pair;
  const std::vector<Pair> pairs = result.pairs();
  std::vector<api::Matrix4> ins_motions, lidar_motions;
  for (const Pair& pair : pairs) {
    ins_motions.push_back(pair.motion ? pair.motion->ins_b_from_ins_a : unknown_motion());
    lidar_motions.push_back(pair.motion ? pair.motion->lidar_b_from_lidar_a : unknown_motion());
  }
  const auto number = [&](const char* name, double Pair::*member) {
    return ArrayColumn{name, "f8", list_of(pairs, [&](const Pair& pair) { return pair.*member; })};
  };
  const auto integer = [&](const char* name, auto Pair::*member) {
    return ArrayColumn{name, "i8", list_of(pairs, [&](const Pair& pair) { return pair.*member; })};
  };
  return structured_array(
      pairs.size(),
      {integer("session", &Pair::session),
       integer("stamp_a_ns", &Pair::stamp_a_ns),
       integer("stamp_b_ns", &Pair::stamp_b_ns),
       {"state", "U8", list_of(pairs, [](const Pair& pair) { return std::string(to_string(pair.state)); })},
       {"reason", "O", list_of(pairs, [](const Pair& pair) { return words_of(pair.reason); })},
       number("rotation_rad", &Pair::rotation_rad),
       number("baseline_m", &Pair::baseline_m),
       number("rmse_m", &Pair::rmse_m),
       number("overlap", &Pair::overlap),
       number("residual_rotation_rad", &Pair::residual_rotation_rad),
       number("residual_translation_m", &Pair::residual_translation_m),
       number("weight", &Pair::weight),
       {"ins_b_from_ins_a", "(4,4)f8", stacked(ins_motions)},
       {"lidar_b_from_lidar_a", "(4,4)f8", stacked(lidar_motions)},
       {"residual", "(6,)f8", residual_rows(pairs)}});
}

py::array_t<double> accepted_residuals(const api::Result& result) {
  std::vector<api::Pair> pairs = result.pairs();
  std::erase_if(pairs, [](const api::Pair& pair) { return pair.state != api::PairState::Accepted; });
  return residual_rows(pairs);
}

py::dict estimates_of(const api::Result& result) {
  py::dict estimates;
  for (const api::Parameter parameter : api::kParameters)
    estimates[py::str(std::string(to_string(parameter)))] = result.estimate(parameter);
  return estimates;
}

std::string value_text(double value, double sigma, bool angle) {
  const double unit = angle ? 180.0 / 3.14159265358979323846 : 1.0;
  char text[64];
  std::snprintf(text, sizeof text, "%.4f +- %.2g %s", unit * value, unit * sigma, angle ? "deg" : "m");
  return text;
}

std::string result_repr(const api::Result& result) {
  std::string text = "<remount.Result " + std::string(to_string(result.status()));
  if (result.usable()) text += ", " + result.reference_frame() + "_from_" + result.sensor_frame();
  for (const api::Parameter parameter : api::kParameters) {
    const api::Estimate estimate = result.estimate(parameter);
    text += "\n  " + std::string(to_string(parameter)) + " ";
    text += estimate.observed && estimate.sigma
                ? value_text(estimate.value, *estimate.sigma, parameter >= api::Parameter::Yaw)
                : "not observed";
  }
  return text + ">";
}

std::string estimate_repr(const api::Estimate& estimate) {
  if (!estimate.observed || !estimate.sigma) return "<not observed: " + words_of(estimate.why_not_observed) + ">";
  char text[64];
  std::snprintf(text, sizeof text, "<%.5f +- %.2g>", estimate.value, *estimate.sigma);
  return text;
}

api::CalibrateOptions options_of(const py::object& settings, const std::optional<api::Matrix4>& nominal_ins_from_lidar,
                                 int threads) {
  api::CalibrateOptions options;
  options.settings = settings_of(settings);
  options.nominal_ins_from_lidar = nominal_ins_from_lidar;
  options.threads = threads;
  return options;
}

std::vector<api::Session> sessions_of(const py::object& given) {
  if (py::isinstance<api::Session>(given)) return {given.cast<api::Session>()};
  std::vector<api::Session> sessions;
  const char* expected = "expected a Session or a list of them";
  if (!py::isinstance<py::iterable>(given)) throw py::type_error(expected);
  for (const py::handle session : given) {
    if (!py::isinstance<api::Session>(session)) throw py::type_error(expected);
    sessions.push_back(session.cast<api::Session>());
  }
  return sessions;
}

api::Result calibrate(const py::object& sessions, const py::object& settings,
                      const std::optional<api::Matrix4>& nominal_ins_from_lidar, bool ignore_declared_nominal,
                      bool hash_inputs, int threads, const py::object& progress) {
  const std::vector<api::Session> given = sessions_of(sessions);
  api::CalibrateOptions options = options_of(settings, nominal_ins_from_lidar, threads);
  options.ignore_declared_nominal = ignore_declared_nominal;
  options.hash_inputs = hash_inputs;
  const api::Progress told = progress_of(progress);
  return run_interruptibly(told, [&] { return api::calibrate(given, options, told); });
}

api::Result solve(const Stack& ins_b_from_ins_a, const Stack& lidar_b_from_lidar_a,
                  const std::optional<std::vector<std::size_t>>& a, const std::optional<std::vector<std::size_t>>& b,
                  const py::object& settings, const std::optional<api::Matrix4>& nominal_ins_from_lidar, int threads,
                  const py::object& progress) {
  const std::vector<api::Matrix4> p = unstacked(ins_b_from_ins_a, "ins_b_from_ins_a"),
                                  q = unstacked(lidar_b_from_lidar_a, "lidar_b_from_lidar_a");
  if (p.size() != q.size() || (a && a->size() != p.size()) || (b && b->size() != p.size()))
    throw api::Error(api::ErrorCode::Contract, "solve", "expected as many of each of P, Q, a and b");
  std::vector<api::MotionPair> pairs(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    pairs[i].ins_b_from_ins_a = p[i];
    pairs[i].lidar_b_from_lidar_a = q[i];
    if (a) pairs[i].a = (*a)[i];
    if (b) pairs[i].b = (*b)[i];
  }
  const api::CalibrateOptions options = options_of(settings, nominal_ins_from_lidar, threads);
  const api::Progress told = progress_of(progress);
  return run_interruptibly(told, [&] { return api::solve(pairs, options, told); });
}

void add_result_class(py::module_& module) {
  py::class_<api::Result>(module, "Result")
      .def_property_readonly("status", [](const api::Result& result) { return to_string(result.status()); })
      .def_property_readonly("message", [](const api::Result& result) { return words_of(result.message()); })
      .def_property_readonly("advice", [](const api::Result& result) { return sentences(result.advice()); })
      .def_property_readonly("usable", &api::Result::usable)
      .def_property_readonly("method", &api::Result::method)
      .def_property_readonly("ins_from_lidar", &api::Result::ins_from_lidar)
      .def_property_readonly("reference_from_sensor", &api::Result::reference_from_sensor)
      .def_property_readonly("reference_frame", &api::Result::reference_frame)
      .def_property_readonly("sensor_frame", &api::Result::sensor_frame)
      .def_property_readonly("covariance", &api::Result::covariance)
      .def_property_readonly("estimates", estimates_of)
      .def_property_readonly("pairs", pair_array)
      .def_property_readonly("residuals", accepted_residuals)
      .def_property_readonly("rotation_rms_rad", &api::Result::rotation_rms_rad)
      .def_property_readonly("translation_rms_m", &api::Result::translation_rms_m)
      .def_property_readonly("time_offset_s", [](const api::Result& result) { return result.time_offset().offset_s; })
      .def_property_readonly("time_offset_sigma_s",
                             [](const api::Result& result) { return result.time_offset().sigma_s; })
      .def_property_readonly("findings", &api::Result::findings)
      .def_property_readonly("settings", &api::Result::settings)
      .def("save", &api::Result::save, py::arg("path"), py::call_guard<py::gil_scoped_release>())
      .def(
          "export",
          [](const api::Result& result, const std::string& format, const std::string& ins_frame,
             const std::string& lidar_frame) {
            return api::export_text(result, format, {ins_frame, lidar_frame});
          },
          py::arg("format"), py::kw_only(), py::arg("ins_frame") = "", py::arg("lidar_frame") = "")
      .def_property_readonly("export_warnings",
                             [](const api::Result& result) { return sentences(api::export_warnings(result)); })
      .def("__repr__", result_repr);
  module.def("load_result", &api::Result::load, py::arg("path"), py::call_guard<py::gil_scoped_release>());
}

}  // namespace

void add_results(py::module_& module) {
  py::class_<api::Estimate>(module, "Estimate")
      .def_readonly("value", &api::Estimate::value)
      .def_readonly("sigma", &api::Estimate::sigma)
      .def_readonly("observed", &api::Estimate::observed)
      .def_readonly("measured", &api::Estimate::measured)
      .def_property_readonly("why_not_observed",
                             [](const api::Estimate& estimate) { return words_of(estimate.why_not_observed); })
      .def("__repr__", estimate_repr);
  add_result_class(module);
  module.def("calibrate", calibrate, py::arg("sessions"), py::kw_only(), py::arg("settings") = py::none(),
             py::arg("nominal_ins_from_lidar") = py::none(), py::arg("ignore_declared_nominal") = false,
             py::arg("hash_inputs") = true, py::arg("threads") = 0, py::arg("progress") = py::none());
  module.def("solve", solve, py::arg("ins_b_from_ins_a"), py::arg("lidar_b_from_lidar_a"), py::kw_only(),
             py::arg("a") = py::none(), py::arg("b") = py::none(), py::arg("settings") = py::none(),
             py::arg("nominal_ins_from_lidar") = py::none(), py::arg("threads") = 0, py::arg("progress") = py::none());
  module.def("export_formats", [] {
    py::dict formats;
    for (const api::ExportFormat& format : api::export_formats())
      formats[py::str(format.id)] = words_of(format.description);
    return formats;
  });
}

}  // namespace remount::python
