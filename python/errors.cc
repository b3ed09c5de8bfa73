// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/core/error.h"
#include "cvo_slam/python/bindings_internal.h"

namespace py = pybind11;

namespace cvo_slam::python {

void bind_errors(py::module_& module) {
  const auto& base = py::register_exception<Error>(module, "Error", PyExc_RuntimeError);
  base.attr("__doc__") =
      "Base of what this library raises: one line that says what is wrong, "
      "where, and what to do.";
  const auto add = [&]<typename E>(const char* name, const char* doc, E* /*type*/) {
    py::register_exception<E>(module, name, base).attr("__doc__") = doc;
  };
  add("InputError", "A file or folder cannot be used.", static_cast<InputError*>(nullptr));
  add("OutputError", "A file cannot be written.", static_cast<OutputError*>(nullptr));
  add("OptionError", "An option is unknown or its value is out of range.",
      static_cast<OptionError*>(nullptr));
  add("DataError", "Valid data has no answer to a question.", static_cast<DataError*>(nullptr));
  add("UsageError", "A call at the wrong time: two threads in one object, for example.",
      static_cast<UsageError*>(nullptr));
}

}  // namespace cvo_slam::python
