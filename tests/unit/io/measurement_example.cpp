#include "measurement_example.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace ringfilm::io::example {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Numbers without pattern between 0 and 1, the same on every machine.
class Noise {
 public:
  double next() {
    state_ = 6364136223846793005ULL * state_ + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 40) / static_cast<double>(1ULL << 24);
  }

 private:
  std::uint64_t state_ = 7;
};

/// Hatched grooves under 40 degrees, some pores without heights, one spike.
MeasuredMap height_map(std::size_t points_x, std::size_t points_y) {
  MeasuredMap map;
  map.name = "surface_height";
  map.title = "Heights of the liner";
  map.caption = "After a plane and a Gaussian filter of 0.8 mm were removed.";
  map.points_x = points_x;
  map.points_y = points_y;
  map.step_x = map.step_y = 0.9e-3 / static_cast<double>(points_x);
  map.long_name = "height";
  map.unit = "m";
  map.display_unit = "um";
  Noise noise;
  for (std::size_t j = 0; j < points_y; ++j) {
    for (std::size_t i = 0; i < points_x; ++i) {
      const double x = static_cast<double>(i) * map.step_x, y = static_cast<double>(j) * map.step_y;
      const double one = std::sin(2 * std::numbers::pi * (x + 0.36 * y) / 61e-6);
      const double other = std::sin(2 * std::numbers::pi * (x - 0.36 * y) / 83e-6);
      const double groove = std::min(0.0, 0.55 - std::max(one, other));
      const bool in_pore = std::hypot(x - 0.3e-3, y - 0.2e-3) < 40e-6 || std::hypot(x - 0.62e-3, y - 0.45e-3) < 25e-6;
      map.values.push_back(in_pore ? kNone : 1e-6 * (2.6 * groove + 0.5 * (noise.next() - 0.5)));
    }
  }
  map.values[(points_y / 4) * points_x + 3 * points_x / 4] = kSpikeHeight;
  map.frames = {{0.05e-3, 0.05e-3, 0.2e-3, 0.2e-3, "1"}, {0.55e-3, 0.1e-3, 0.2e-3, 0.2e-3, "2"}};
  return map;
}

MeasuredCurve profile() {
  MeasuredCurve curve{"profile",
                      "Profile across the middle",
                      "The row through the middle of the map.",
                      {"x", "distance along the row", "m", "mm"},
                      {"height", "height", "m", "um"},
                      {},
                      {},
                      {}};
  constexpr int kPoints = 12000;
  std::vector<double> heights;
  Noise noise;
  for (int i = 0; i < kPoints; ++i) {
    curve.x.push_back(4e-3 * i / kPoints);
    heights.push_back(1e-6 * (0.8 * std::sin(i / 170.0) + 0.3 * (noise.next() - 0.5)));
  }
  heights[kPoints / 3] = 4e-6;
  for (int i = 5000; i < 5200; ++i) heights[i] = kNone;
  curve.series.push_back({"height", "height", heights, false});
  return curve;
}

MeasuredCurve material_ratio_curve() {
  MeasuredCurve curve{"bearing",
                      "Material ratio curve",
                      "Share of the surface above each height; the line through the core is that of ISO 13565-2.",
                      {"material_ratio", "material ratio", "1", "%"},
                      {"height", "height", "m", "um"},
                      {},
                      {},
                      {}};
  std::vector<double> heights, line;
  for (int i = 1; i < 200; ++i) {
    const double ratio = i / 200.0;
    curve.x.push_back(ratio);
    heights.push_back(0.4e-6 * std::log((1 - ratio) / ratio));
    line.push_back(0.8e-6 * (1 - 2 * ratio));
  }
  curve.series = {{"height", "measured", heights, false}, {"core", "line through the core", line, false}};
  curve.marks = {{0.09, "Mr1"}, {0.88, "Mr2"}};
  return curve;
}

MeasuredCurve spectrum() {
  MeasuredCurve curve{"spectrum",
                      "Power spectrum",
                      "Mean of all rows and of all columns; each has its own slope.",
                      {"spatial_frequency", "spatial frequency", "m-1", "mm-1", true},
                      {"density", "power spectral density", "m3", "um3", true},
                      {},
                      {},
                      {}};
  std::vector<double> along, across;
  Noise noise;
  for (int i = 1; i < 400; ++i) {
    const double frequency = 1100.0 * i;
    curve.x.push_back(frequency);
    along.push_back(1e-15 / (1 + std::pow(frequency / 2e4, 2.4)) * (0.6 + 0.8 * noise.next()));
    across.push_back(i == 20 ? kNone : 0.3 * along.back() / (1 + std::pow(frequency / 9e4, 2)));
  }
  curve.series = {{"along", "along x", along, false}, {"across", "along y", across, false}};
  curve.marks = {{4e5, "short cut-off 2.5 um"}};
  return curve;
}

MeasuredCurve cutoff_plot() {
  MeasuredCurve curve{"cutoff_density",
                      "Density of asperity peaks against the short cut-off",
                      "There is no plateau: the number belongs to the cut-off that is named with it.",
                      {"cutoff", "short cut-off", "m", "um", true},
                      {"asperity_density", "density of asperity peaks", "m-2", "mm-2", true},
                      {},
                      {},
                      {}};
  std::vector<double> moments, counted;
  for (const double cutoff : {1.25e-6, 2.5e-6, 5e-6, 10e-6, 20e-6, 40e-6}) {
    curve.x.push_back(cutoff);
    moments.push_back(0.19 / std::pow(cutoff, 2) * 0.1);
    counted.push_back(0.8 * moments.back());
  }
  curve.series = {{"moments", "from moments", moments, false}, {"counted", "counted", counted, true}};
  curve.marks = {{2.5e-6, "used"}};
  return curve;
}

MeasuredCurve friction_loop() {
  MeasuredCurve curve{"loop",
                      "Friction loop at 31 nN",
                      "Half the distance between the two is the friction signal.",
                      {"position", "position along the scan line", "m", "um"},
                      {"signal", "lateral signal", "V", "mV"},
                      {},
                      {},
                      {}};
  std::vector<double> trace, retrace;
  Noise noise;
  for (int i = 0; i < 256; ++i) {
    curve.x.push_back(1e-6 * i / 255.0);
    const double turn = std::min(1.0, i / 20.0), back = std::min(1.0, (255 - i) / 20.0);
    trace.push_back(0.012 * (2 * turn - 1) + 0.002 * noise.next());
    retrace.push_back(0.012 * (1 - 2 * back) + 0.002 * noise.next());
  }
  curve.series = {{"trace", "trace", trace, false}, {"retrace", "retrace", retrace, false}};
  return curve;
}

MeasuredValue value(const char* name, const char* long_name, const char* symbol, const char* unit, const char* shown_in,
                    double number, double error, const char* remark) {
  return {name, long_name, symbol, unit, shown_in, number, error, remark};
}

}  // namespace

Measurement measurement(std::size_t points_x, std::size_t points_y) {
  const char* fine = "S-filter 2.5 um, pixel 1 um";
  const char* waves = "Gaussian filter 0.8 mm, pixel 1 um";
  Measurement document;
  document.kind = "surface";
  document.title = "Liner, honed (made-up numbers)";
  document.sources = {"cases/measured/liner.x3p: X3P, one channel; 900 x 600 points of 1 um, 2 % missing",
                      "SHA-256 f735ac19f9270dc92d6d673287338669abf6744042760040459a815ec690802c"};
  document.statements = {"a plane was removed by least squares",
                         "waves longer than 0.8 mm were removed by a Gaussian filter (ISO 16610-61)",
                         "waves shorter than 2.5 um were removed before the moments were formed"};
  document.notes = {"N depends on the cut-off: halving it to 1.25 um multiplies N by 4, see the plot",
                    "2 % of the points are missing; no statistic counts them"};
  document.key_values = {"asperity_density", "asperity_radius", "Sq"};
  MeasuredGroup heights{"Heights", {}};
  heights.values = {value("Sa", "mean deviation of heights", "Sa", "m", "um", 0.3123e-6, kNone, waves),
                    value("Sq", "root mean square height", "Sq", "m", "um", 0.41234e-6, 0.0123e-6, waves),
                    value("Ssk", "skewness of heights", "Ssk", "1", "1", -1.62, 0.11, waves),
                    value("cavity_share", "share of the area in cavities", "", "1", "%", 0.149, 0.004,
                          "deeper than 1 um below the core, of the points that were measured")};
  MeasuredGroup contact{"Asperities", {}};
  contact.values = {
      value("asperity_density", "density of asperity peaks", "N", "m-2", "um-2", 0.0383e12, 0.0021e12, fine),
      value("asperity_radius", "mean radius of curvature of asperity peaks", "beta", "m", "um", 5.12e-6, kNone, fine),
      value("roughness_parameter", "product of density, radius and roughness", "N beta sigma", "1", "1", 0.0551, 0.002,
            fine),
      value("fourth_moment", "fourth spectral moment", "m4", "m-2", "um-2", 8.1e4, 3.2e3, fine),
      value("slope_ratio", "a number that this surface does not have", "", "1", "", kNone, kNone, fine)};
  document.groups = {heights, contact};
  MeasuredTable regions{"regions", "Each region", {}, {{0.0383e12, 0.0412e12}, {5.1e-6, kNone}}, {"1", "2"}};
  regions.columns = {value("asperity_density", "density of asperity peaks", "N", "m-2", "um-2", kNone, kNone, fine),
                     value("asperity_radius", "mean radius of asperity peaks", "beta", "m", "um", kNone, kNone, fine)};
  document.tables = {regions};
  document.maps = {height_map(points_x, points_y)};
  document.curves = {profile(), material_ratio_curve(), spectrum(), cutoff_plot(), friction_loop()};
  document.fragment = "[contact]\nasperity_density = \"0.0383 um-2\"\nasperity_radius = \"5.12 um\"\n";
  return document;
}

}  // namespace ringfilm::io::example
