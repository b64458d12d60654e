#include "study_example.hpp"

#include <cmath>
#include <limits>

#include "../io/case_example.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/io/storage/shard_file.hpp"
#include "ringfilm/io/study/study_file.hpp"
#include "ringfilm/io/study/study_result.hpp"
#include "ringfilm/report/study_page.hpp"
#include "ringfilm/study/design/kept_curves.hpp"

namespace example {

using namespace ringfilm;
namespace {

const std::string kBases =
    "[[base]]\nname = \"new\"\ncase = \"case.toml\"\n[[base]]\nname = \"worn\"\ncase = \"case.toml\"\n";
const std::string kSpeed = "[[factor]]\nname = \"speed\"\nkey = \"operating.speed\"\n";
const std::string kWarmth = "[[factor]]\nname = \"warmth\"\nkey = \"operating.oil_temperature\"\nhow = \"add\"\n";
const std::string kRoughness = "[[factor]]\nname = \"roughness\"\nkey = \"contact.roughness\"\nhow = \"scale\"\n";

/// Films thicken with speed and thin with warmth; what is asked for follows.
double value(const std::string& name, double speed, double warmth, double roughness, double worn) {
  const double film = 0.5e-6 * std::sqrt(speed / 200) * std::exp(-0.01 * warmth) * (1 - 0.2 * worn);
  const double lambda = film / (0.48e-6 * roughness);
  const double friction = 10 + 60 * std::exp(-lambda) + 0.02 * speed;
  if (name == "min_film_thickness") return film;
  if (name == "mean_lambda_ratio" || name == "min_lambda_ratio") return lambda;
  if (name.starts_with("boundary_regime_")) return 1 / (1 + lambda * lambda);
  if (name.starts_with("full_film_")) return 0.4 * lambda * lambda / (1 + lambda * lambda);
  if (name.starts_with("mixed_regime_")) return 0.6 * lambda * lambda / (1 + lambda * lambda);
  if (name == "mean_stribeck_number") return 1e-6 * speed / 200 * std::exp(-0.02 * warmth);
  if (name == "mean_friction_coefficient") return friction / 900;
  if (name == "mean_boundary_power") return 60 * std::exp(-lambda);
  if (name == "fmep") return 500 * friction;
  return friction;
}

MadeUp with(const std::vector<std::string>& factors) {
  return [factors](const std::string& name, const study::Point& point) {
    double speed = 200, warmth = 0, roughness = 1;
    for (std::size_t j = 0; j < factors.size(); ++j) {
      if (!point.values[j]) continue;
      if (factors[j] == "speed") speed = *point.values[j];
      if (factors[j] == "warmth") warmth = *point.values[j];
      if (factors[j] == "roughness") roughness = *point.values[j];
      if (factors[j] == "law") roughness *= 1 + 0.2 * *point.values[j];
    }
    return value(name, speed, warmth, roughness, static_cast<double>(point.base));
  };
}

}  // namespace

std::string study_page(const std::string& lines, const MadeUp& made_up,
                       const std::vector<std::pair<std::string, std::string>>& files) {
  const io::ScratchFolder folder;
  folder.write("case.toml", io::CaseText{}.text());
  folder.write("p.csv", io::full_trace());
  for (const auto& [name, text] : files) folder.write(name, text);
  const io::StudyFile file = io::read_study(folder.write("study.toml", lines));
  const study::Plan plan(file.study);
  const study::OutputSelection& keep = plan.study().keep;
  const auto& quantities = cycle::cycle_quantities();
  const std::vector<double> angles = study::kept_angles(keep);
  const auto kept = study::kept_curves(plan.study());
  study::ScenarioBlock block{0, {}};
  for (std::uint64_t i = 0; i < plan.size(); ++i) {
    const study::Point point = plan.point(i);
    study::ScenarioRow row;
    for (const auto& quantity : quantities) row.values.push_back(made_up(quantity.name, point));
    const double film = made_up("min_film_thickness", point);
    if (!std::isfinite(film)) {
      row.values.assign(quantities.size(), std::numeric_limits<double>::quiet_NaN());
      row.reason = "no film balances the load";
      row.curves = study::no_kept_numbers(plan.study());
    } else {
      if (i % 3 == 0) row.notes = {{"shear-rate-high", "shear rate U/h up to 2e+07 1/s", 5}};
      for (std::size_t q = 0; q < kept.size(); ++q) {
        for (const double angle : angles)
          row.curves.push_back(static_cast<float>(film * (1.5 - std::cos(angle * M_PI / 180)) * (q == 0 ? 1 : 1e8)));
      }
    }
    block.rows.push_back(std::move(row));
  }
  io::ShardHeader header{"plan", "inputs", "program", 1, 1, 0, plan.size(), quantities.size(), {}, angles.size()};
  for (const study::KeptCurve& curve : kept) header.curves.push_back(curve.quantity.name);
  io::ShardWriter(folder / "rows", header).append(block);
  std::vector<io::ShardReader> shards;
  shards.emplace_back(folder / "rows");
  io::StudyRows rows{file, plan, std::move(shards)};
  rows.error = study::SampledError{{0, 2}, 1, {}, {0.5}, 80, 78};
  rows.error->quantiles.resize(quantities.size());
  rows.error->quantiles[*cycle::cycle_quantity_index("fmep")] = 0.0021;
  rows.error->quantiles[*cycle::cycle_quantity_index("mean_friction_coefficient")] = 0.0456;
  rows.error->quantiles[*cycle::cycle_quantity_index("net_oil_flow")] = 11.29;
  return report::study_page(rows, io::Units(), {"ringfilm 0.0.0", "abc", "g++", ""});
}

std::string uncertainty_page(const std::string& title) {
  std::string quoted;
  for (const char c : title) quoted.append(c == '"' || c == '\\' ? "\\" : "").append(1, c);
  return study_page("title = \"" + quoted + "\"\nkind = \"uncertainty\"\n" + kBases + kSpeed +
                        "distribution = \"normal\"\nmean = \"2000 rpm\"\ndeviation = \"100 rpm\"\n" + kWarmth +
                        "distribution = \"uniform\"\nlower = \"-10 K\"\nupper = \"10 K\"\n" + kRoughness +
                        "distribution = \"lognormal\"\nmedian = 1.0\nlog_deviation = 0.1\n" +
                        "[[correlation]]\nfactors = [\"speed\", \"warmth\"]\nvalue = 0.5\n" +
                        "[plan]\nmethod = \"sobol\"\nscenarios = 64\nindices = \"first-and-total\"\n" +
                        "[keep]\ncurves = \"quantiles\"\ncrank_step = \"10 degree\"\n"
                        "quantities = [\"min_film_thickness\", \"friction_on_liner\"]\n",
                    with({"speed", "warmth", "roughness"}));
}

std::string map_page() {
  const MadeUp all = with({"speed", "warmth", "law"});
  return study_page("title = \"made-up map\"\nkind = \"map\"\n" + kBases + kSpeed +
                        "range = [\"1000 rpm\", \"6000 rpm\"]\npoints = 11\n" + kWarmth +
                        "range = [\"-20 K\", \"20 K\"]\npoints = 7\n" +
                        "[[factor]]\nname = \"law\"\nkey = \"lubricant.viscosity_pressure\"\n"
                        "values = [\"roelands\", \"barus\"]\n[plan]\nmethod = \"grid\"\n",
                    [all](const std::string& name, const study::Point& point) {
                      const bool is_corner = *point.values[0] < 150 && *point.values[1] > 15;
                      return is_corner ? std::numeric_limits<double>::quiet_NaN() : all(name, point);
                    });
}

std::string screening_page() {
  return study_page("title = \"made-up screening\"\nkind = \"screening\"\n" + kBases + kSpeed +
                        "range = [\"1000 rpm\", \"6000 rpm\"]\n" + kWarmth + "range = [\"-20 K\", \"20 K\"]\n" +
                        kRoughness + "range = [0.5, 1.5]\n[plan]\nmethod = \"morris\"\ntrajectories = 10\n",
                    with({"speed", "warmth", "roughness"}));
}

std::string points_page() {
  std::string lines =
      "title = \"made-up duty\"\nkind = \"compare\"\n" + kBases + "[plan]\nmethod = \"operating-points\"\n";
  for (const char* point : {"name = \"idle\"\nweight = 2\nvalues = { \"operating.speed\" = \"1000 rpm\" }\n",
                            "name = \"part load\"\nweight = 5\nvalues = { \"operating.speed\" = \"2000 rpm\" }\n",
                            "name = \"full speed\"\nweight = 1\nvalues = { \"operating.speed\" = \"5000 rpm\" }\n"})
    lines.append("[[point]]\n").append(point);
  return study_page(lines, [](const std::string& name, const study::Point& point) {
    const double rpm = *point.values[0] * 30 / M_PI;
    return name == "fmep" ? rpm + 1000 * static_cast<double>(point.base) : 1e-6;
  });
}

std::string sweep_page() {
  return study_page("title = \"made-up sweep\"\nkind = \"map\"\n[[base]]\nname = \"new\"\ncase = \"case.toml\"\n" +
                        kSpeed + "range = [\"1000 rpm\", \"5000 rpm\"]\npoints = 9\n" +
                        "[plan]\nmethod = \"grid\"\n[keep]\ncurves = \"all\"\ncrank_step = \"10 degree\"\n"
                        "quantities = [\"min_film_thickness\", \"friction_on_liner\"]\n",
                    [](const std::string& name, const study::Point& point) {
                      const double share = *point.values[0] / 100;
                      return name == "min_film_thickness" ? 1e-6 * share : 1 + 1e-6 * share;
                    });
}

std::string comparison_page() {
  return study_page("title = \"made-up comparison\"\nkind = \"compare\"\n" + kBases +
                        "[[factor]]\nname = \"law\"\nkey = \"lubricant.viscosity_pressure\"\n"
                        "values = [\"roelands\", \"barus\"]\n[plan]\nmethod = \"grid\"\n",
                    with({"law"}));
}

}  // namespace example
