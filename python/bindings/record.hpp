#pragma once
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "arguments.hpp"
#include "array_view.hpp"
#include "members.hpp"

namespace ringfilm::python {

/// A plain struct of C++ as a class of Python: members by their names, a repr that shows them, `==` member by member,
/// pickles and copies by value. Every member of the struct must be named, by with() or with_word(), or kept by keep():
/// what is not is lost in a pickle.
template <class Struct>
class Record {
 public:
  Record(py::module_& module, const char* name, const char* doc) : type_(module, name, doc) {
    type_.attr("_members") = py::list();
    type_.def(
        "__repr__",
        [](const py::object& self) {
          std::string text = py::cast<std::string>(py::type::of(self).attr("__name__")) + "(";
          bool is_first = true;
          for (const auto member : self.attr("_members")) {
            const std::string value = py::cast<std::string>(py::repr(self.attr(member)));
            text += (is_first ? "" : ", ") + py::cast<std::string>(member) + "=" + value;
            is_first = false;
          }
          return text + ")";
        },
        "All members.");
    type_.def(
        "to_dict",
        [](const py::object& self) {
          py::dict values;
          for (const auto member : self.attr("_members")) values[member] = self.attr(member);
          return values;
        },
        "All members, {name: value}.");
    type_.def(
        "__eq__",
        [parts = parts_](const Struct& self, const py::object& other) -> py::object {
          if (!py::isinstance<Struct>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
          const auto& of = py::cast<const Struct&>(other);
          for (const Part& part : *parts) {
            if (!part.is_same(self, of)) return py::bool_(false);
          }
          return py::bool_(true);
        },
        py::arg("other"), "Are all members the same? A NaN is not.");
    type_.def(py::pickle(
        [parts = parts_](const Struct& self) {
          py::tuple state(parts->size());
          for (std::size_t i = 0; i < parts->size(); ++i) state[i] = (*parts)[i].get(self);
          return state;
        },
        [parts = parts_](const py::tuple& state) {
          if (state.size() != parts->size()) {
            throw py::value_error("this pickle was written by another version of ringfilm");
          }
          Struct made{};
          for (std::size_t i = 0; i < parts->size(); ++i) (*parts)[i].set(made, state[i]);
          return made;
        }));
  }

  /// A member under its name; an array is a read-only view.
  template <class Member>
  Record& with(const char* name, Member Struct::*member, const char* doc) {
    if constexpr (std::is_same_v<Member, std::vector<double>>) {
      type_.def_property_readonly(
          name, [member](const py::object& self) { return view(py::cast<const Struct&>(self).*member, self); }, doc);
    } else {
      type_.def_readonly(name, member, doc);
    }
    type_.attr("_members").attr("append")(name);
    return keep(member);
  }

  /// What follows from the members, `Value value(const Struct&)`, listed with them.
  template <class Function>
  Record& derived(const char* name, const Function& value, const char* doc) {
    type_.def_property_readonly(name, value, doc);
    type_.attr("_members").attr("append")(name);
    return *this;
  }

  /// A choice as its word, which `Text word(Choice)` gives.
  template <class Choice, class Function>
  Record& with_word(const char* name, Choice Struct::*member, const Function& word, const char* doc) {
    derived(
        name, [member, word](const Struct& self) { return word(self.*member); }, doc);
    return keep(member);
  }

  /// A member that has no name in Python, but belongs to the value.
  template <class Member>
  Record& keep(Member Struct::*member) {
    return keep([member](const Struct& self) { return member_value(self.*member); },
                [member](Struct& self, const py::handle& value) { restore_member(value, self.*member); },
                [member](const Struct& a, const Struct& b) { return is_same(a.*member, b.*member); });
  }

  /// A member without a name in Python, with functions of its own: its value for a pickle, its value from a pickle, and
  /// when two are the same.
  Record& keep(std::function<py::object(const Struct&)> get, std::function<void(Struct&, const py::handle&)> set,
               std::function<bool(const Struct&, const Struct&)> is_same) {
    parts_->push_back({std::move(get), std::move(set), std::move(is_same)});
    return *this;
  }

  py::class_<Struct>& type() { return type_; }

 private:
  struct Part {
    std::function<py::object(const Struct&)> get;
    std::function<void(Struct&, const py::handle&)> set;
    std::function<bool(const Struct&, const Struct&)> is_same;
  };

  template <class Value>
  static bool is_same(const Value& a, const Value& b) {
    if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value> || std::is_same_v<Value, std::string> ||
                  std::is_same_v<Value, std::vector<double>>) {
      return a == b;
    } else {
      return py::cast(a).equal(py::cast(b));
    }
  }

  py::class_<Struct> type_;
  std::shared_ptr<std::vector<Part>> parts_ = std::make_shared<std::vector<Part>>();
};

}  // namespace ringfilm::python
