// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Options structs. What Python knows of them comes from describe(), as in YAML files and --set.
#include <algorithm>
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "cvo_slam/backend/optimizer.h"
#include "cvo_slam/core/map.h"
#include "cvo_slam/frontend/tracker.h"
#include "cvo_slam/io/options_file.h"
#include "cvo_slam/python/bindings_internal.h"
#include "cvo_slam/slam/slam_options.h"

namespace py = pybind11;

namespace cvo_slam::python {
namespace {

/// The text that OptionSet::set() takes for a value.
std::string text_of(const py::handle& value) {
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
    std::string text = "[";
    for (const auto& element : value) {
      if (text.size() > 1) text += ", ";
      text += text_of(element);
    }
    return text + "]";
  }
  if (PyNumber_Check(value.ptr()) == 0) {
    throw py::type_error(fmt::format("an option takes a bool, number, text or list, not {}",
                                     py::str(py::type::of(value)).cast<std::string>()));
  }
  if (PyIndex_Check(value.ptr()) != 0)
    return py::str(py::int_(py::reinterpret_borrow<py::object>(value)));
  return py::repr(py::float_(py::reinterpret_borrow<py::object>(value)));
}

/// The value that a text of Option::get() stands for.
py::object value_of(const std::string& text) {
  if (text == "true" || text == "false") return py::bool_(text == "true");
  const bool is_literal =
      !text.empty() && (text.front() == '[' || text.front() == '-' || text.front() == '.' ||
                        (text.front() >= '0' && text.front() <= '9'));
  if (!is_literal) return py::str(text);
  return py::module_::import("ast").attr("literal_eval")(text);
}

void set_nested(const OptionSet& options, const std::string& prefix, const py::dict& values) {
  for (const auto& [name, value] : values) {
    const std::string key = prefix + name.cast<std::string>();
    if (py::isinstance<py::dict>(value)) {
      set_nested(options, key + ".", value.cast<py::dict>());
    } else {
      options.set(key, text_of(value));
    }
  }
}

/// The keys whose values are not the defaults.
template <typename Options>
std::string difference(Options& options) {
  Options defaults;
  const auto usual = describe(defaults).options();
  const auto mine = describe(options).options();
  std::string text;
  for (std::size_t i = 0; i < mine.size(); ++i) {
    const std::string value = mine[i].get();
    if (value != usual[i].get()) {
      text += fmt::format("{}{}={}", text.empty() ? "" : ", ", mine[i].key, value);
    }
  }
  return text;
}

template <typename Options>
void bind_options_struct(py::module_& module, const char* name, const char* doc) {
  py::class_<Options>(module, name, doc)
      .def(py::init([](const py::kwargs& values) {
             Options options;
             set_nested(describe(options), "", values);
             return options;
           }),
           "Takes values by name; those of groups as dictionaries or with dots.")
      .def("__getitem__",
           [](Options& self, const std::string& key) { return value_of(describe(self).get(key)); })
      .def("__setitem__", [](Options& self, const std::string& key,
                             const py::object& value) { describe(self).set(key, text_of(value)); })
      .def(
          "keys",
          [](Options& self) {
            std::vector<std::string> keys;
            for (const Option& option : describe(self).options()) keys.push_back(option.key);
            return keys;
          },
          "The names of all options.")
      .def("__contains__",
           [](Options& self, const std::string& key) {
             const auto options = describe(self).options();
             return std::any_of(options.begin(), options.end(),
                                [&](const Option& option) { return option.key == key; });
           })
      .def(
          "describe",
          [](Options& self, const std::string& key) {
            for (const Option& option : describe(self).options()) {
              if (option.key != key) continue;
              return fmt::format("{} ({}{}{}): {}", option.key, option.allowed,
                                 option.unit.empty() ? "" : " ", option.unit, option.doc);
            }
            return describe(self).get(key);  // throws, and names a near one
          },
          py::arg("key"), "What an option means, with its unit and range.")
      .def(
          "read_yaml",
          [](Options& self, const std::filesystem::path& file) {
            read_options(file, describe(self));
          },
          py::arg("file"), "Sets the options that a YAML file names.")
      .def(
          "to_yaml",
          [](Options& self, bool comments) { return options_to_yaml(describe(self), comments); },
          py::arg("comments") = false, "All options as YAML, which read_yaml() reads.")
      .def("copy", [](const Options& self) { return self; })
      .def("__repr__",
           [name](Options& self) { return fmt::format("{}({})", name, difference(self)); });
}

}  // namespace

void bind_options(py::module_& module) {
  bind_options_struct<SlamOptions>(module, "SlamOptions",
                                   "Options of Slam, by the keys of docs/reference/options.md:\n\n"
                                   "  options = SlamOptions(tracker={'points': 1000})\n"
                                   "  options['loops.enabled'] = False");
  bind_options_struct<TrackerOptions>(module, "TrackerOptions",
                                      "Options of Tracker: those of SlamOptions below 'tracker.'.");
  bind_options_struct<RegistrationOptions>(
      module, "RegistrationOptions",
      "Options of align(): those of SlamOptions below 'tracker.registration.'.");
  bind_options_struct<OptimizerOptions>(module, "OptimizerOptions", "Options of optimize().");
}

}  // namespace cvo_slam::python
