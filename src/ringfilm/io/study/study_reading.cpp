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

#include "ringfilm/cycle/case/case_fields.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/text/source_text.hpp"
#include "ringfilm/io/text/toml_tree.hpp"
#include "ringfilm/study/design/scenario.hpp"

namespace ringfilm::io {
namespace {

using study::Factor;

/// Combinations of one section that are read: each takes some milliseconds and keeps the numbers of its files, 10 kB
/// of a trace with a sample per degree.
constexpr double kMostCombinations = 10'000;

/// The sections of a case that files can define.
const std::vector<std::string> kSections = {"gas.", "ring.face.", "lubricant."};

bool is_of_section(const std::string& key, const std::string& section) { return key.rfind(section, 0) == 0; }

bool is_among(const cycle::InputFile& file, const std::vector<cycle::InputFile>& files) {
  return std::any_of(files.begin(), files.end(), [&](const cycle::InputFile& one) {
    return std::tie(one.role, one.path, one.sha256) == std::tie(file.role, file.path, file.sha256);
  });
}

/// Copies one section into a case, with the files that define it; other sections may have been read otherwise.
/// @param base the case as the base has it  @param from the same with the section read anew
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
  SectionReader(const study::Study& study, std::string section, std::vector<std::size_t> factors,
                const std::string& folder, const Units& units)
      : study_(study), section_(std::move(section)), factors_(std::move(factors)), folder_(folder), units_(units) {}

  study::FileReading read(std::vector<cycle::InputFile>& files, std::vector<Fault>& faults) {
    if (n_combinations() > kMostCombinations) {
      faults.push_back(
          {study_.factors[factors_.front()].mark,
           fmt::format("the plan uses {1:.6g} combinations of the texts of [{0}], each of which is read",
                       section_.substr(0, section_.size() - 1), n_combinations()),
           fmt::format("at most {} are possible; list fewer values, or write several studies", kMostCombinations)});
      return {};
    }
    for (std::size_t b = 0; b < study_.bases.size(); ++b) {
      readings_.emplace_back();
      for (const Combination& one : combinations(b)) readings_[b].emplace(one, read_combination(b, one));
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

  /// How many combinations of all bases the plan uses at most, without making a list of them.
  double n_combinations() const {
    double n = 0;
    for (std::size_t base = 0; base < study_.bases.size(); ++base) {
      double all = 1, single = 0;
      for (std::size_t k = 0; k < factors_.size(); ++k) {
        if (!applies(k, base)) continue;
        all *= static_cast<double>(choices(k).size());
        single += static_cast<double>(choices(k).size());
      }
      const bool is_list = study_.sampling.method == study::Method::kList;
      const double most = is_list ? static_cast<double>(study_.sampling.list.size()) : all;
      n += study_.sampling.method == study::Method::kOneAtATime ? single : std::min(all, most);
    }
    return n;
  }

  bool applies(std::size_t k, std::size_t base) const { return study::applies(study_.factors[factors_[k]], base); }

  /// The combinations that the plan uses for a base.
  std::set<Combination> combinations(std::size_t base) const {
    std::set<Combination> used;
    if (study_.sampling.method == study::Method::kOneAtATime) {
      add_single(base, used);
    } else if (study_.sampling.method == study::Method::kList) {
      add_listed(base, used);
    } else {
      add_all(base, {}, used);
    }
    used.erase(Combination(factors_.size()));  // the base's own texts are read already
    return used;
  }

  void add_single(std::size_t base, std::set<Combination>& used) const {
    for (std::size_t k = 0; k < factors_.size(); ++k) {
      Combination one(factors_.size());
      for (std::size_t i = 0; applies(k, base) && i < choices(k).size(); ++i) {
        one[k] = i;
        used.insert(one);
      }
    }
  }

  void add_listed(std::size_t base, std::set<Combination>& used) const {
    for (const std::vector<double>& row : study_.sampling.list) {
      Combination one(factors_.size());
      bool is_valid = true;  // the plan refuses a row with a number that is not the place of a text
      for (std::size_t k = 0; k < factors_.size(); ++k) {
        if (!applies(k, base)) continue;
        const double place = row.at(factors_[k]);
        is_valid = is_valid && place >= 0 && place < static_cast<double>(choices(k).size());
        if (is_valid) one[k] = static_cast<std::size_t>(place);
      }
      if (is_valid) used.insert(one);
    }
  }

  void add_all(std::size_t base, Combination so_far, std::set<Combination>& used) const {
    const std::size_t k = so_far.size();
    if (k == factors_.size()) {
      used.insert(so_far);
      return;
    }
    so_far.emplace_back();
    if (!applies(k, base)) return add_all(base, so_far, used);
    for (std::size_t i = 0; i < choices(k).size(); ++i) {
      so_far.back() = i;
      add_all(base, so_far, used);
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
      for (const Fault& f : error.faults()) {
        const bool in_file = f.mark.line > 0 && f.mark.file != "--set";
        unreadable.faults.push_back(in_file ? f : Fault{mark, f.message, f.remedy});
      }
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

  const study::Study& study_;
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
  for (const std::string& section : kSections) {
    std::vector<std::size_t> factors;
    for (std::size_t j = 0; j < study.factors.size(); ++j) {
      if (sections_of(study.factors[j]).contains(section)) factors.push_back(j);
    }
    if (factors.empty()) continue;
    study::FileReading reading = SectionReader(study, section, factors, folder, units).read(all.files, faults);
    all.readings.push_back(std::move(reading));
  }
  return all;
}

}  // namespace ringfilm::io
