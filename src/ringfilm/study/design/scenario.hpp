#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/study/design/plan.hpp"

/// From the numbers of a scenario to its case.
namespace ringfilm::study {

/// How a number can enter a key: not at all, by any way, or by scaling alone (lists of numbers).
enum class Entry { kNone, kAnyNumber, kWholeNumber, kScaleOnly, kText };
Entry entry_of(const cycle::Field& field);

/// Does the key name a file?
bool is_file(const cycle::Field& field);

/// Does its text decide what is read from a file: the file itself, a column of it, a unit? What was read must then come
/// with the choice, in Study::readings.
bool decides_reading(const cycle::Field& field);

/// The base of a point with the numbers of its factors put in, choices first, then numbers set, scaled and added to,
/// and with_accuracy_of_study.
/// Throws InputError with all that is wrong: a number out of the range of its key, a base without a number to scale or
/// to add to, and the rules that join keys (cycle::broken_rules, of the gas alone broken_gas_rules, of a pack
/// broken_pack_rules).
cycle::Case scenario_case(const Study& study, const Point& point);

/// The case with the accuracy that the study asks of it: its own, or that of the study where it states neither an
/// accuracy nor cells and steps and the error of such films is known (docs/theory/film.md, "accuracy").
cycle::Case with_accuracy_of_study(cycle::Case c, const Study& study);

/// Up to 16 scenarios of a base, spread over the plan, the first and the last of the base among them.
std::vector<std::uint64_t> spread_scenarios(const Plan& plan, std::size_t base);

/// Throws InputError if a base has no scenario that can be made into a case, of 16 spread over the plan: a key that is
/// stated twice over, a number to scale that is not there; or if a listed text of a factor has none, of 2 to 256. To be
/// asked before anything is run; a plan of which some scenarios can be run is run, and the others are rows with their
/// reasons.
void check_scenarios(const Plan& plan);

/// A key of a base: of a pack one ring's, "ring.1.end_gap", or one that its rings have in common; nullptr: there is
/// none.
const cycle::Field* field_of_key(const std::string& key);

/// Where a factor's key is in a case: once, or in all rings of a pack; the pressure below a ring is that above the
/// next.
struct KeyPlace {
  cycle::Case* of;
  const cycle::Field* field;
};
std::vector<KeyPlace> places_of_key(cycle::Case& c, const std::string& key);

/// Why a base does not have the key of a factor, and what to write; nothing: it has it.
std::optional<Fault> missing_key(const cycle::Case& base, const std::string& key);

/// "1.5e-06 m"
std::string with_unit(double value, const cycle::Field& field);
/// "above 0 m to 2 m"
std::string range_words(const cycle::Field& field);

/// All values of a case that come from its keys, and the digests of the files that it was read from, as text. Of a key
/// that names a file the contents count, not the name.
std::string digest_text(const cycle::Case& c);

}  // namespace ringfilm::study
