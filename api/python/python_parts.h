// What the parts of the module share.
#pragma once

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <chrono>
#include <future>
#include <string>
#include <string_view>
#include <vector>

#include "remount/progress.h"
#include "remount/session.h"
#include "remount/settings.h"
#include "remount/text.h"

namespace remount::python {

namespace py = pybind11;

/// What may have bytes of a path that is no UTF-8, as Python has such paths.
py::str python_text(const std::string& text);
/// A value of a setting or an option. Throws api::Error(Contract) at its name for what is none.
api::OptionValue option_value_of(const py::handle& given, const std::string& name);
/// Settings, a mapping of names to values, or None. Throws api::Error(Contract).
api::Settings settings_of(const py::object& given);
/// Whole nanoseconds, (n,). Throws api::Error(Contract) for other numbers: cut, seconds would pass for them.
std::vector<std::int64_t> stamps_of(const py::object& given, const std::string& name);

/// In the language of the module.
std::string words_of(const api::Text& text);
void set_language(const std::string& tag);

/// A progress of its caller's: one of the module, something that can be called with (stage, done, total), or None.
api::Progress progress_of(const py::object& given);

/// Runs what takes long without Python's lock, and ends it where the user interrupts.
template <class Work>
auto run_interruptibly(const api::Progress& progress, const Work& work) {
  progress.refuse_within_callback();
  const py::gil_scoped_release unlocked;
  auto running = std::async(std::launch::async, work);
  while (running.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready) {
    const py::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() == 0) continue;
    const py::error_already_set interrupted;
    progress.cancel();
    const py::gil_scoped_release waiting;
    running.wait();
    throw interrupted;
  }
  return running.get();
}

/// A column of a structured array: its type as NumPy has it ("i8", "(4,4)f8"), and its values.
struct ArrayColumn {
  std::string name, type;
  py::object values;
};
py::object structured_array(std::size_t rows, const std::vector<ArrayColumn>& columns);

/// Matrices one behind the other: an array of (n, 4, 4).
py::array_t<double> stacked(const std::vector<api::Matrix4>& matrices);
/// Throws api::Error(Contract) for another shape.
std::vector<api::Matrix4> unstacked(const py::array_t<double, py::array::c_style | py::array::forcecast>& array,
                                    const std::string& name);

/// (n, 3), float32.
py::array_t<float> points_of(const api::Scan& scan);
/// A scan as Python gives it: an array of (n, 3), or a dict with points and, where they are known, time_from_stamp_s,
/// intensity and ring. Throws api::Error(Contract).
api::Scan scan_of(const py::object& given, const std::string& name);

void add_settings(py::module_& module);
void add_sessions(py::module_& module);
void add_results(py::module_& module);

}  // namespace remount::python
