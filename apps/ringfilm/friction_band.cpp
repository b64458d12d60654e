#include "friction_band.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "ringfilm/cycle/setup/contact_setup.hpp"
#include "ringfilm/io/data/shipped_pairs.hpp"
#include "ringfilm/io/measurement/contact_law_file.hpp"
#include "ringfilm/study/ensemble/batch.hpp"

namespace ringfilm::app {
namespace {

using cycle::Case;

constexpr const char* kOfOil = "any-in-engine-oil";
constexpr int kPlacesOfCurve = 101;
constexpr double kEndOfCurve = 4;  // sigma
constexpr double kMinDrawn = 1e5;  // [Pa]

/// A law of the same two maps.
struct LawOfMaps {
  const char *name, *label;
  std::function<void(Case&)> choose;
};

Case with_summits(Case c, cycle::AsperityLaw asperity) {
  c.contact.model = cycle::ContactLaw::kGreenwoodWilliamson;
  c.contact.summit_plane = cycle::SummitPlane::kNayak;
  c.contact.asperity = asperity;
  return c;
}

/// One deviation of the scatter of the law: its shift, with what of the factor goes with it.
Case moved(Case c, double deviations) {
  const cycle::ContactLawTable& law = *c.contact.law;
  c.contact.law_shift = deviations * law.shift_deviation.value_or(0);
  c.contact.law_factor =
      std::exp(deviations * law.factor_deviation.value_or(0) * law.shift_factor_correlation.value_or(0));
  return c;
}

Case with_measured_flow(Case c) {
  c.film.flow_factors = c.film.shear_flow = c.film.stress_factors = cycle::Roughness::kMeasured;
  c.film.average_gap = cycle::AverageGap::kMeasured;
  return c;
}

std::vector<LawOfMaps> laws(const io::ContactLawFile& file) {
  const auto table = [law = file.law](Case c) {
    c.contact.model = cycle::ContactLaw::kTable;
    c.contact.law = law;
    return c;
  };
  return {{"greenwood_tripp", "Greenwood-Tripp as styles2014 feeds it", [](Case&) {}},
          {"greenwood_williamson", "Greenwood-Williamson, elastic",
           [](Case& c) { c = with_summits(std::move(c), cycle::AsperityLaw::kElastic); }},
          {"zhao_maietta_chang", "Greenwood-Williamson, flowing (Zhao-Maietta-Chang)",
           [](Case& c) { c = with_summits(std::move(c), cycle::AsperityLaw::kZhaoMaiettaChang); }},
          {"measured", "the maps", [table](Case& c) { c = table(std::move(c)); }},
          {"measured_low", "the maps, one deviation less", [table](Case& c) { c = moved(table(std::move(c)), -1); }},
          {"measured_high", "the maps, one deviation more", [table](Case& c) { c = moved(table(std::move(c)), 1); }},
          {"measured_flow", "the maps, and the flow between them",
           [table](Case& c) { c = with_measured_flow(table(std::move(c))); }}};
}

void add_column(io::MeasuredTable& table, const std::string& name, const std::string& words, const char* unit,
                const char* display) {
  io::MeasuredValue column;
  column.name = name;
  column.long_name = words;
  column.unit = unit;
  column.display_unit = display;
  table.columns.push_back(column);
  table.values.emplace_back();
}

/// Boundary friction coefficients to run with: own, low, typical, high.
struct Frictions {
  double own, low, typical, high;
  std::array<double, 4> all() const { return {own, low, typical, high}; }
};

Frictions frictions(const Case& c) {
  const io::FrictionPairs shipped = io::shipped_pairs(io::Units());
  const models::FrictionPair pair = pair_of_name(shipped, kOfOil);
  return {c.contact.boundary_shear_strength_coefficient, pair.low.value_or(pair.friction), pair.friction,
          pair.high.value_or(pair.friction)};
}

Case case_of(const FrictionBandRequest& request, const LawOfMaps& law, double coefficient) {
  Case c = request.input;
  c.contact.hardness = request.hardness;
  c.contact.boundary_shear_strength_coefficient = coefficient;
  c.output = {};
  law.choose(c);
  return c;
}

const cycle::CycleResult& result_of(const study::Ending& ending, const LawOfMaps& law) {
  if (ending.is_solved()) return ending.result;
  throw ConvergenceError(fmt::format("the cycle with the law \"{}\" has no result: {}", law.label, ending.reason()));
}

}  // namespace

io::Measurement friction_band(const FrictionBandRequest& request) {
  const io::ContactLawFile file = io::read_contact_law({request.law_path, request.law_path});
  const Frictions zeta = frictions(request.input);
  io::Measurement all;
  all.kind = "friction-band";
  all.title = "Friction of the " + request.ring + " ring by contact law";
  all.sources = {"contact law of the maps: " + request.law_path};
  all.statements = {
      "the same maps by each law; the closed laws take N, beta and sigma of their sum",
      fmt::format(
          "boundary friction coefficient {:.4g} as measured, and {:.2g} ({:.2g} to {:.2g}) of asperities in oil "
          "with anti-wear additive (typical, assumed)",
          zeta.own, zeta.typical, zeta.low, zeta.high),
      "lambda ratios refer to the roughness of each law: sigma of the closed ones, the rms height of both maps of "
      "theirs",
      "one deviation: of the law over relative positions and regions of the maps"};
  io::MeasuredTable table;
  table.name = "bands";
  table.title = "Film and mean friction power by contact law";
  add_column(table, "lambda_ratio_at_peak_pressure", "lambda ratio at the peak pressure", "1", "1");
  add_column(table, "min_film_thickness", "minimum film thickness", "m", "um");
  add_column(table, "power_as_measured", fmt::format("mean power loss, zeta {:.4g} as measured", zeta.own), "W", "W");
  add_column(table, "power_low", fmt::format("mean power loss, zeta {:.2g}", zeta.low), "W", "W");
  add_column(table, "power_typical", fmt::format("mean power loss, zeta {:.2g}", zeta.typical), "W", "W");
  add_column(table, "power_high", fmt::format("mean power loss, zeta {:.2g}", zeta.high), "W", "W");
  io::MeasuredCurve curve;
  curve.name = "laws";
  curve.title = "Contact laws of both maps";
  curve.caption = "Pressure against the separation of the mean planes, logarithmic.";
  curve.x_axis = {"separation", "separation", "m", "um"};
  curve.y_axis = {"contact_pressure", "contact pressure", "Pa", "MPa", true};
  for (int k = 0; k < kPlacesOfCurve; ++k) {
    curve.x.push_back(kEndOfCurve * file.law.composite_roughness * k / (kPlacesOfCurve - 1));
  }
  const std::vector<LawOfMaps> of_maps = laws(file);
  std::vector<Case> cases;  // for each law the cases of all coefficients, one after the other
  for (const LawOfMaps& law : of_maps) {
    for (const double coefficient : zeta.all()) cases.push_back(case_of(request, law, coefficient));
  }
  const std::vector<study::Ending> ended = study::endings(cases);
  for (std::size_t l = 0; l < of_maps.size(); ++l) {
    const LawOfMaps& law = of_maps[l];
    const std::size_t first = l * zeta.all().size();
    table.row_labels.push_back(law.label);
    const cycle::CycleValues& values = result_of(ended[first], law).values;
    std::vector<double> row = {values.lambda_ratio_at_peak_pressure, values.min_film_thickness};
    for (std::size_t k = 0; k < zeta.all().size(); ++k) {
      row.push_back(result_of(ended[first + k], law).values.mean_power_loss);
    }
    for (std::size_t k = 0; k < row.size(); ++k) table.values[k].push_back(row[k]);
    if (std::string(law.name) == "measured_flow") continue;  // its pressure is that of the maps
    io::MeasuredSeries series{law.name, law.label, {}, false};
    const auto contact = cycle::asperity_contact(cases[first]);
    for (const double h : curve.x) {
      const double p = contact->contact(h).pressure;
      series.y.push_back(p > kMinDrawn ? p : std::numeric_limits<double>::quiet_NaN());
    }
    curve.series.push_back(std::move(series));
  }
  all.tables.push_back(std::move(table));
  all.curves.push_back(std::move(curve));
  return all;
}

}  // namespace ringfilm::app
