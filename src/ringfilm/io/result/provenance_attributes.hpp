#pragma once
#include "ringfilm/io/result/result_file.hpp"

/// Attributes of every NetCDF file of ringfilm that describe the program that wrote it.
namespace ringfilm::io {

/// Writes them to `file`, or reads them from it: whichever it does with an attribute.
template <class File, class Provenance>
void exchange_provenance(File& file, Provenance& provenance) {
  for_each_member<io::Provenance>([&](const auto& member) {
    auto& text = provenance.*member.value;
    if constexpr (File::kReads) {
      if (file.has_attribute(member.name)) file.attribute(member.name, text);
    } else {
      if (!text.empty()) file.attribute(member.name, text);
    }
  });
}

}  // namespace ringfilm::io
