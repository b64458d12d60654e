#pragma once
#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "scratch_folder.hpp"

namespace ringfilm::io {

inline void write_text(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// A complete case around a trace, split so that a test can put its own words between.
struct CaseText {
  std::string top = "title = \"test\"\n";
  std::string engine = "[engine]\nbore = \"89 mm\"\nstroke = \"79.5 mm\"\nconnecting_rod_length = \"138.1 mm\"\n";
  std::string operating = "[operating]\nspeed = \"1500 rpm\"\noil_temperature = \"120 degC\"\n";
  std::string gas =
      "[gas]\ncylinder_pressure = \"p.csv\"\npressure_reference = \"absolute\"\nangle_zero = \"firing-tdc\"\n";
  std::string ring = "[ring]\nface_width = \"1.2 mm\"\nelastic_pressure = \"0.2 MPa\"\n";
  std::string face = "[ring.face]\nform = \"parabola\"\ncrown_height = \"15 um\"\n";
  std::string contact =
      "[contact]\nasperity_density = \"0.097 um-2\"\nasperity_radius = \"1.56 um\"\nroughness = \"0.48 um\"\n"
      "boundary_shear_strength_coefficient = 0.3581\n";
  std::string lubricant =
      "[lubricant]\n"
      "kinematic_viscosity = [ { temperature = \"40 degC\", value = \"59.99 mm2/s\" },"
      " { temperature = \"100 degC\", value = \"9.59 mm2/s\" } ]\n"
      "density = [ { temperature = \"15 degC\", value = \"849.7 kg/m3\" } ]\n";
  std::string more;

  std::string text() const { return top + engine + operating + gas + ring + face + contact + lubricant + more; }
};

/// A trace over the whole cycle every 5 degrees, 1 bar with a hill at firing TDC.
inline std::string full_trace() {
  std::string text = "crank_angle [degree],cylinder_pressure [Pa]\n";
  for (int angle = 0; angle < 720; angle += 5) {
    const int from_tdc = std::min(angle, 720 - angle);
    text += std::to_string(angle) + "," + std::to_string(100000 + std::max(0, 100 - from_tdc) * 60000) + "\n";
  }
  return text;
}

/// A folder with a case and its trace.
class CaseFolder {
 public:
  explicit CaseFolder(const CaseText& text = {}) {
    write("p.csv", full_trace());
    write("case.toml", text.text());
  }
  void write(const std::string& name, const std::string& text) const { write_text(folder_ / name, text); }
  std::string operator/(const std::string& name) const { return folder_ / name; }

  cycle::Case read(const std::vector<Override>& overrides = {}) const {
    return read_case(folder_ / "case.toml", overrides);
  }

  /// The faults of the case as a person sees them, without the folder's name; empty if there are none.
  std::string faults(const std::vector<Override>& overrides = {}) const {
    try {
      read(overrides);
    } catch (const InputError& error) {
      std::string text = error.what();
      const std::string prefix = folder_.path() + "/";
      for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) {
        text.erase(at, prefix.size());
      }
      return text;
    }
    return "";
  }

 private:
  ScratchFolder folder_;
};

inline std::string faults_of(const CaseText& text, const std::vector<Override>& overrides = {}) {
  return CaseFolder(text).faults(overrides);
}

}  // namespace ringfilm::io
