#pragma once
#include <cstdio>
#include <string>
#include <vector>

#include "bindings.hpp"

namespace ringfilm::python {

/// A plain struct of C++ as a class of Python: members by their names, a repr that shows them, pickles by value.
template <class Struct>
class Record {
 public:
  Record(py::module_& module, const char* name, const char* doc) : name_(name), type_(module, name, doc) {
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
  }

  template <class Member>
  Record& with(const char* name, Member Struct::*member, const char* doc) {
    if constexpr (std::is_same_v<Member, std::vector<double>>) {
      type_.def_property_readonly(
          name,
          [member](const Struct& self) {
            const auto& values = self.*member;
            return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
          },
          doc);
    } else {
      type_.def_readonly(name, member, doc);
    }
    type_.attr("_members").attr("append")(name);
    return *this;
  }

  py::class_<Struct>& type() { return type_; }

 private:
  const char* name_;
  py::class_<Struct> type_;
};

}  // namespace ringfilm::python
