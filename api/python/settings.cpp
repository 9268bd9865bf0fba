#include "remount/settings.h"

#include "api/python/python_parts.h"
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

api::Settings settings_with(const std::map<std::string, api::OptionValue>& values) {
  api::Settings settings;
  for (const auto& [name, value] : values) settings.set(name, value);
  return settings;
}

}  // namespace

void add_settings(py::module_& module) {
  py::class_<api::Settings>(module, "Settings")
      .def(py::init(&settings_with), py::arg("values") = std::map<std::string, api::OptionValue>())
      .def_static("load", &api::Settings::load, py::arg("path"))
      .def("__getitem__", &api::Settings::get)
      .def("__setitem__", [](api::Settings& settings, const std::string& name,
                             const api::OptionValue& value) { settings.set(name, value); })
      .def("all", [](const api::Settings& settings) { return option_list(settings.all()); })
      .def("text", [](const api::Settings& settings) { return settings.text(); })
      .def("__repr__", [](const api::Settings& settings) {
        return "<remount.Settings, method " + std::get<std::string>(settings.get("run.method")) + ">";
      });
  py::implicitly_convertible<py::dict, api::Settings>();
  module.def("simulation_options", [] { return option_list(api::simulation_options()); });
}

}  // namespace remount::python
