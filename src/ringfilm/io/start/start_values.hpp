#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/case/case_text.hpp"

/// Typical numbers of cases to start from. An empty remark: typical, assumed.
namespace ringfilm::io {

extern const std::string kAssumed;  ///< "typical, assumed"

/// An operating point. Its walls are those of `conditions = "engine"` where it states none.
struct StartPoint {
  const char* name;
  double weight;  ///< share of the time
  std::vector<StartValue> operation;
  std::vector<StartValue> gas;  ///< where no trace is given
};

/// An engine with its rings. Sizes of real ones of its kind, none of them measured.
struct StartEngine {
  const char* name;
  const char* title;
  std::vector<StartValue> engine;
  std::vector<StartValue> ring;           ///< top ring alone
  std::vector<std::string> crown_height;  ///< heights of its face, for each of start_states()
  std::vector<StartValue> gas;            ///< where no trace is given
  const char* grade;                      ///< viscosity grade of its oil
  const char* pack;                       ///< name of the file of its rings in data/packs
  std::vector<StartValue> composition;    ///< composition of the gas of a pack; empty: none
  std::vector<StartPoint> points;         ///< part load, full load at low speed and at high speed
};

const std::vector<StartEngine>& start_engine_table();

/// A pair of the shipped classes of surfaces in oil: a plateau-honed liner of grey iron and a nitrided ring.
/// N beta sigma = 0.05, the upper end of its range (greenwood1971). Throws InputError where the shipped folder is not
/// found.
std::vector<StartValue> start_contact(const std::string& state);

/// Walls of the point, of `conditions = "engine"` where it states none.
std::vector<StartValue> start_walls(const StartPoint& point);

}  // namespace ringfilm::io
