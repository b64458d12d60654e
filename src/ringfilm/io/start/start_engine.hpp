#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/case/case_text.hpp"
#include "ringfilm/io/text/source_text.hpp"

/// Engines with typical numbers to start a case from, each a file in data/engines.
namespace ringfilm::io {

extern const std::string kAssumed;  ///< "typical, assumed": the remark of a value without one of its own

inline constexpr const char* kDefaultEngine = "passenger-car";

/// An operating point. Its walls are those of `conditions = "engine"` where it states none.
struct StartPoint {
  std::string name;
  double weight = 0;  ///< share of the time
  std::vector<StartValue> operation;
  std::vector<StartValue> gas;  ///< where no trace is given
};

/// An engine with its rings.
struct StartEngine {
  std::string name, title;
  std::vector<StartValue> engine;
  std::vector<StartValue> ring;           ///< top ring alone
  std::vector<std::string> crown_height;  ///< heights of its face, for each of start_states()
  std::vector<StartValue> gas;            ///< where no trace is given
  std::string grade;                      ///< viscosity grade of its oil
  std::string pack;                       ///< name of the file of its rings in data/packs, or a file (.toml)
  std::vector<StartValue> composition;    ///< composition of the gas of a pack; empty: none
  std::vector<StartPoint> points;         ///< part load, full load at low speed and at high speed
};

/// Names of the shipped engines, kDefaultEngine first. Throws InputError where the shipped folder is not found.
std::vector<std::string> start_engines();

/// A shipped engine, or that of a file whose name ends with .toml. Throws InputError for an unknown name, which it
/// lists with the others, and for a file that is not an engine.
StartEngine start_engine(const std::string& name);

/// Throws InputError with every place that is wrong. @param name what the engine is called
StartEngine read_start_engine(const NamedFile& file, const std::string& name);

}  // namespace ringfilm::io
