#include "errors.hpp"

namespace ringfilm::python {
namespace {

py::object error_type(const char* name) { return py::module_::import("ringfilm.errors").attr(name); }

/// Without the end of line that the program requires.
std::string words(const std::exception& error) {
  std::string text = error.what();
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

void set(const char* name, const py::object& error) { PyErr_SetObject(error_type(name).ptr(), error.ptr()); }

void translate(std::exception_ptr failure) {
  try {
    if (failure) std::rethrow_exception(failure);
  } catch (const InputError& error) {
    const py::object raised = input_error(error);
    PyErr_SetObject(py::type::of(raised).ptr(), raised.ptr());
  } catch (const ConvergenceError& error) {
    set("ConvergenceError", error_type("ConvergenceError")(words(error), error.crank_angle_deg(), py::none()));
  } catch (const OutputError& error) {
    set("OutputError", error_type("OutputError")(words(error)));
  }
}

}  // namespace

py::object input_error(const InputError& error) {
  py::list faults;
  for (const auto& [mark, message, remedy] : error.faults()) {
    faults.append(error_type("Fault")(mark.file, mark.line, mark.column, mark.line_text, message, remedy));
  }
  const bool is_key = dynamic_cast<const UnknownKeyError*>(&error) != nullptr;
  return error_type(is_key ? "UnknownKeyError" : "InputError")(words(error), faults);
}

void raise_convergence(const ConvergenceError& error, const py::object& result) {
  set("ConvergenceError", error_type("ConvergenceError")(words(error), error.crank_angle_deg(), result));
  throw py::error_already_set();
}

void bind_errors(py::module_&) { py::register_local_exception_translator(&translate); }

}  // namespace ringfilm::python
