#pragma once
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "ringfilm/case/case.hpp"

/// The one table of case keys. Reading, refusing, echoing, `ringfilm fields`, `ringfilm new`, the case reference of the
/// manual and the studies all use it; no key is defined elsewhere.
namespace ringfilm::cycle {

/// Where a case holds a value: to be read in one that does not change, to be written in one that may.
template <class T>
class Ref {
 public:
  /// @param find takes a Case or a const Case and returns a reference to the member
  template <class Find>
  requires(!std::is_same_v<Find, Ref>) Ref(Find find)
      : read_([find](const Case& c) -> const T& { return find(c); }),
        write_([find](Case& c) -> T& { return find(c); }) {}

  const T& operator()(const Case& c) const { return read_(c); }
  T& operator()(Case& c) const { return write_(c); }

 private:
  std::function<const T&(const Case&)> read_;
  std::function<T&(Case&)> write_;
};
using NumberRef = Ref<double>;
using OptionalNumberRef = Ref<std::optional<double>>;
using TextRef = Ref<std::string>;
using OptionalTextRef = Ref<std::optional<std::string>>;

/// A dimensional (or dimensionless, unit "1") number.
struct NumberKind {
  NumberRef ref;
};
/// A number with its unit, absent by default.
struct OptionalNumberKind {
  OptionalNumberRef ref;
};
struct CountKind {
  Ref<int> ref;
};
/// One of a few names; `index` and `choose` translate between the member and the number of its name.
struct ChoiceKind {
  std::vector<std::string> names;
  std::function<int(const Case&)> index;
  std::function<void(Case&, int)> choose;
};
struct TextKind {
  TextRef ref;
};
struct OptionalTextKind {
  OptionalTextRef ref;
};
/// A file name, relative to the file that names it; `role` determines what the reader loads.
struct FileKind {
  TextRef ref;
};
struct OptionalFileKind {
  OptionalTextRef ref;
};
/// A quantity or the name of a trace file (`gas.crankcase_pressure`).
struct NumberOrFileKind {
  NumberRef number;
  OptionalTextRef file;
};
/// A number or a file, absent by default (`ring.pressure_below`).
struct OptionalNumberOrFileKind {
  Ref<LandPressure> ref;
};
/// A unit written as text, kept as its size in SI (`ring.face.length_unit = "mm"` is 1e-3).
struct UnitNameKind {
  NumberRef ref;
};
/// Bare numbers.
struct NumberListKind {
  Ref<std::vector<double>> ref;
};
/// An array of { temperature = "40 degC", value = "59.99 mm2/s" }.
struct TemperatureValuesKind {
  Ref<std::vector<TemperatureValue>> ref;
};
/// One quantity, or an array of values at temperatures (`lubricant.density`).
struct ConstantOrTemperatureValuesKind {
  OptionalNumberRef constant;
  Ref<std::vector<TemperatureValue>> ref;
};
/// One quantity, or an array of [distance, quantity] (`thermal.liner`).
struct StrokeValuesKind {
  Ref<std::vector<StrokeValue>> ref;
};
/// An array of { order = 2, amplitude = "15 um", phase = "0 degree" }; along the stroke each with a height, too.
struct FourierTermsKind {
  Ref<std::vector<FourierTerm>> ref;
  int lowest_order;
  enum class Place { kOneSection, kAlongStroke } place;
};
/// An array of { share = 0.3, boiling_point = "380 degC", molar_mass = "350 g/mol" }, `lubricant.distillation`.
struct DistillationKind {
  Ref<std::vector<models::OilFraction>> ref;
};
/// An array of corners ["0 mm", "0 mm"], axial and radial (`ring.section`).
struct CornersKind {
  Ref<models::SectionPolygon> ref;
};
/// `output.crank_angles`: a step or a list of angles.
struct AnglesKind {};
/// `output.fields`: "none", "all" or a list of angles.
struct FieldAnglesKind {};

using Kind = std::variant<NumberKind, OptionalNumberKind, CountKind, ChoiceKind, TextKind, OptionalTextKind, FileKind,
                          OptionalFileKind, NumberOrFileKind, OptionalNumberOrFileKind, UnitNameKind, NumberListKind,
                          TemperatureValuesKind, ConstantOrTemperatureValuesKind, StrokeValuesKind, FourierTermsKind,
                          DistillationKind, CornersKind, AnglesKind, FieldAnglesKind>;

/// Must the user state it, is there a default in case.hpp, or may it be absent altogether?
enum class Need {
  kRequired,
  kRequiredInCycle,  ///< a pad has a default
  kDefault,
  kOptional
};

/// Bounds in SI; an open bound is excluded.
struct Range {
  double low;
  double high;
  bool low_open = false;
  bool high_open = false;

  bool contains(double value) const {
    return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
  }
};

/// What computes with a key.
struct Uses {
  bool cycle = true;     ///< a ring over an engine cycle
  bool pad = false;      ///< a film of stated shape
  bool closure = false;  ///< a ring in its bore, without film
  bool gas = false;      ///< the gas of a pack alone
};

struct Field {
  std::string key;  ///< "engine.bore"
  Kind kind;
  std::string unit;          ///< SI unit in UDUNITS spelling; "1" dimensionless; "" for text, choices and files
  std::string display_unit;  ///< the unit in which people write and read it, e.g. "mm"
  std::optional<Range> range;
  Need need = Need::kDefault;
  std::function<bool(const Case&)> active;  ///< empty: always in use
  std::string active_when;                  ///< in words, e.g. "gas.model = \"trace\""
  std::string help;                         ///< one line: what it is, symbol, source if assumed
  std::string example;                      ///< the right-hand side as one would write it in TOML
  Uses uses = {};                           ///< what computes with it
  /// Does it only label or record, so that no model computes with it: the title, where a trace comes from, how an input
  /// was measured, what is stored of the result?
  bool is_for_record = false;
};

/// All keys, in the order of a case file.
const std::vector<Field>& case_fields();

/// A key of one ring of a pack, `ring.2.face_width` or `ring.2.contact.roughness`.
struct RingKey {
  std::size_t ring;  ///< from 1, the one next to the chamber
  std::string key;   ///< key in a case of one ring, "ring.face_width" or "contact.roughness"
};
/// Nothing for a key of another form.
std::optional<RingKey> ring_key(const std::string& key);
/// The key of a pack for a key of the case of its ring; of the others as it is.
std::string pack_key(std::size_t ring, const std::string& key);
/// Does the pack state that key of a ring by another one? The pressure above a ring is that below the one above it.
bool is_implied_in_pack(std::size_t ring, const std::string& key);
/// Does the key belong to a ring of its own, and not to the engine?
bool is_of_ring(const std::string& key);

/// Is it a key outside [ring] that a ring of a pack may replace for itself?
bool may_be_of_ring(const std::string& key);

/// The field of that key, nullptr if there is none.
const Field* find_field(const std::string& key);

/// Does the key belong to the problem that `c` is?
bool belongs(const Field& field, const Case& c);

/// Is the key in use with the choices that `c` makes?
bool is_active(const Field& field, const Case& c);

/// Must `c` state the key, if it is in use?
bool is_required(const Field& field, const Case& c);

}  // namespace ringfilm::cycle
