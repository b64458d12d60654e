#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/io/text/toml_table.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/study/design/study.hpp"

namespace ringfilm::io {

/// What the factors of a study are read with.
struct FactorSources {
  const study::Study& study;  ///< its bases
  const Units& units;
};

/// One [[factor]]; nothing if it was refused. What is wrong goes to `faults`.
std::optional<study::Factor> read_factor(const TomlValue& table, const FactorSources& sources,
                                         std::vector<Fault>& faults);

/// The bases that a list of names denotes; all where the key `bases` is absent.
std::vector<std::size_t> read_base_names(TomlTable& table, const study::Study& study);

}  // namespace ringfilm::io
