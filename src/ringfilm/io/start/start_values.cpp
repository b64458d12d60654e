#include "ringfilm/io/start/start_values.hpp"

#include <cmath>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/joined.hpp"
#include "ringfilm/case/conditions.hpp"
#include "ringfilm/io/data/shipped_surfaces.hpp"
#include "ringfilm/io/text/toml_tree.hpp"

namespace ringfilm::io {

const std::string kAssumed = "typical, assumed";

namespace {

const std::string kElasticPressure = kAssumed + "; 0.12 to 0.25 MPa are usual";

/// sigma/beta of 0.01 is at the smooth end of the usual range (docs/manual/guide/typical-inputs.md).
constexpr double kRadius = 10e-6, kProduct = 0.05;  // [m], [-]
/// Classes of the surfaces.
const std::string kLiner = "plateau-honed-grey-iron", kRing = "nitrided";

StartValue speed(const char* value) { return {"operating.speed", value, ""}; }

std::vector<StartValue> walls(const char* ring, const char* liner) {
  return {{"thermal.ring", ring, ""}, {"thermal.liner", liner, ""}};
}

std::vector<StartValue> together(std::vector<StartValue> values, const std::vector<StartValue>& more) {
  values.insert(values.end(), more.begin(), more.end());
  return values;
}

/// Above the coolant by what was measured (docs/manual/guide/typical-inputs.md).
std::vector<StartValue> part_load_of_car() {
  return walls("\"125 degC\"", R"([["0 mm", "115 degC"], ["40 mm", "100 degC"], ["80 mm", "102 degC"]])");
}

std::vector<StartValue> walls_of_diesel(bool full) {
  return full ? walls("\"180 degC\"", R"([["0 mm", "160 degC"], ["80 mm", "110 degC"], ["160 mm", "105 degC"]])")
              : walls("\"150 degC\"", R"([["0 mm", "130 degC"], ["80 mm", "100 degC"], ["160 mm", "98 degC"]])");
}

StartEngine passenger_car() {
  return {"passenger-car",
          "Passenger-car engine",
          {{"engine.bore", "\"89 mm\"", ""},
           {"engine.stroke", "\"79.5 mm\"", ""},
           {"engine.connecting_rod_length", "\"138.1 mm\"", ""}},
          {{"ring.face_width", "\"1.2 mm\"", ""}, {"ring.elastic_pressure", "\"0.2 MPa\"", kElasticPressure}},
          {"10 um", "6 um", "3 um"},
          {},
          "SAE 5W-30",
          "passenger-car",
          {},
          {{"part load",
            0.7,
            together({speed("\"2000 rpm\"")}, part_load_of_car()),
            {{"gas.peak_pressure", "\"30 bar\"", ""}, {"gas.intake_pressure", "\"0.5 bar\"", ""}}},
           {"full load, low speed",
            0.2,
            {speed("\"1500 rpm\"")},
            {{"gas.peak_pressure", "\"62 bar\"", ""}, {"gas.intake_pressure", "\"0.95 bar\"", ""}}},
           {"full load, high speed",
            0.1,
            {speed("\"5000 rpm\"")},
            {{"gas.peak_pressure", "\"75 bar\"", ""}, {"gas.intake_pressure", "\"0.95 bar\"", ""}}}}};
}

StartEngine heavy_duty() {
  return {"heavy-duty",
          "Heavy-duty diesel engine",
          {{"engine.bore", "\"130 mm\"", ""},
           {"engine.stroke", "\"160 mm\"", ""},
           {"engine.connecting_rod_length", "\"260 mm\"", ""}},
          {{"ring.face_width", "\"3 mm\"", ""}, {"ring.elastic_pressure", "\"0.2 MPa\"", kElasticPressure}},
          {"8 um", "4 um", "2 um"},
          {{"gas.compression_ratio", "17", ""}, {"gas.peak_angle", "\"15 degree\"", ""}},
          "SAE 15W-40",
          "heavy-duty",
          {},
          {{"part load",
            0.5,
            together({speed("\"1300 rpm\"")}, walls_of_diesel(false)),
            {{"gas.peak_pressure", "\"90 bar\"", ""},
             {"gas.intake_pressure", "\"1.3 bar\"", ""},
             {"gas.exhaust_pressure", "\"1.3 bar\"", ""}}},
           {"full load, low speed",
            0.3,
            together({speed("\"1200 rpm\"")}, walls_of_diesel(true)),
            {{"gas.peak_pressure", "\"160 bar\"", ""},
             {"gas.intake_pressure", "\"2.5 bar\"", ""},
             {"gas.exhaust_pressure", "\"2.2 bar\"", ""}}},
           {"full load, high speed",
            0.2,
            together({speed("\"1800 rpm\"")}, walls_of_diesel(true)),
            {{"gas.peak_pressure", "\"170 bar\"", ""},
             {"gas.intake_pressure", "\"2.8 bar\"", ""},
             {"gas.exhaust_pressure", "\"2.6 bar\"", ""}}}}};
}

/// Spark ignition, lean, turbocharged, in the rings and the cylinder of the diesel engine.
StartEngine hydrogen() {
  StartEngine engine = heavy_duty();
  engine.name = "hydrogen";
  engine.title = "Hydrogen engine of a truck";
  engine.gas = {{"gas.compression_ratio", "12", ""},
                {"gas.peak_angle", "\"12 degree\"", ""},
                {"gas.burn_duration", "\"40 degree\"", ""}};
  engine.grade = "SAE 5W-30";
  engine.composition = {{"gas.composition.fuel", quoted("hydrogen"), "followed through the rings"},
                        {"gas.composition.excess_air_ratio", "2.2", kAssumed + ": lean, against knock and NOx"},
                        {"gas.composition.premixed_share", "1", kAssumed + ": injected before it burns"},
                        {"gas.composition.residual_share", "0.04", ""},
                        {"gas.composition.burn_begin", "\"-12 degree\"", ""},
                        {"gas.composition.crankcase_air", "\"0 kg/h\"", "no forced ventilation of the crankcase"},
                        {"gas_path.properties", quoted("mixture"), "gas constant, gamma and viscosity of the charge"},
                        {"gas_path.mixture_burnt_share", "0.5", ""}};
  const auto pressures = [](const char* peak, const char* intake, const char* exhaust) -> std::vector<StartValue> {
    return {
        {"gas.peak_pressure", peak, ""}, {"gas.intake_pressure", intake, ""}, {"gas.exhaust_pressure", exhaust, ""}};
  };
  engine.points[0].gas = pressures("\"70 bar\"", "\"1.5 bar\"", "\"1.4 bar\"");
  engine.points[1].gas = pressures("\"120 bar\"", "\"2.4 bar\"", "\"2 bar\"");
  engine.points[2].gas = pressures("\"130 bar\"", "\"2.8 bar\"", "\"2.4 bar\"");
  return engine;
}

}  // namespace

const std::vector<StartEngine>& start_engine_table() {
  static const std::vector<StartEngine> table = {passenger_car(), heavy_duty(), hydrogen()};
  return table;
}

std::vector<StartValue> start_contact(const std::string& state) {
  const Units units;
  const SurfaceClasses classes = shipped_surfaces(units);
  const LinerSurface liner = liner_of_name(classes, kLiner, state);
  const RingSurface ring = ring_of_name(classes, kRing, state);
  const auto micrometres = [](double value) { return quoted(text_in(value, kMicrometre, 4)); };
  const double sigma = std::hypot(liner.plateau.Rpq, ring.roughness);
  const std::string where = " (" + state + " in " + kSurfacesFile + ")";
  return {{"contact.model", quoted("greenwood-williamson"), "with the next three: docs/manual/guide/contact-law.md"},
          {"contact.asperity", quoted("zhao-maietta-chang"), "asperities flow from the hardness on"},
          {"contact.summit_plane", quoted("nayak"), "summits lie above the mean plane of the surface"},
          {"contact.hardness", quoted(text_in(*liner.hardness, kGigapascal, 4)), liner.source + ": " + liner.name},
          {"contact.asperity_density", quoted(text_in(kProduct / (kRadius * sigma), kPerSquareMicrometre, 3)),
           kAssumed + ": N beta sigma = 0.05, sigma of ring and plateau"},
          {"contact.asperity_radius", micrometres(kRadius), ""},
          {"contact.boundary_shear_strength_coefficient", "0.12", kAssumed + ": engine oil with anti-wear additive"},
          {"contact.plateau.Rpq", micrometres(liner.plateau.Rpq), liner.source + ": " + liner.name + where},
          {"contact.plateau.Rvq", micrometres(liner.plateau.Rvq), liner.source},
          {"contact.plateau.Rmq", number_text(liner.plateau.Rmq, 4), liner.source},
          {"contact.plateau.ring_roughness", micrometres(ring.roughness), ring.source + ": " + ring.name + where}};
}

std::vector<StartValue> start_walls(const StartPoint& point) {
  for (const StartValue& value : point.operation) {
    if (value.key == "thermal.liner") return {};
  }
  cycle::Case measured;
  set_conditions(cycle::Conditions::kEngine, measured);
  std::vector<std::string> liner;
  for (const auto& [distance, temperature] : measured.thermal.liner) {
    liner.push_back("[" + quoted(text_in(distance, kMillimetre, 3)) + ", " + quoted(text_in(temperature, kCelsius, 3)) +
                    "]");
  }
  return {{"thermal.ring", quoted(text_in(*measured.thermal.ring, kCelsius, 3)), ""},
          {"thermal.liner", "[" + joined(liner, ", ") + "]",
           "mean around the bore of a car engine, measured (docs/manual/guide/typical-inputs.md)"}};
}

}  // namespace ringfilm::io
