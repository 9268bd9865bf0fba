#include "remount/settings.h"

#include "api/python/python_parts.h"
#include "remount/error.h"
#include "remount/simulation.h"

namespace remount::python {
namespace {

py::dict option_dict(const api::Option& option) {
  py::dict out;
  out["name"] = option.name;
  out["value"] = option.value;
  out["unit"] = option.unit;
  out["meaning"] = words_of(option.meaning);
  out["minimum"] = option.minimum;
  out["maximum"] = option.maximum;
  out["choices"] = option.choices;
  return out;
}

py::list option_list(const std::vector<api::Option>& options) {
  py::list out;
  for (const api::Option& option : options) out.append(option_dict(option));
  return out;
}

api::Settings settings_with(const py::object& values) {
  api::Settings settings;
  for (const py::handle item : values.attr("items")()) {
    const auto name = py::str(item[py::int_(0)]).cast<std::string>();
    settings.set(name, option_value_of(item[py::int_(1)], name));
  }
  return settings;
}

py::dict settings_dict(const api::Settings& settings) {
  py::dict values;
  for (const api::Option& option : settings.all()) values[py::str(option.name)] = option.value;
  return values;
}

}  // namespace

api::OptionValue option_value_of(const py::handle& given, const std::string& name) {
  if (py::isinstance<py::str>(given)) return given.cast<std::string>();
  const auto numpy = py::module_::import("numpy");
  if (py::isinstance<py::bool_>(given) || py::isinstance(given, numpy.attr("bool_"))) return given.cast<bool>();
  // Arrays of one number and texts of bytes would be turned into numbers.
  const bool array = py::isinstance<py::array>(given) && py::reinterpret_borrow<py::array>(given).ndim() > 0;
  if (!array && !py::isinstance<py::bytes>(given)) {
    try {
      if (py::hasattr(given, "__index__")) return given.attr("__index__")().cast<std::int64_t>();
      if (py::hasattr(given, "__float__")) return given.attr("__float__")().cast<double>();
    } catch (const py::error_already_set&) {
    } catch (const py::cast_error&) {  // a whole number that is too large
    }
  }
  throw api::Error(api::ErrorCode::Contract, name,
                   "expected True or False, a number or a text, found " + py::repr(given).cast<std::string>());
}

api::Settings settings_of(const py::object& given) {
  if (given.is_none()) return {};
  if (py::isinstance<api::Settings>(given)) return given.cast<api::Settings>();
  if (!py::hasattr(given, "items")) throw py::type_error("expected Settings, a dict of names and values, or None");
  return settings_with(given);
}

void add_settings(py::module_& module) {
  py::class_<api::Settings>(module, "Settings")
      .def(py::init(&settings_with), py::arg("values") = py::dict())
      .def_static("load", &api::Settings::load, py::arg("path"))
      .def("__getitem__", &api::Settings::get)
      .def("__setitem__", [](api::Settings& settings, const std::string& name,
                             const py::object& value) { settings.set(name, option_value_of(value, name)); })
      .def("__contains__", [](const api::Settings& settings,
                              const std::string& name) { return settings_dict(settings).contains(name); })
      .def("__iter__", [](const api::Settings& settings) { return py::iter(settings_dict(settings)); })
      .def("__len__", [](const api::Settings& settings) { return settings.all().size(); })
      .def("keys", [](const api::Settings& settings) { return py::list(settings_dict(settings)); })
      .def("items", [](const api::Settings& settings) { return settings_dict(settings).attr("items")(); })
      .def("all", [](const api::Settings& settings) { return option_list(settings.all()); })
      .def("text", [](const api::Settings& settings) { return settings.text(); })
      .def("__repr__",
           [](const api::Settings& settings) {
             return "<remount.Settings, method " + std::get<std::string>(settings.get("run.method")) + ">";
           })
      .def(py::pickle(&settings_dict, [](const py::dict& values) { return settings_with(values); }));
  module.def("simulation_options", [] { return option_list(api::simulation_options()); });
}

}  // namespace remount::python
