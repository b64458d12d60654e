#include "ringfilm/cycle/advice/gas_plausibility.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/base/display.hpp"
#include "ringfilm/cycle/setup/indicated_pressure.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/cycle/setup/trace_zero.hpp"

namespace ringfilm::cycle {
namespace {

/// Compression alone peaks at firing TDC, or a degree before. Combustion shifts the peak by 5 to 25 degree, a late one
/// by 40; at 60 degree the volume is about four times that at TDC, so that the peak of compression stays the highest.
/// Knock and early combustion peak 10 to 20 degree before TDC.
constexpr double kEarliestPeakDeg = -30, kLatestPeakDeg = 60;
/// Compression by 4, less than that of any engine, raises the pressure six times. A trace below this ratio of its
/// highest to its lowest pressure shows no compression, as on a rig without a cylinder head, and no peak to look at.
constexpr double kMinCompression = 2;
/// Without compression the cylinder is open to the atmosphere, whose pressure stays below 1.09 bar.
constexpr double kMaxOpen = 1.2e5;
/// Between these angles the valves of any engine are closed, and combustion has not begun, or raises the pressure;
/// eq-weak-compression.
constexpr double kCompressionFromDeg = -75, kCompressionToDeg = -45;
/// Real compression has an exponent of about 1.3. Isothermal compression at this ratio is weaker
/// than that of historic engines (ratio 4, exponent 1.3), and weaker than one at a ratio of 10 that leaks as much as to
/// an exponent of 0.85.
constexpr double kMinRatio = 6;
/// The polytropic index of a compression follows from a trace and its compression ratio, which is not stated; it falls
/// where a higher ratio is assumed. Charged engines have ratios of 8 and more, and seal; their index is 1.25 to 1.4. A
/// trace that never falls to the atmosphere is that of a charged engine, or has an offset. Others may have any ratio,
/// and leak at cranking speed.
constexpr double kMinChargedRatio = 8, kMinIndex = 1.25;
/// Cold air without losses has 1.4; the rest is scatter.
constexpr double kMaxIndex = 1.43;
/// A pressure that is added or missing bends ln p over ln V, most where p is low. Both halves of a sealed compression
/// have one index with some compression ratio, 1.25 to 1.4; a tenth of a bar of an indicator or heat, which differs
/// along the way, move that index by 0.1. An offset of 0.2 bar at 1 bar moves it by 0.2.
constexpr double kMinCommonIndex = 1.15, kMaxCommonIndex = 1.55;
/// Without an offset the pressure of an engine that is not charged falls below that of the atmosphere; one that leaks
/// at cranking speed has a low index, too.
constexpr double kMinAdded = 1.1e5;
constexpr double kLatestCommonStartDeg = -100;  ///< latest start of a compression whose halves are compared [degree]
constexpr const char* kPeg =
    "Peg it to the intake pressure at bottom dead centre, and check gas.pressure_reference and TDC";
constexpr double kMinRatioTried = 5, kMaxRatioTried = 60;
/// Most intake valves are closed from here on.
constexpr double kIndexFromDeg = -120;
/// Where the pressure rises by less than with this index, the intake valve is still open.
constexpr double kOpenIndex = 0.5, kOpenRatio = 10;

/// Without combustion the pressure falls as it rises, about a peak that heat and leakage shift by 0.3 to 1.3 degree
/// before TDC, by up to 2 at cranking speed; TDC is known to a few tenths of a degree. Where the peak lies later than 5
/// degree, combustion has shifted it.
constexpr double kEarliestMotoredDeg = -2, kLatestMotoredDeg = 0.5, kEarliestFiredDeg = 5;
/// ln of the pressure after that peak over the one as far before it: heat and leakage lower it by less than 0.005 per
/// degree, and nothing raises it. Combustion that leaves the peak before 5 degree raises it by more than 0.02.
constexpr double kMotoredLoss = 0.005, kMotoredGain = 0.02;
/// The peak lies in the middle of the pressures above this share of it, whatever the noise.
constexpr double kTopOfPeak = 0.95;

/// No manifold of a running engine falls below 0.2 bar absolute: a closed throttle on the overrun leaves 0.2 to 0.3.
constexpr double kDeepestVacuum = 0.2e5;
/// The exhaust flows out against the atmosphere, which has 0.6 bar at a height of 4000 m.
constexpr double kThinAir = 0.6e5;
/// The charge of one turbocharger has up to 5 bar absolute; only large engines with two in series have more.
constexpr double kMaxCharge = 6e5;
/// Series engines peak below 300 bar, and heavy knock below 400.
constexpr double kMaxPeak = 400e5;
/// The lowest pressure above the atmosphere of a naturally aspirated engine is below zero. For a charged engine it is
/// the boost, which is seldom above this bound. As an absolute pressure, the same number is the pressure of the
/// atmosphere less the loss of an open throttle.
constexpr double kMaxUsualBoost = 0.7e5;

/// Bounds of a compression up to the start of a trace: that of no engine is larger, and no exponent above that of cold
/// air without losses.
constexpr double kMaxRatio = 25, kAdiabatic = 1.4;
/// Waves in the intake pipe and losses of the valves move the pressure at the end of intake by less than this share.
constexpr double kIntakeScatter = 0.3;
/// Below this ratio of pressures the flow through a valve is choked (air: 0.528): no valve that lets an engine breathe
/// leaves such a difference.
constexpr double kChoked = 0.528;

constexpr double kExhaustBeginDeg = 220, kExhaustEndDeg = 320;  // away from blow-down and valve overlap
constexpr double kIntakeBeginDeg = 400, kIntakeEndDeg = 500;    // away from valve overlap and compression

/// Fast homogeneous combustion takes about 10 degrees; below 5 the pressure jumps as in a detonation.
constexpr double kMinBurnDeg = 5;

/// An angle of Wiebe's cycle and where engines have it, early and late closing after Miller and Atkinson included.
struct UsualAngle {
  const char* key;
  double Gas::*angle_deg;
  double low, high;  ///< from firing TDC [degree]
};
constexpr UsualAngle kValveAngles[] = {{"gas.exhaust_valve_opening", &Gas::exhaust_valve_opening_deg, 80, 210},
                                       {"gas.exhaust_valve_closing", &Gas::exhaust_valve_closing_deg, 290, 440},
                                       {"gas.intake_valve_opening", &Gas::intake_valve_opening_deg, 280, 440},
                                       {"gas.intake_valve_closing", &Gas::intake_valve_closing_deg, 440, 660}};

/// IMEP is stated with two or three digits, and a tenth of a degree of TDC moves it by 1 %; assumed.
constexpr double kImepScatter = 0.02, kMinImepScatter = 0.05e5;

double volume_above(const Case& c, double crank_angle_deg, double compression_ratio) {
  return volume_in_strokes(c.engine, crank_angle_deg, compression_ratio);
}

class GasNotes {
 public:
  GasNotes(const Case& c, const models::CyclePressure& cylinder, std::vector<Note>& notes)
      : case_(c), gas_(c.gas), cylinder_(cylinder), notes_(notes) {
    if (is_wiebe()) {
      look_at_cycle();
    } else {
      look_at_trace(*gas_.cylinder_pressure);
    }
  }

  void append() {
    append_pegging();
    const std::size_t notes_before = notes_.size();
    if (is_wiebe()) append_angles();
    append_place_of_peak();
    append_weak_compression();
    append_low_pressures();
    append_high_pressures();
    append_jump();
    // Each may follow from what has a note already.
    if (!is_wiebe() && notes_.size() == notes_before) append_motored_peak();
    if (!is_wiebe() && notes_.size() == notes_before) {
      if (case_.stated.contains("gas.compression_ratio")) {
        append_stated_index();
        if (notes_.size() == notes_before) append_bend();
      } else {
        append_index();
      }
    }
    append_imep();
  }

 private:
  bool is_wiebe() const { return gas_.model == GasModel::kWiebe; }
  bool is_gauge() const { return !is_wiebe() && gas_.pressure_reference == PressureReference::kGauge; }

  void look_at_trace(const SampledTrace& trace) {
    const auto [low, high] = std::minmax_element(trace.value.begin(), trace.value.end());
    const double rise = rise_of_cylinder_trace(case_);
    lowest_ = *low + rise;
    highest_ = *high + rise;
    peak_deg_ = from_firing_deg(gas_, trace.crank_angle_deg[static_cast<std::size_t>(high - trace.value.begin())]);
    is_whole_ = models::covers_cycle(trace.crank_angle_deg);
    first_deg_ = from_firing_deg(gas_, trace.crank_angle_deg.front());
  }

  void look_at_cycle() {
    lowest_ = highest_ = cylinder_.peak();
    for (int deg = 0; deg < static_cast<int>(kCycleDeg); ++deg) lowest_ = std::min(lowest_, cylinder_.pressure(deg));
    const double angle = wrapped(cylinder_.peak_angle_deg());
    peak_deg_ = angle < kCycleDeg / 2 ? angle : angle - kCycleDeg;
    is_whole_ = true;
  }

  /// What to check: of a trace, or the keys of Wiebe's cycle.
  std::string check(const char* of_trace, const char* of_wiebe) const { return is_wiebe() ? of_wiebe : of_trace; }

  double mean(double from_deg, double to_deg) const {
    double sum = 0;
    int n = 0;
    for (double angle = from_deg; angle <= to_deg; angle += 10, ++n) sum += cylinder_.pressure(angle);
    return sum / n;
  }

  void append_angles() {
    for (const UsualAngle& usual : kValveAngles) {
      const double angle = gas_.*usual.angle_deg;
      if (angle >= usual.low && angle <= usual.high) continue;
      note("valve-timing-unusual", std::string(usual.key) + " = " + number_text(angle) +
                                       " degree: four-stroke engines have " + number_text(usual.low) + " to " +
                                       number_text(usual.high) + " degree, counted from firing TDC");
    }
    if (gas_.burn_duration_deg >= kMinBurnDeg) return;
    note("burn-duration-short", "gas.burn_duration = " + number_text(gas_.burn_duration_deg) +
                                    " degree: the fastest combustion of engines takes about 10 degree, and below " +
                                    number_text(kMinBurnDeg) + " the pressure jumps as in a detonation");
  }

  void note(const char* topic, std::string message) { notes_.push_back({topic, std::move(message), 1}); }

  bool is_compressed() const { return highest_ >= kMinCompression * lowest_; }
  bool is_peak_in_place() const { return peak_deg_ >= kEarliestPeakDeg && peak_deg_ <= kLatestPeakDeg; }

  void append_pegging() {
    if (is_wiebe() || gas_.pegging == Pegging::kNone) return;
    note("gas-pegged", "the cylinder pressure was pegged (gas.pegging): " + text_in(pegging_shift(case_), kBar, 3) +
                           " was added to the trace");
  }

  void append_place_of_peak() {
    if (!is_compressed() || is_peak_in_place()) return;
    const bool near_gas_exchange = std::abs(peak_deg_) > kCycleDeg / 4;
    note("gas-peak-place",
         "the cylinder pressure has its peak at " + number_text(wrapped(peak_deg_)) + " degree, " +
             (near_gas_exchange ? "near gas-exchange TDC" : "away from firing TDC at 0 degree") +
             check(": is gas.angle_zero right, and the unit of the crank angle?", ": is gas.peak_angle right?"));
  }

  void append_weak_compression() {
    if (!is_compressed()) {
      if (lowest_ <= kMaxOpen || lowest_ > kMaxCharge) return;
      note("gas-compression-low",
           "the cylinder pressure stays between " + text_in(lowest_, kBar) + " and " + text_in(highest_, kBar) +
               " absolute: it shows no compression, and a rig without a cylinder head has the pressure of the "
               "atmosphere: " +
               check("are the unit of the trace and gas.pressure_reference right?", "is gas.peak_pressure right?"));
      return;
    }
    const bool has_compression = is_whole_ || first_deg_ <= kCompressionFromDeg;
    if (!is_peak_in_place() || !has_compression || lowest_ < kDeepestVacuum) return;
    const double from = cylinder_.pressure(kCompressionFromDeg), to = cylinder_.pressure(kCompressionToDeg);
    const double least =
        volume_above(case_, kCompressionFromDeg, kMinRatio) / volume_above(case_, kCompressionToDeg, kMinRatio);
    if (to >= least * from) return;
    note("gas-compression-low", "the cylinder pressure rises from " + text_in(from, kBar) + " absolute at " +
                                    number_text(-kCompressionFromDeg) + " degree before firing TDC to " +
                                    text_in(to, kBar) + " at " + number_text(-kCompressionToDeg) +
                                    " degree, less than by compression (" + number_text(least) + " times or more): " +
                                    check("are the unit of the trace and gas.pressure_reference right?",
                                          "is gas.intake_valve_closing right?"));
  }

  /// Middle of the pressures near the peak, in [-360, 360).
  double middle_of_peak() const {
    constexpr double kStep = 0.05;  // [degree]
    double before = peak_deg_, after = peak_deg_;
    while (cylinder_.pressure(before) > kTopOfPeak * highest_ && before > peak_deg_ - kCycleDeg / 4) before -= kStep;
    while (cylinder_.pressure(after) > kTopOfPeak * highest_ && after < peak_deg_ + kCycleDeg / 4) after += kStep;
    return (before + after) / 2;
  }

  /// Where no combustion shifts it.
  void append_motored_peak() {
    const bool has_compression = is_whole_ || first_deg_ <= kCompressionFromDeg;
    if (!is_compressed() || !has_compression) return;
    const double middle = middle_of_peak();
    for (const double distance : {15.0, 30.0, 45.0}) {
      const double ratio = cylinder_.pressure(middle + distance) / cylinder_.pressure(middle - distance);
      if (std::log(ratio) > kMotoredGain || std::log(ratio) < -kMotoredLoss * distance) return;
    }
    if ((middle >= kEarliestMotoredDeg && middle <= kLatestMotoredDeg) || middle > kEarliestFiredDeg) return;
    note("gas-peak-place", "the cylinder pressure falls as it rises, as without combustion, about a peak at " +
                               number_text(std::round(10 * middle) / 10) + " degree; compression alone peaks 0 to " +
                               number_text(-kEarliestMotoredDeg) +
                               " degree before TDC: is TDC of the trace right? Correct its angles by the difference");
  }

  double index_of(double from_deg, double to_deg, double compression_ratio) const {
    return polytropic_index(case_.engine, cylinder_, from_deg, to_deg, compression_ratio);
  }

  /// Where compression begins: the trace, or the intake valve closes.
  double start_of_compression() const {
    constexpr double kStepDeg = 5;
    double start = is_whole_ ? kIndexFromDeg : std::max(kIndexFromDeg, first_deg_);
    const auto is_open = [&](double deg) {
      const double rise = std::log(cylinder_.pressure(deg + 2 * kStepDeg) / cylinder_.pressure(deg));
      return rise < kOpenIndex * std::log(volume_above(case_, deg, kOpenRatio) /
                                          volume_above(case_, deg + 2 * kStepDeg, kOpenRatio));
    };
    while (start < kCompressionFromDeg && is_open(start)) start += kStepDeg;
    return start;
  }

  void append_common_index(double start) {
    if (start > kLatestCommonStartDeg) return;
    const double middle = (start + kCompressionToDeg) / 2;
    const auto bend = [&](double ratio) {  // rises with the ratio
      return index_of(start, middle, ratio) - index_of(middle, kCompressionToDeg, ratio);
    };
    double low = kMinRatioTried, high = kMaxRatioTried;
    while (high > 1.01 * low) {
      const double ratio = std::sqrt(low * high);
      (bend(ratio) > 0 ? high : low) = ratio;
    }
    const std::string bound = bend(kMaxRatioTried) < 0 ? " or more" : bend(kMinRatioTried) > 0 ? " or less" : "";
    const double index = index_of(start, kCompressionToDeg, low);
    const bool is_added = index < kMinCommonIndex && lowest_ > kMinAdded;
    if (!is_added && index <= kMaxCommonIndex) return;
    note(is_added ? "gas-compression-low" : "gas-compression-high",
         "the cylinder pressure between " + number_text(-start) + " and " + number_text(-kCompressionToDeg) +
             " degree before firing TDC rises as with a compression ratio of " + number_text(std::round(low)) + bound +
             " and a polytropic index of " + number_text(std::round(100 * index) / 100) +
             ", where sealed engines have 1.25 to 1.4: is a pressure " + (is_added ? "added to" : "missing from") +
             " the trace? " + kPeg);
  }

  /// Where the compression ratio is known, an offset of 0.3 bar shows in the index at once, eq-compression-index.
  void append_stated_index() {
    if (!is_compressed() || (!is_whole_ && first_deg_ > kPegFromDeg)) return;
    const double index = compression_index(case_, cylinder_).value();
    if (index >= kMinIndex && index <= kMaxIndex) return;
    const bool is_low = index < kMinIndex;
    note(is_low ? "gas-compression-low" : "gas-compression-high",
         "the compression from " + number_text(-kPegFromDeg) + " to " + number_text(-kPegToDeg) +
             " degree before firing TDC has a polytropic index of " + number_text(std::round(100 * index) / 100) +
             " with gas.compression_ratio = " + number_text(gas_.compression_ratio) +
             ", where sealed engines have 1.25 to 1.4: is a pressure " + (is_low ? "added to" : "missing from") +
             " the trace, or TDC or the ratio wrong? " + kPeg);
  }

  /// A pressure that is added shows in the bend even where the stated ratio makes up for it in the index.
  void append_bend() {
    if (!is_compressed() || (!is_whole_ && first_deg_ > kCompressionFromDeg)) return;
    append_common_index(start_of_compression());
  }

  void append_index() {
    if (!is_compressed() || (!is_whole_ && first_deg_ > kCompressionFromDeg)) return;
    const double start = start_of_compression();
    const double largest = index_of(start, kCompressionToDeg, kMinChargedRatio);
    const double least = index_of(start, kCompressionToDeg, kMaxRatio);
    const bool is_weak = lowest_ > kMaxOpen && largest < kMinIndex;
    if (!is_weak && least <= kMaxIndex) return append_common_index(start);
    const std::string rise = "the cylinder pressure rises from " + text_in(cylinder_.pressure(start), kBar) +
                             " absolute at " + number_text(-start) + " degree before firing TDC to " +
                             text_in(cylinder_.pressure(kCompressionToDeg), kBar) + " at " +
                             number_text(-kCompressionToDeg) + " degree, with a polytropic index of ";
    const auto rounded = [](double index) { return number_text(std::round(100 * index) / 100); };
    if (is_weak) {
      note("gas-compression-low",
           rise + rounded(largest) + " or less for a compression ratio of " + number_text(kMinChargedRatio) +
               " and more, where charged engines have 1.25 to 1.4: is a pressure added to the trace? " + kPeg);
    } else {
      note(
          "gas-compression-high",
          rise + rounded(least) + " or more for a compression ratio of " + number_text(kMaxRatio) +
              " and less, above that of air without losses, 1.4: is a pressure missing from the trace, or TDC wrong? " +
              kPeg);
    }
  }

  void append_low_pressures() {
    if (lowest_ < kDeepestVacuum) {
      note("gas-pressure-low", "the cylinder pressure falls to " + text_in(lowest_, kBar) +
                                   " absolute, lower than the intake of any running engine: " +
                                   check("are the unit of the trace and gas.pressure_reference right?",
                                         "are gas.intake_pressure and gas.exhaust_pressure right?"));
      return;
    }
    const double exhaust = mean(kExhaustBeginDeg, kExhaustEndDeg);
    if (exhaust >= kThinAir) return;
    note("gas-pressure-low",
         "the cylinder pressure is " + text_in(exhaust, kBar) +
             " absolute during the exhaust stroke, lower than the atmosphere into which it flows: " +
             question_of_exhaust());
  }

  void append_high_pressures() {
    if (highest_ > kMaxPeak || lowest_ > kMaxCharge) {
      note("gas-pressure-high",
           "the cylinder pressure lies between " + text_in(lowest_, kBar) + " and " + text_in(highest_, kBar) +
               " absolute, higher than in usual engines: " +
               check("is the unit of the trace right?",
                     "are gas.peak_pressure, gas.intake_pressure and gas.exhaust_pressure right?"));
      return;
    }
    if (append_high_gas_exchange()) return;
    if (!is_gauge() || !is_whole_ || !is_compressed() || lowest_ - base::kAtmosphere < kMaxUsualBoost) return;
    note("gas-pressure-high", "the cylinder pressure never falls below " + text_in(lowest_ - base::kAtmosphere, kBar) +
                                  " above the atmosphere, " + text_in(lowest_, kBar) +
                                  " absolute: unless the engine is charged so high, the trace is absolute and "
                                  "gas.pressure_reference is wrong");
  }

  std::string question_of_exhaust() const {
    return is_wiebe() || !is_whole_ ? "is gas.exhaust_pressure right, an absolute pressure?"
                                    : "are the unit of the trace and gas.pressure_reference right?";
  }

  bool append_high_gas_exchange() {
    if (is_compressed() && !is_peak_in_place()) return false;  // at other angles
    const double exhaust = mean(kExhaustBeginDeg, kExhaustEndDeg), intake = mean(kIntakeBeginDeg, kIntakeEndDeg);
    if (std::max(exhaust, intake) <= kMaxCharge) return false;
    note("gas-pressure-high", "the cylinder pressure is " + text_in(exhaust, kBar) +
                                  " absolute during the exhaust stroke and " + text_in(intake, kBar) +
                                  " during intake: one turbocharger charges to 5 bar, and exhaust " +
                                  "brakes hold back about as much; are these pressures right?");
    return true;
  }

  void append_jump() {
    const std::optional<TraceStart> start = trace_start(case_);
    if (!start) return;
    if (start->pressure >= (1 - kIntakeScatter) * start->lowest &&
        start->pressure <= (1 + kIntakeScatter) * start->highest) {
      return;
    }
    note("gas-trace-jump",
         "the trace begins with " + text_in(start->pressure, kBar) + " at " + number_text(start->crank_angle_deg) +
             " degree, where gas.intake_pressure = " + text_in(start->lowest, kBar) + " can be compressed to " +
             text_in(start->highest, kBar) + " at most: is one of them wrong, or of another reference?");
  }

  /// Where the case states another IMEP than that of its pressure, over the whole cycle or without gas exchange.
  void append_imep() {
    if (!gas_.imep) return;
    const double stated = *gas_.imep;
    const auto [net, gross, per_degree] = indicated_pressure(case_.engine, cylinder_);
    const double scatter = std::max(kImepScatter * std::abs(stated), kMinImepScatter);
    if (std::abs(net - stated) <= scatter || std::abs(gross - stated) <= scatter) return;
    note("gas-imep-differs",
         "gas.imep states " + text_in(stated, kBar, 4) + ", and the cylinder pressure has an IMEP of " +
             text_in(net, kBar, 4) + " over the whole cycle and " + text_in(gross, kBar, 4) +
             " over compression and expansion: is it the pressure of this operating point, and the crank that of its "
             "engine? " +
             check("One degree of TDC changes it by ", "One degree of combustion changes it by ") +
             text_in(std::abs(per_degree), kBar, 2) + "; an offset of the pressure does not change it");
  }

  const Case& case_;
  const Gas& gas_;
  const models::CyclePressure& cylinder_;
  std::vector<Note>& notes_;
  double lowest_ = 0, highest_ = 0, peak_deg_ = 0;  ///< absolute [Pa]; of the peak, in [-360, 360) [degree]
  double first_deg_ = 0;                            ///< first crank angle of a trace, in [-360, 360) [degree]
  bool is_whole_ = false;                           ///< does the trace cover the cycle?
};

/// The speed of an operating point that is not that of another: more than any uncertainty of a speed.
constexpr double kOtherSpeed = 1.25;

bool has_same_pressure(const Gas& one, const Gas& other) {
  if (one.model != other.model) return false;
  if (one.model == GasModel::kWiebe) {
    return one.peak_pressure == other.peak_pressure && one.intake_pressure == other.intake_pressure;
  }
  return one.cylinder_pressure->crank_angle_deg == other.cylinder_pressure->crank_angle_deg &&
         one.cylinder_pressure->value == other.cylinder_pressure->value;
}

/// The highest pressure [Pa]; nothing where it shows no compression.
std::optional<double> peak_of_compression(const Gas& gas) {
  if (gas.model == GasModel::kWiebe) return gas.peak_pressure;
  const std::vector<double>& values = gas.cylinder_pressure->value;
  if (values.empty()) return std::nullopt;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double rise = rise_of_traces(gas) + gas.pressure_offset;
  return *high + rise >= kMinCompression * (*low + rise) ? std::optional(*high + rise) : std::nullopt;
}

}  // namespace

std::optional<TraceStart> trace_start(const Case& c) {
  const Gas& gas = c.gas;
  const SampledTrace& trace = *gas.cylinder_pressure;
  const bool is_joined = gas.model == GasModel::kTrace && !trace.value.empty() && gas.intake_pressure &&
                         !models::covers_cycle(trace.crank_angle_deg);
  if (!is_joined) return std::nullopt;
  const double angle = from_firing_deg(gas, trace.crank_angle_deg.front());
  if (angle > 0) return std::nullopt;
  const double bottom = -kCycleDeg / 4;  // compression begins there
  const double rise =
      std::pow(volume_above(c, bottom, kMaxRatio) / volume_above(c, std::max(angle, bottom), kMaxRatio), kAdiabatic);
  return TraceStart{angle, trace.value.front() + rise_of_cylinder_trace(c), *gas.intake_pressure,
                    *gas.intake_pressure * rise};
}

bool contradicts_intake(const TraceStart& start) {
  return start.pressure < kChoked * start.lowest || start.pressure > start.highest / kChoked;
}

void append_gas_notes(const Case& c, const models::CyclePressure& cylinder, std::vector<Note>& notes) {
  if (c.gas.model == GasModel::kTrace && c.gas.cylinder_pressure->value.empty()) return;
  GasNotes(c, cylinder, notes).append();
}

void append_origin_note(const Case& c, std::vector<Note>& notes) {
  if (c.gas.model != GasModel::kTrace || c.gas.trace_origin != TraceOrigin::kSynthetic) return;
  notes.push_back({kSyntheticTrace, "the cylinder pressure is SYNTHETIC: computed, not measured", 1});
}

std::optional<std::string> kept_pressure(const std::vector<const Case*>& cases) {
  if (cases.empty()) return std::nullopt;
  const Case& first = *cases.front();
  double slowest = first.operating.speed, fastest = slowest;
  for (const Case* c : cases) {
    if (!has_same_pressure(first.gas, c->gas)) return std::nullopt;
    slowest = std::min(slowest, c->operating.speed);
    fastest = std::max(fastest, c->operating.speed);
  }
  const std::optional<double> peak = peak_of_compression(first.gas);
  if (!peak || fastest <= kOtherSpeed * slowest) return std::nullopt;
  return "operating.speed goes from " + range_in(slowest, fastest, kRpm) +
         ", and the cylinder pressure stays the same, with a peak of " + text_in(*peak, kBar) +
         ": an engine has another at each speed and load, at idle a fraction of that at full load";
}

}  // namespace ringfilm::cycle
