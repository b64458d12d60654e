#include "gas_path/gas_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ringfilm/cycle/pack/gas_quantities.hpp"
#include "text/engineering_text.hpp"

namespace ringfilm::app {
namespace {

/// A mass below that share of the largest one is rounding of the quadrature along the paths.
constexpr double kRounding = 1e-9;

std::string twist_cell(const gas_path::RingMotionValues& ring) {
  if (!ring.largest_static_twist) return "";
  const double twist = number_in(*ring.largest_static_twist, kDegree);
  if (twist == 0) return "       none";
  return fmt::format("{:>11.2g} degree at {:.0f}", twist, ring.largest_static_twist_angle_deg.value_or(0));
}

}  // namespace

std::string blow_by_text(const gas_path::GasSums& sums) {
  const EngineeringText shown;
  return shown(cycle::gas_sum_quantity("blow_by_per_cycle"), sums.blow_by_per_cycle) + " per cycle, " +
         shown(cycle::leading_gas_sum(), *cycle::number_of(cycle::leading_gas_sum(), sums)) +
         " at 1.01325 bar and 25 degC";
}

std::string reverse_blow_by_text(const gas_path::GasSums& sums) {
  if (!sums.reverse_blow_by_per_cycle) return "";
  const EngineeringText shown;
  const std::string share = sums.reverse_blow_by_charge_share && *sums.reverse_blow_by_charge_share > 0
                                ? fmt::format(" ({:.2g} % of the charge)", 100 * *sums.reverse_blow_by_charge_share)
                                : "";
  return "; back past the first ring " +
         shown(cycle::gas_sum_quantity("reverse_blow_by_per_cycle"), *sums.reverse_blow_by_per_cycle) + " per cycle" +
         share;
}

std::string regions_table(const io::PackGas& gas) {
  std::string text = fmt::format("{:<14}{:>16}{:>16}{:>16}\n", "region", "peak", "at", "mean");
  for (const gas_path::RegionValues& region : gas.regions) {
    text += fmt::format("{:<14}{:>16}{:>9.1f} degree{:>16}\n", region.name, text_in(region.peak_pressure, kBar, 4),
                        region.peak_pressure_angle_deg, text_in(region.mean_pressure, kBar, 4));
  }
  return text;
}

std::string paths_table(const io::PackGas& gas) {
  double largest = 0;
  for (const gas_path::PathValues& path : gas.paths) {
    largest = std::max({largest, path.mass_forward_per_cycle.value_or(0), path.mass_back_per_cycle.value_or(0)});
  }
  const auto cell = [largest](double mass) {
    return fmt::format("{:>13.4g}", std::abs(mass) < kRounding * largest ? 0.0 : number_in(mass, kMilligram));
  };
  std::string text = fmt::format("{:<18}{:>13}{:>13}{:>13}   mg per cycle and cylinder, to the crankcase\n", "path",
                                 "forward", "back", "net");
  for (const gas_path::PathValues& path : gas.paths) {
    if (!path.mass_forward_per_cycle || !path.mass_back_per_cycle) return "";
    text += fmt::format("{:<18}{}{}{}\n", path.name, cell(*path.mass_forward_per_cycle),
                        cell(*path.mass_back_per_cycle), cell(path.mass_per_cycle));
  }
  return text;
}

std::string composition_table(const io::PackGas& gas) {
  if (gas.scalars.empty()) return "";
  std::string text = fmt::format("{:<14}{:>17}{:>17}{:>15}{:>15}   of one cylinder\n", "gas", "into crankcase",
                                 "back to chamber", "crankcase", "by volume");
  for (const gas_path::ScalarValues& scalar : gas.scalars) {
    text += fmt::format("{:<14}{:>13.4g} g/h{:>8.3g} mg/cycle{:>13.3g} %{:>13.3g} %\n", scalar.name,
                        number_in(scalar.crankcase_flow, kGramPerHour), number_in(scalar.chamber_per_cycle, kMilligram),
                        100 * scalar.crankcase_mass_share, 100 * scalar.crankcase_mole_share);
  }
  text += fmt::format("\n{:<14}{:>16}{:>16}{:>22}{:>22}\n", "water in", "dew point up to", "wall from",
                      "above wall, of cycle", "could condense");
  for (const gas_path::RegionValues& region : gas.regions) {
    const auto cell = [](const std::optional<double>& value, const DisplayUnit& unit) {
      return value ? text_in(*value, unit, 3) : std::string("-");
    };
    text += fmt::format("{:<14}{:>16}{:>16}{:>20.3g} %{:>22}\n", region.name, cell(region.peak_dew_point, kCelsius),
                        cell(region.wall_temperature, kCelsius), 100 * region.condensing_share.value_or(0),
                        cell(region.condensable_water, kMilligram));
  }
  return text;
}

std::string ring_motion_table(const io::PackGas& gas) {
  std::string text = "ring   leaves lower flank   least force on the lower flank   unseated   largest static twist\n";
  for (std::size_t i = 0; i < gas.motion.size(); ++i) {
    const gas_path::RingMotionValues& ring = gas.motion[i];
    const std::string departures = fmt::format("{} x{}", ring.departures, ring.flutters ? ", flutters" : "");
    text += fmt::format("{:>4}{:>21}{:>12.4g} N at{:>6.0f} degree{:>11.1f} %{}\n", gas.rings[i].number, departures,
                        ring.least_seating_force, ring.least_seating_force_angle_deg, 100 * ring.unseated_share,
                        twist_cell(ring));
  }
  return gas.motion.empty() ? "" : text;
}

std::string ring_events_table(const io::PackGas& gas) {
  if (gas.events.empty()) return "";
  std::string text = "ring   crank angle   event\n";
  for (const io::PackGas::Event& event : gas.events) {
    text += fmt::format("{:>4}{:>7.2f} degree   {}\n", event.ring, event.crank_angle_deg, event.event);
  }
  return text;
}

}  // namespace ringfilm::app
