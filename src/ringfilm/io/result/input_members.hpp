#pragma once
#include <tuple>

#include "ringfilm/base/members.hpp"
#include "ringfilm/case/case.hpp"
#include "ringfilm/io/case/case_entry.hpp"

/// Members of the records of what a result was computed from.
namespace ringfilm {
namespace cycle {

/// The members of a file that was read, as all outputs have them.
constexpr auto members(const InputFile*) {
  return std::tuple{Member{"role", "", "what the file was read for", &InputFile::role},
                    Member{"path", "", "name of the file", &InputFile::path},
                    Member{"sha256", "", "SHA-256 of its bytes", &InputFile::sha256}};
}

}  // namespace cycle
namespace io {

/// The members of a key of a case, as all outputs have them.
constexpr auto members(const CaseEntry*) {
  return std::tuple{
      Member{"key", "", "key of the case", &CaseEntry::key},
      Member{"value", "", "value in SI as in a case file", &CaseEntry::value},
      Member{"value_si", "", "value in its SI unit, see input_unit; NaN if not a number", &CaseEntry::value_si},
      Member{"unit", "", "SI unit of input_value_si", &CaseEntry::unit},
      Member{"shown", "", "value in the unit people use", &CaseEntry::shown},
      Member{"assumed", "1", "1 where the case does not state the key and the default was taken", &CaseEntry::assumed},
      Member{"help", "", "meaning of the key", &CaseEntry::help}};
}

}  // namespace io
}  // namespace ringfilm
