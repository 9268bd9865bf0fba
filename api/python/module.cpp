#include <atomic>
#include <mutex>

#include "api/python/python_parts.h"
#include "remount/error.h"
#include "remount/version.h"

namespace remount::python {
namespace {

std::atomic<api::Language>& chosen_language() {
  static std::atomic<api::Language> language{api::Language::English};
  return language;
}

void raise(const api::Error& error) {
  const py::object type = py::module_::import("remount.errors").attr("Error");
  PyErr_SetObject(type.ptr(), type(std::string(to_string(error.code())), python_text(error.place()),
                                   python_text(words_of(error.expectation())))
                                  .ptr());
}

/// Tells of items at most twenty times a second: whoever is told is asked for Python's lock.
class Teller {
 public:
  explicit Teller(py::object callback) : callback_(std::move(callback)) {}
  Teller(const Teller&) = delete;
  Teller& operator=(const Teller&) = delete;
  ~Teller() {
    const py::gil_scoped_acquire locked;
    callback_ = py::object();
  }

  void tell(const api::Step& step) {
    const auto now = std::chrono::steady_clock::now();
    if (step.stage.code() == stage_ && step.done != step.total && now - told_ < std::chrono::milliseconds(50)) return;
    stage_ = step.stage.code();
    told_ = now;
    const py::gil_scoped_acquire locked;
    callback_(words_of(step.stage), step.done, step.total);
  }

 private:
  py::object callback_;
  std::string stage_;
  std::chrono::steady_clock::time_point told_;
};

api::Progress telling(const py::object& callback) {
  if (callback.is_none()) return {};
  const auto teller = std::make_shared<Teller>(callback);
  return api::Progress([teller](const api::Step& step) { teller->tell(step); });
}

}  // namespace

py::str python_text(const std::string& text) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "surrogateescape"));
}

std::string words_of(const api::Text& text) { return text.in(chosen_language()); }

void set_language(const std::string& tag) {
  if (tag != "en" && tag != "zh_CN") throw api::Error(api::ErrorCode::Contract, tag, "expected \"en\" or \"zh_CN\"");
  chosen_language() = tag == "en" ? api::Language::English : api::Language::Chinese;
}

api::Progress progress_of(const py::object& given) {
  return py::isinstance<api::Progress>(given) ? given.cast<api::Progress>() : telling(given);
}

py::object structured_array(std::size_t rows, const std::vector<ArrayColumn>& columns) {
  py::list types;
  for (const ArrayColumn& column : columns) types.append(py::make_tuple(column.name, column.type));
  py::object array = py::module_::import("numpy").attr("zeros")(rows, types);
  if (rows > 0)
    for (const ArrayColumn& column : columns) array[py::str(column.name)] = column.values;
  return array;
}

py::array_t<double> stacked(const std::vector<api::Matrix4>& matrices) {
  py::array_t<double> array({matrices.size(), std::size_t{4}, std::size_t{4}});
  auto values = array.mutable_unchecked<3>();
  for (std::size_t i = 0; i < matrices.size(); ++i)
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column)
        values(static_cast<py::ssize_t>(i), row, column) = matrices[i](row, column);
  return array;
}

std::vector<api::Matrix4> unstacked(const py::array_t<double, py::array::c_style | py::array::forcecast>& array,
                                    const std::string& name) {
  if (array.ndim() != 3 || array.shape(1) != 4 || array.shape(2) != 4)
    throw api::Error(api::ErrorCode::Contract, name, "expected an array of (n, 4, 4): a transform in each row");
  const auto values = array.unchecked<3>();
  std::vector<api::Matrix4> matrices(static_cast<std::size_t>(array.shape(0)));
  for (std::size_t i = 0; i < matrices.size(); ++i)
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column)
        matrices[i](row, column) = values(static_cast<py::ssize_t>(i), row, column);
  return matrices;
}

}  // namespace remount::python

PYBIND11_MODULE(_remount, module) {
  namespace api = remount::api;
  namespace py = pybind11;
  module.attr("__version__") = std::string(api::version());
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const api::Error& error) {
      remount::python::raise(error);
    }
  });
  module.def("set_language", remount::python::set_language, py::arg("language"));
  py::class_<api::Progress>(module, "Progress")
      .def(py::init([](const py::object& callback) { return remount::python::telling(callback); }),
           py::arg("callback") = py::none())
      .def("cancel", &api::Progress::cancel)
      .def_property_readonly("cancelled", &api::Progress::cancelled)
      .def("__repr__", [](const api::Progress& progress) {
        return progress.cancelled() ? "<remount.Progress, cancelled>" : "<remount.Progress>";
      });
  remount::python::add_settings(module);
  remount::python::add_sessions(module);
  remount::python::add_results(module);
}
