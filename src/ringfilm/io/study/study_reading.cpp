#include "ringfilm/io/study/study_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <variant>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/study/document_reader.hpp"
#include "ringfilm/io/text/source_text.hpp"
#include "ringfilm/io/text/toml_tree.hpp"
#include "ringfilm/study/design/plan.hpp"
#include "ringfilm/study/design/scenario.hpp"

namespace ringfilm::io {
namespace {

using study::Factor;

/// Combinations of one section that are read: each takes some milliseconds and keeps the numbers of its files, 10 kB
/// for a trace with a sample per degree.
constexpr std::size_t kMaxCombinations = 10'000;

/// The sections of a case that files can define.
const std::vector<std::string> kSections = {"gas.", "ring.face.", "lubricant."};

bool is_of_section(const std::string& key, const std::string& section) { return key.rfind(section, 0) == 0; }

bool is_among(const cycle::InputFile& file, const std::vector<cycle::InputFile>& files) {
  return std::any_of(files.begin(), files.end(), [&](const cycle::InputFile& one) {
    return std::tie(one.role, one.path, one.sha256) == std::tie(file.role, file.path, file.sha256);
  });
}

/// Copies one section into a case, with the files that define it; other sections may have been read otherwise.
/// @param base the case as the base has it  @param from the case with the section read anew
void put_section(const std::string& section, const cycle::Case& base, const cycle::Case& from, cycle::Case& to) {
  if (section == "lubricant.") to.lubricant = from.lubricant;
  if (section == "gas.") to.gas = from.gas;
  if (section == "ring.face.") to.ring.face = from.ring.face;
  const auto belongs = [&](const std::string& key) { return is_of_section(key, section); };
  std::erase_if(to.stated, belongs);
  std::copy_if(from.stated.begin(), from.stated.end(), std::inserter(to.stated, to.stated.end()), belongs);
  std::erase_if(to.files, [&](const cycle::InputFile& file) {
    return is_among(file, base.files) && !is_among(file, from.files);
  });
  std::copy_if(from.files.begin(), from.files.end(), std::back_inserter(to.files),
               [&](const cycle::InputFile& file) { return !is_among(file, base.files); });
}

/// A choice of each factor of a section; nothing where the base's own holds.
using Combination = std::vector<std::optional<std::size_t>>;

/// What a base is with a combination, or why it cannot be read so.
struct Reading {
  std::optional<cycle::Case> read;
  std::vector<Fault> faults;
};

using ReadingsOfBases = std::vector<std::map<Combination, Reading>>;

/// The combinations of the texts of some factors in one section that the plan uses.
class SectionReader {
 public:
  SectionReader(const study::Plan& plan, std::string section, std::vector<std::size_t> factors,
                const std::string& folder, const Units& units)
      : plan_(plan), section_(std::move(section)), factors_(std::move(factors)), folder_(folder), units_(units) {}

  study::FileReading read(std::vector<cycle::InputFile>& files, std::vector<Fault>& faults) {
    const std::vector<std::set<Combination>> used = used_combinations();
    std::size_t n_used = 0;
    for (const std::set<Combination>& of_base : used) n_used += of_base.size();
    if (n_used > kMaxCombinations) {
      faults.push_back(
          {study_.factors[factors_.front()].mark,
           fmt::format("the plan uses more than {1} combinations of the texts of [{0}], each of which is read",
                       section_.substr(0, section_.size() - 1), kMaxCombinations),
           fmt::format("at most {} are possible; list fewer values, or write several studies", kMaxCombinations)});
      return {};
    }
    for (std::size_t b = 0; b < study_.bases.size(); ++b) {
      readings_.emplace_back();
      for (const Combination& one : used[b]) readings_[b].emplace(one, read_combination(b, one));
      for (const auto& [combination, reading] : readings_[b]) {
        if (reading.read) files.insert(files.end(), reading.read->files.begin(), reading.read->files.end());
      }
      for (std::size_t k = 0; k < factors_.size(); ++k) refuse_unreadable(b, k, faults);
    }
    return {factors_,
            [section = section_, bases = study_.bases, readings = std::make_shared<ReadingsOfBases>(readings_)](
                cycle::Case& c, std::size_t base, const Combination& choices) {
              const Reading& reading = readings->at(base).at(choices);
              if (!reading.read) throw InputError(reading.faults);
              put_section(section, bases.at(base).input, *reading.read, c);
            }};
  }

 private:
  const std::vector<study::Choice>& choices(std::size_t k) const {
    return std::get<study::Choices>(study_.factors[factors_[k]].variation).values;
  }

  bool applies(std::size_t k, std::size_t base) const { return study::applies(study_.factors[factors_[k]], base); }

  /// The combinations that the plan uses of the texts for each base, or one more than are allowed.
  std::vector<std::set<Combination>> used_combinations() const {
    std::vector<std::set<Combination>> used(study_.bases.size());
    std::size_t n_others = 0;
    for (std::size_t base = 0; base < used.size(); ++base) {
      add_combinations(base, kMaxCombinations + 2 - n_others, used[base]);  // the base's own and one too many
      used[base].erase(Combination(factors_.size()));                       // the base's own texts are read already
      n_others += used[base].size();
      if (n_others > kMaxCombinations) break;
    }
    return used;
  }

  /// Adds the combinations that the plan uses for a base, at most so many.
  void add_combinations(std::size_t base, std::size_t most, std::set<Combination>& used) const {
    // A grid has all combinations of its values. Its last factor varies fastest, so that its points show them slowly.
    if (study_.sampling.method == study::Method::kGrid) return add_all(base, {}, most, used);
    const double n_all = n_possible(base);
    const std::uint64_t n_points =
        plan_.most() == plan_.size() ? plan_.n_points(base) : plan_.most() / study_.bases.size();
    for (std::uint64_t p = 0; p < n_points && used.size() < most && static_cast<double>(used.size()) < n_all; ++p)
      used.insert(combination_of(plan_.point(plan_.scenario(base, p))));
  }

  /// How many combinations the points of a base can have at most.
  double n_possible(std::size_t base) const {
    const study::Sampling& sampling = study_.sampling;
    double n = 1;
    for (std::size_t k = 0; k < factors_.size(); ++k) {
      if (!applies(k, base)) continue;
      std::size_t n_texts = choices(k).size();
      if (sampling.method == study::Method::kMorris) n_texts = std::min(n_texts, sampling.levels);
      if (sampling.method == study::Method::kOneAtATime) ++n_texts;  // the base's own
      n *= static_cast<double>(n_texts);
    }
    return n;
  }

  Combination combination_of(const study::Point& point) const {
    Combination one(factors_.size());
    for (std::size_t k = 0; k < factors_.size(); ++k) {
      if (const auto& value = point.values.at(factors_[k])) one[k] = static_cast<std::size_t>(*value);
    }
    return one;
  }

  void add_all(std::size_t base, Combination so_far, std::size_t most, std::set<Combination>& used) const {
    if (used.size() >= most) return;
    const std::size_t k = so_far.size();
    if (k == factors_.size()) {
      used.insert(so_far);
      return;
    }
    so_far.emplace_back();
    if (!applies(k, base)) return add_all(base, so_far, most, used);
    for (std::size_t i = 0; i < choices(k).size(); ++i) {
      so_far.back() = i;
      add_all(base, so_far, most, used);
    }
  }

  Reading read_combination(std::size_t base, const Combination& combination) const {
    std::vector<Override> overrides;
    SourceMark mark;
    for (std::size_t k = 0; k < combination.size(); ++k) {
      if (!combination[k]) continue;
      const study::Choice& choice = choices(k)[*combination[k]];
      mark = choice.mark;
      for (const study::Target& target : study_.factors[factors_[k]].targets) {
        if (target.base && *target.base != base) continue;
        const bool is_file = study::is_file(*cycle::find_field(target.key));
        overrides.push_back({target.key, quoted(is_file ? locate(choice.text, folder_).shown : choice.text)});
      }
    }
    try {
      return {read_case(study_.bases[base].input.files.front().path, overrides, units_), {}};
    } catch (const InputError& error) {
      Reading unreadable;
      append_case_faults(error, mark, unreadable.faults);
      return unreadable;
    }
  }

  bool is_readable_alone(std::size_t base, std::size_t k, std::size_t i) const {
    Combination alone(factors_.size());
    alone[k] = i;
    return read_combination(base, alone).read.has_value();
  }

  /// Refuses the choices of a factor that can be read in no combination and not alone, for the reasons of the first of
  /// these.
  void refuse_unreadable(std::size_t base, std::size_t k, std::vector<Fault>& faults) const {
    for (std::size_t i = 0; i < choices(k).size(); ++i) {
      const std::vector<Fault>* reasons = nullptr;
      bool is_readable = false;
      for (const auto& [combination, reading] : readings_[base]) {
        if (combination[k] != i) continue;
        is_readable = is_readable || reading.read;
        if (reasons == nullptr) reasons = &reading.faults;
      }
      if (is_readable || reasons == nullptr || is_readable_alone(base, k, i)) continue;
      for (const Fault& reason : *reasons) {
        const bool is_known = std::any_of(faults.begin(), faults.end(), [&](const Fault& one) {
          return std::tie(one.mark.file, one.mark.line, one.message) ==
                 std::tie(reason.mark.file, reason.mark.line, reason.message);
        });
        if (!is_known) faults.push_back(reason);
      }
    }
  }

  const study::Plan& plan_;
  const study::Study& study_ = plan_.study();
  std::string section_;
  std::vector<std::size_t> factors_;
  const std::string& folder_;
  const Units& units_;
  ReadingsOfBases readings_;
};

/// The sections of the keys of a factor that decide what is read.
std::set<std::string> sections_of(const Factor& factor) {
  std::set<std::string> sections;
  if (!std::holds_alternative<study::Choices>(factor.variation)) return sections;
  for (const study::Target& target : factor.targets) {
    const cycle::Field* field = cycle::find_field(target.key);
    if (field == nullptr || !study::decides_reading(*field)) continue;
    for (const std::string& section : kSections) {
      if (is_of_section(target.key, section)) sections.insert(section);
    }
  }
  return sections;
}

}  // namespace

StudyReadings study_readings(const study::Study& study, const std::string& folder, const Units& units,
                             std::vector<Fault>& faults) {
  StudyReadings all;
  std::vector<std::string> sections;
  for (const std::string& section : kSections) {
    std::vector<std::size_t> factors;
    for (std::size_t j = 0; j < study.factors.size(); ++j) {
      if (sections_of(study.factors[j]).contains(section)) factors.push_back(j);
    }
    if (factors.empty()) continue;
    sections.push_back(section);
    all.readings.push_back({std::move(factors), nullptr});
  }
  if (all.readings.empty()) return all;
  study::Study planned = study;
  planned.readings = all.readings;
  // Which texts meet is only known of a plan without faults. study::Plan refuses all others.
  if (!study::faults_of(planned).empty()) return all;
  const study::Plan plan(std::move(planned));
  for (std::size_t i = 0; i < sections.size(); ++i) {
    SectionReader reader(plan, sections[i], all.readings[i].factors, folder, units);
    all.readings[i] = reader.read(all.files, faults);
  }
  return all;
}

}  // namespace ringfilm::io
