#pragma once
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bindings.hpp"

/// Arguments of users, which each function checks by their own names, so that an error names the argument in one
/// sentence.
namespace ringfilm::python {

/// An argument that is not checked yet; `Kind` is its type in the signature.
template <class Kind>
struct Given {
  py::object value;
};

namespace kinds {
struct Numbers {
  static constexpr auto name = py::detail::const_name("numpy.ndarray");
};
struct Number {
  static constexpr auto name = py::detail::const_name("float");
};
struct MaybeNumber {
  static constexpr auto name = py::detail::const_name("Optional[float]");
};
struct Integer {
  static constexpr auto name = py::detail::const_name("int");
};
struct Text {
  static constexpr auto name = py::detail::const_name("str");
};
struct MaybeText {
  static constexpr auto name = py::detail::const_name("Optional[str]");
};
struct MaybeTexts {
  static constexpr auto name = py::detail::const_name("Optional[Dict[str, str]]");
};
/// A word or number, or several of them.
struct Words {
  static constexpr auto name = py::detail::const_name("Union[str, float, Sequence[Union[str, float]]]");
};
struct Paths {
  static constexpr auto name = py::detail::const_name("List[str]");
};
struct NumberOrText {
  static constexpr auto name = py::detail::const_name("Optional[Union[int, str]]");
};
struct NumberOrPair {
  static constexpr auto name = py::detail::const_name("Union[float, Tuple[float, float]]");
};
struct MaybePair {
  static constexpr auto name = py::detail::const_name("Optional[Tuple[float, float]]");
};
struct Path {
  static constexpr auto name = py::detail::const_name("object");
};
template <class Type>
struct One {
  static constexpr auto name = py::detail::make_caster<Type>::name;
};
}  // namespace kinds

using GivenNumbers = Given<kinds::Numbers>;
using GivenNumber = Given<kinds::Number>;
using GivenMaybeNumber = Given<kinds::MaybeNumber>;
using GivenText = Given<kinds::Text>;
using GivenMaybeText = Given<kinds::MaybeText>;

/// One of this module's classes.
template <class Type>
using GivenOne = Given<kinds::One<Type>>;

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// A number: float, int, one of numpy's, an array without dimensions. Throws TypeError for all else, a bool too, and
/// InputError for a masked one. `unit` appears in the message: "m", empty where there is none.
double number_of(const char* name, const py::handle& value, const char* unit);
std::optional<double> maybe_number_of(const char* name, const py::handle& value, const char* unit);
/// One number for both, or two. Throws TypeError.
std::pair<double, double> pair_of(const char* name, const py::handle& value, const char* unit);
/// Throws TypeError for what is not an integer, a bool too.
int integer_of(const char* name, const py::handle& value);
/// Throws TypeError for what is not text, InputError for text with lone surrogates. `example` appears in the message.
std::string text_of(const char* name, const py::handle& value, const char* example);
std::optional<std::string> maybe_text_of(const char* name, const py::handle& value, const char* example);
/// A name of a file: str, bytes or os.PathLike. Throws TypeError for all else, InputError for what no file can be
/// called.
std::string path_of(const char* name, const py::handle& value);

/// Texts by their keys, none of None. Throws TypeError for all but a dict of texts.
std::map<std::string, std::string> texts_of(const char* name, const py::handle& value, const char* example);
/// A word or number, or a list or tuple of them, each as text. Throws TypeError for all else.
std::vector<std::string> words_of(const char* name, const py::handle& value);
/// Names of files, a list or a tuple. Throws TypeError for all else, one name by itself too.
std::vector<std::string> paths_of(const char* name, const py::handle& value);

/// Throws TypeError for what is not of the class `required`.
void check_type(const char* name, const py::handle& value, const py::handle& required);

/// One of this module's classes. Throws TypeError for all else.
template <class Type>
Type& one_of(const char* name, const GivenOne<Type>& given) {
  check_type(name, given.value, py::type::of<Type>());
  return py::cast<Type&>(given.value);
}

/// Numbers of any shape and, where an array of numpy.ma has some masked, which.
struct MaybeMasked {
  Doubles values;
  std::optional<py::array_t<bool, py::array::c_style | py::array::forcecast>> mask;  ///< mask of the shape of `values`
};
/// Throws TypeError for what are not real numbers: complex ones, bools, texts, lists of unlike lengths.
MaybeMasked maybe_masked_of(const char* name, const py::handle& value);
/// Numbers of any shape, where a masked one has no meaning: InputError.
Doubles doubles_of(const char* name, const py::handle& value);
/// Numbers of one dimension; InputError for any other shape.
std::vector<double> row_of(const char* name, const py::handle& value);
/// Numbers of one dimension from the state of a pickle.
inline std::vector<double> pickled_row(const py::handle& value) { return row_of("a member of the pickle", value); }

/// Arrays under the names of their arguments.
using Named = std::vector<std::pair<const char*, const GivenNumbers*>>;

/// Arrays as numpy spreads them to one shape; InputError where they have none in common.
std::vector<Doubles> spread(const Named& given);

/// f of the numbers at each place, `double f(const std::vector<double>&)`, in the shape that all have in common; a
/// float where none has dimensions.
template <class Function>
py::object mapped(const Named& given, const Function& f) {
  const std::vector<Doubles> all = spread(given);
  const Doubles& first = all.front();
  py::array_t<double> values(std::vector<py::ssize_t>(first.shape(), first.shape() + first.ndim()));
  double* const to = values.mutable_data();
  std::vector<double> at(all.size());
  for (py::ssize_t i = 0; i < first.size(); ++i) {
    for (std::size_t k = 0; k < all.size(); ++k) at[k] = all[k].data()[i];
    to[i] = f(at);
  }
  if (first.ndim() == 0) return py::float_(*to);
  return values;
}

/// f of each number of one array, `double f(double)`, in the shape of the array.
template <class Function>
py::object mapped(const char* name, const GivenNumbers& given, const Function& f) {
  return mapped({{name, &given}}, [&f](const std::vector<double>& at) { return f(at[0]); });
}

py::array array_of(const std::vector<double>& values);

/// What a JSON text of the program holds, as dicts, lists and numbers.
py::object from_json(const std::string& text);

/// The threads that a user asks for; None: 0, as many as the machine runs at once. Throws InputError out of 1 to 1024.
int threads_of(const py::object& threads);

}  // namespace ringfilm::python

namespace pybind11::detail {
template <class Kind>
struct type_caster<ringfilm::python::Given<Kind>> {
  PYBIND11_TYPE_CASTER(ringfilm::python::Given<Kind>, Kind::name);
  bool load(handle from, bool) {
    value.value = reinterpret_borrow<object>(from);
    return true;
  }
};
}  // namespace pybind11::detail
