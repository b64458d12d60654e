#include "ringfilm/io/life/wear_table.hpp"

#include <fmt/format.h>

#include <numbers>
#include <optional>
#include <string>

#include "ringfilm/io/text/toml_table.hpp"

namespace ringfilm::io {
namespace {

constexpr const char* kCoefficient = "\"4e-18 m2/N\"";

/// UDUNITS reads "Nm" as one name, engineers as a product.
std::string with_product(std::string text) {
  const std::size_t at = text.find("/Nm");
  if (at != std::string::npos && at + 3 == text.size()) text.replace(at, 3, "/(N m)");
  return text;
}

class WearReader {
 public:
  WearReader(const TomlValue& value, const Units& units, std::vector<Fault>& faults)
      : table_(value, "[wear]",
               {"coefficient", "running_in_coefficient", "running_in_time", "surface", "orientations", "scheme",
                "jumps", "largest_depth", "jump_error", "tilt_spread", "tilt_samples", "edge_factor", "edge_distance",
                "liner_coefficient", "coating_thickness"},
               faults),
        units_(units) {}

  life::Wear read(const cycle::Case* base) {
    wear_.mark = table_.mark();
    read_coefficients();
    table_.choose("surface", {{"frozen", life::WornSurface::kFrozen}, {"path", life::WornSurface::kPath}},
                  wear_.surface);
    table_.choose("orientations", {{"given", life::WornOrientations::kGiven}, {"both", life::WornOrientations::kBoth}},
                  wear_.orientations);
    read_scheme();
    read_tilt();
    read_edges(base);
    wear_.coating_thickness = above_zero("coating_thickness", "m", "\"100 um\"");
    if (!wear_.coating_thickness && base != nullptr && base->ring.coating.youngs_modulus) {
      wear_.coating_thickness = base->ring.coating.thickness;
    }
    return wear_;
  }

 private:
  std::optional<double> above_zero(const std::string& key, const std::string& unit, const std::string& example) {
    const TomlValue* value = table_.find(key);
    if (value == nullptr) return std::nullopt;
    TomlValue written = *value;
    written.text = with_product(written.text);
    const auto number = table_.quantity(key, written, unit, example, units_);
    if (!number || *number > 0) return number;
    table_.refuse_value(key, "is not above 0", fmt::format("state, for example, {} = {}", key, example));
    return std::nullopt;
  }

  void read_coefficients() {
    const TomlValue* stated = table_.find("coefficient");
    if (stated == nullptr) {
      table_.refuse(table_.mark(), "[wear] has no coefficient",
                    fmt::format("write, for example, coefficient = {}, or \"fit\" with measured states", kCoefficient));
    }
    if (stated != nullptr && stated->text == "fit") {
      wear_.source = life::CoefficientSource::kFitted;
      for (const char* key : {"running_in_coefficient", "running_in_time", "jumps", "orientations"}) {
        table_.refuse_key(key, "means nothing with coefficient = \"fit\"",
                          "leave it out: the fit reports a coefficient for each measured state");
      }
    } else {
      wear_.coefficient = coefficient("coefficient").value_or(0);
      wear_.running_in_coefficient = coefficient("running_in_coefficient");
    }
    wear_.liner_coefficient = coefficient("liner_coefficient");
    const bool is_stated = wear_.source == life::CoefficientSource::kStated;
    if (is_stated && table_.find("running_in_coefficient") == nullptr) {
      table_.refuse_key("running_in_time", "means nothing without running_in_coefficient",
                        "state running_in_coefficient, for example \"3e-17 m2/N\", or leave the time out");
    }
    wear_.running_in_time = above_zero("running_in_time", "s", "\"10 h\"").value_or(wear_.running_in_time);
  }

  std::optional<double> coefficient(const std::string& key) {
    const auto number = above_zero(key, "m2/N", kCoefficient);
    if (!number || *number <= life::kMaxCoefficient) return number;
    table_.refuse_value(key, fmt::format("is above {:g} m2/N", life::kMaxCoefficient),
                        "a contact cannot remove more than all that it touches, 1/(3H): check the number and its unit");
    return std::nullopt;
  }

  void read_scheme() {
    table_.choose("scheme", {{"heun", life::WearScheme::kHeun}, {"euler", life::WearScheme::kEuler}}, wear_.scheme);
    if (const auto jumps = table_.count("jumps")) {
      if (*jumps < 1 || *jumps > life::kMaxJumps) {
        table_.refuse_value("jumps", fmt::format("is not from 1 to {}", life::kMaxJumps),
                            "state how many equal jumps the time to the last of the hours is divided into");
      } else {
        wear_.jumps = static_cast<int>(*jumps);
      }
      for (const char* key : {"largest_depth", "jump_error"}) {
        table_.refuse_key(key, "means nothing with jumps", "leave one of the two out");
      }
    }
    if (wear_.scheme == life::WearScheme::kEuler) {
      table_.refuse_key("jump_error", "means nothing with scheme = \"euler\"",
                        "leave it out, or take scheme = \"heun\"");
    }
    wear_.largest_depth =
        depth_of_jump("largest_depth", life::kMinJumpDepth, "\"0.15 um\"").value_or(wear_.largest_depth);
    wear_.jump_error = depth_of_jump("jump_error", life::kMinJumpError, "\"0.02 um\"").value_or(wear_.jump_error);
  }

  std::optional<double> depth_of_jump(const char* key, double smallest, const char* example) {
    const auto depth = above_zero(key, "m", example);
    if (!depth || *depth >= smallest) return depth;
    table_.refuse_value(key, "is below " + text_in(smallest, kNanometre),
                        fmt::format("faces are not known to the size of an atom, and each jump costs a cycle: state a "
                                    "larger one, for example {}",
                                    example));
    return std::nullopt;
  }

  void read_tilt() {
    constexpr double kMaxTilt = 80.0 / 60 * std::numbers::pi / 180;  // beyond it the edges carry: docs/theory/life.md
    constexpr double kRounding = 1e-9;
    wear_.tilt_spread = above_zero("tilt_spread", "rad", "\"50 arcminute\"").value_or(0);
    if (wear_.tilt_spread > kMaxTilt * (1 + kRounding)) {
      table_.refuse_value("tilt_spread", "is above 80 arcminute",
                          "beyond it the edges alone touch, and the film is not resolved there");
    }
    const auto samples = table_.count("tilt_samples");
    if (!samples) return;
    constexpr std::uint64_t kMax = 200;
    if (wear_.tilt_spread == 0) {
      table_.refuse_key("tilt_samples", "means nothing without tilt_spread",
                        "leave it out, or state tilt_spread, for example \"50 arcminute\"");
    } else if (*samples < 2 || *samples > kMax) {
      table_.refuse_value("tilt_samples", fmt::format("is not from 2 to {}", kMax),
                          "12 resolve a spread of 50 arcminute, 16 one of 80");
    } else {
      wear_.tilt_samples = static_cast<int>(*samples);
    }
  }

  void read_edges(const cycle::Case* base) {
    constexpr double kMaxEdgeFactor = 1000;
    if (const auto factor = table_.number("edge_factor")) {
      if (*factor >= 1 / kMaxEdgeFactor && *factor <= kMaxEdgeFactor) {
        wear_.edge_factor = *factor;
      } else {
        table_.refuse_value("edge_factor", fmt::format("is not from {:g} to {:g}", 1 / kMaxEdgeFactor, kMaxEdgeFactor),
                            "1 wears the edge zones as the middle, 10 ten times as fast");
      }
    }
    wear_.edge_distance = above_zero("edge_distance", "m", "\"0.3 mm\"").value_or(wear_.edge_distance);
    if (table_.find("edge_factor") != nullptr && base != nullptr &&
        wear_.edge_distance >= 0.5 * base->ring.face_width) {
      const TomlValue* distance = table_.find("edge_distance");
      table_.refuse(distance != nullptr ? distance->mark : table_.find("edge_factor")->mark,
                    fmt::format("wear.edge_distance is {} from the middle of a face that is {} wide",
                                text_in(wear_.edge_distance, kMillimetre), text_in(base->ring.face_width, kMillimetre)),
                    "state less than half of ring.face_width");
    }
    if (table_.find("edge_factor") != nullptr) return;
    table_.refuse_key("edge_distance", "means nothing without edge_factor",
                      "state edge_factor, for example 10, or leave the distance out");
  }

  TomlTable table_;
  const Units& units_;
  life::Wear wear_;
};

}  // namespace

life::Wear read_wear_table(const TomlValue& value, const cycle::Case* base, const Units& units,
                           std::vector<Fault>& faults) {
  return WearReader(value, units, faults).read(base);
}

}  // namespace ringfilm::io
