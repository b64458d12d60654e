#include "arguments.hpp"

#include <climits>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"

namespace ringfilm::python {
namespace {

using Mask = py::array_t<bool, py::array::c_style | py::array::forcecast>;

/// What somebody gave, short enough for a sentence.
std::string shown_value(const py::handle& value) {
  if (value.is_none()) return "None";
  if (!PyUnicode_Check(value.ptr())) return "of type " + py::cast<std::string>(py::type::of(value).attr("__name__"));
  constexpr std::size_t kMax = 40;
  const auto text = py::cast<std::string>(py::reinterpret_steal<py::object>(PyObject_ASCII(value.ptr())));
  return text.size() <= kMax ? text : text.substr(0, kMax) + "...";
}

[[noreturn]] void refuse(const char* name, const std::string& required, const py::handle& value) {
  throw py::type_error(std::string(name) + " must be " + required + ", not " + shown_value(value));
}

std::string with_unit(const char* what, const char* unit) {
  return *unit ? std::string(what) + " in " + unit : std::string(what);
}

py::object numpy(const char* name) { return py::module_::import("numpy").attr(name); }

bool is_masked_array(const py::handle& value) {
  return py::isinstance(value, py::module_::import("numpy.ma").attr("MaskedArray"));
}

/// 'f', 'i', ... of numpy's arrays and numbers; 0 of all else.
char kind_of(const py::handle& value) {
  if (!py::hasattr(value, "dtype") || !py::hasattr(value.attr("dtype"), "kind")) return 0;
  return py::cast<std::string>(value.attr("dtype").attr("kind")).at(0);
}

bool is_real(char kind) { return kind == 'f' || kind == 'i' || kind == 'u'; }

[[noreturn]] void refuse_masked(const char* name) {
  throw InputError(std::string(name) + " has masked values, which have no meaning here",
                   "leave them out, for example with .compressed(), or fill them with .filled()");
}

/// As numpy reads it, arrays of numpy.ma as they are, in lists too.
py::object as_numpy(const py::handle& value) {
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
    for (const py::handle part : value) {
      if (is_masked_array(part)) return py::module_::import("numpy.ma").attr("array")(value);
    }
  }
  return numpy("asanyarray")(value);
}

}  // namespace

double number_of(const char* name, const py::handle& value, const char* unit) {
  const auto wrong = [&] { refuse(name, with_unit("a number", unit), value); };
  PyObject* const it = value.ptr();
  if (PyFloat_Check(it)) return PyFloat_AS_DOUBLE(it);
  if (PyBool_Check(it) || PyUnicode_Check(it) || PyBytes_Check(it) || PyByteArray_Check(it) || value.is_none()) wrong();
  if (const char kind = kind_of(value); kind != 0) {
    if (!is_real(kind) || !py::hasattr(value, "ndim") || py::cast<int>(value.attr("ndim")) != 0) wrong();
    if (is_masked_array(value) && py::cast<bool>(numpy("any")(value.attr("mask")))) refuse_masked(name);
  } else if (!PyLong_Check(it) && !py::hasattr(value, "__float__") && !py::hasattr(value, "__index__")) {
    wrong();
  }
  const auto number = py::reinterpret_steal<py::object>(PyNumber_Float(it));
  if (!number) {
    py::error_already_set error;
    if (error.matches(PyExc_OverflowError)) throw InputError(std::string(name) + " is beyond the range of numbers");
    if (!error.matches(PyExc_TypeError) && !error.matches(PyExc_ValueError)) throw error;
    wrong();
  }
  return PyFloat_AS_DOUBLE(number.ptr());
}

std::optional<double> maybe_number_of(const char* name, const py::handle& value, const char* unit) {
  if (value.is_none()) return std::nullopt;
  return number_of(name, value, unit);
}

std::pair<double, double> pair_of(const char* name, const py::handle& value, const char* unit) {
  const bool is_array = py::isinstance<py::array>(value);
  const bool is_row = py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value) ||
                      (is_array && py::cast<int>(value.attr("ndim")) > 0);
  const std::string required = with_unit("a number or two, (x, y),", unit);
  if (!is_row) {
    if (PyUnicode_Check(value.ptr()) || value.is_none()) refuse(name, required, value);
    const double both = number_of(name, value, unit);
    return {both, both};
  }
  const auto count = py::len(value);
  if (count != 2) throw py::type_error(std::string(name) + " must be " + required + ", not " + std::to_string(count));
  const py::object x = value[py::int_(0)], y = value[py::int_(1)];
  return {number_of(name, x, unit), number_of(name, y, unit)};
}

int integer_of(const char* name, const py::handle& value) {
  if (PyBool_Check(value.ptr()) || !PyIndex_Check(value.ptr())) refuse(name, "an integer", value);
  const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!number) {
    py::error_already_set error;
    refuse(name, "an integer", value);
  }
  int overflow = 0;
  const long long whole = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
  if (overflow != 0 || whole < INT_MIN || whole > INT_MAX) {
    throw InputError(std::string(name) + " is beyond the range of integers");
  }
  return static_cast<int>(whole);
}

std::string text_of(const char* name, const py::handle& value, const char* example) {
  if (!PyUnicode_Check(value.ptr())) refuse(name, "a text such as \"" + std::string(example) + "\"", value);
  Py_ssize_t size = 0;
  const char* text = PyUnicode_AsUTF8AndSize(value.ptr(), &size);
  if (text == nullptr) {
    PyErr_Clear();
    throw InputError(
        std::string(name) + " = " + shown_value(value) + " contains a lone surrogate, which is not Unicode text",
        "replace the characters from \\ud800 to \\udfff");
  }
  return {text, static_cast<std::size_t>(size)};
}

std::optional<std::string> maybe_text_of(const char* name, const py::handle& value, const char* example) {
  if (value.is_none()) return std::nullopt;
  return text_of(name, value, example);
}

std::string path_of(const char* name, const py::handle& value) {
  if (!PyUnicode_Check(value.ptr()) && !PyBytes_Check(value.ptr()) && !py::hasattr(value, "__fspath__")) {
    refuse(name, "a str or a path", value);
  }
  py::object path = py::module_::import("os").attr("fspath")(value);
  if (PyBytes_Check(path.ptr())) path = py::module_::import("os").attr("fsdecode")(path);
  const std::string text = text_of(name, path, "ring.x3p");
  if (text.find('\0') != std::string::npos) {
    throw InputError(std::string(name) + " = " + shown_value(path) + " holds a zero byte, as no name of a file does");
  }
  return text;
}

std::map<std::string, std::string> texts_of(const char* name, const py::handle& value, const char* example) {
  std::map<std::string, std::string> texts;
  if (value.is_none()) return texts;
  if (!py::isinstance<py::dict>(value)) refuse(name, "a dict of texts", value);
  const std::string key_name = std::string("a key of ") + name;
  for (const auto& [key, one] : py::reinterpret_borrow<py::dict>(value)) {
    const std::string text = text_of(key_name.c_str(), key, "engine.bore");
    texts[text] = text_of((std::string(name) + "[\"" + text + "\"]").c_str(), one, example);
  }
  return texts;
}

std::vector<std::string> words_of(const char* name, const py::handle& value) {
  const auto word = [name](const py::handle& one) {
    return PyUnicode_Check(one.ptr()) ? text_of(name, one, "No Data") : number_text(number_of(name, one, ""));
  };
  if (!py::isinstance<py::list>(value) && !py::isinstance<py::tuple>(value)) return {word(value)};
  std::vector<std::string> words;
  for (const py::handle one : value) words.push_back(word(one));
  return words;
}

std::vector<std::string> paths_of(const char* name, const py::handle& value) {
  if (!py::isinstance<py::list>(value) && !py::isinstance<py::tuple>(value)) refuse(name, "a list of paths", value);
  std::vector<std::string> paths;
  const std::string each = std::string("each of ") + name;
  for (const py::handle path : value) paths.push_back(path_of(each.c_str(), path));
  return paths;
}

void check_type(const char* name, const py::handle& value, const py::handle& required) {
  if (!py::isinstance(value, required)) {
    refuse(name, "a " + py::cast<std::string>(required.attr("__name__")), value);
  }
}

MaybeMasked maybe_masked_of(const char* name, const py::handle& value) {
  const auto wrong = [&](const std::string& what) {
    throw py::type_error(std::string(name) + " must be an array of real numbers, not " + what);
  };
  if (value.is_none() || PyUnicode_Check(value.ptr())) wrong(shown_value(value));
  py::object array;
  try {
    array = as_numpy(value);
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_TypeError)) throw;
    wrong("a " + py::cast<std::string>(py::type::of(value).attr("__name__")) + " of unlike parts");
  }
  if (!is_real(kind_of(array))) {
    const auto dtype = py::cast<std::string>(py::str(array.attr("dtype")));
    wrong(dtype == "object" ? "of objects" : "of " + dtype);
  }
  MaybeMasked result;
  if (is_masked_array(array)) {
    const py::object mask = py::module_::import("numpy.ma").attr("getmaskarray")(array);
    if (py::cast<bool>(mask.attr("any")())) result.mask = py::cast<Mask>(mask);
    array = array.attr("data");
  }
  result.values = py::cast<Doubles>(array);
  return result;
}

Doubles doubles_of(const char* name, const py::handle& value) {
  MaybeMasked read = maybe_masked_of(name, value);
  if (read.mask) refuse_masked(name);
  return std::move(read.values);
}

std::vector<double> row_of(const char* name, const py::handle& value) {
  const Doubles array = doubles_of(name, value);
  if (array.ndim() != 1) {
    throw InputError(std::string(name) + " has " + std::to_string(array.ndim()) + " dimensions",
                     "an array of shape (points,) is required here");
  }
  return {array.data(), array.data() + array.size()};
}

std::vector<Doubles> spread(const Named& given) {
  if (given.size() == 1) return {doubles_of(given[0].first, given[0].second->value)};
  py::list arrays;
  std::string names, shapes;
  for (const auto& [name, numbers] : given) {
    const Doubles array = doubles_of(name, numbers->value);
    arrays.append(array);
    names += (names.empty() ? "" : ", ") + std::string(name);
    shapes += (shapes.empty() ? "" : ", ") + py::cast<std::string>(py::str(array.attr("shape")));
  }
  py::object together;
  try {
    together = numpy("broadcast_arrays")(*py::tuple(arrays));
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_ValueError)) throw;
    throw InputError("the shapes of " + names + " do not fit together: " + shapes,
                     "give arrays of one shape, or single numbers beside them");
  }
  std::vector<Doubles> result;
  for (const py::handle array : together) result.push_back(py::cast<Doubles>(array));
  return result;
}

py::array array_of(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::object from_json(const std::string& text) { return py::module_::import("json").attr("loads")(text); }

int threads_of(const py::object& threads) {
  if (threads.is_none()) return 0;
  const int n = integer_of("threads", threads);
  if (n >= 1 && n <= 1024) return n;
  throw InputError("threads = " + std::to_string(n) + " is out of range",
                   "1 to 1024, or None for as many as the machine runs at once");
}

}  // namespace ringfilm::python
