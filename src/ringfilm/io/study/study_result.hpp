#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/storage/shard_file.hpp"
#include "ringfilm/io/study/study_file.hpp"
#include "ringfilm/study/design/plan.hpp"
#include "ringfilm/study/sampled_error.hpp"
#include "ringfilm/study/scenario_note.hpp"

namespace ringfilm::io {

/// A study with all its rows, in files. Not for several threads at once.
class StudyRows {
 public:
  /// Refers to file and plan.
  StudyRows(const StudyFile& from, const study::Plan& of, std::vector<ShardReader> with)
      : file(from), plan(of), shards(std::move(with)) {}

  const StudyFile& file;            ///< file of the study
  const study::Plan& plan;          ///< numbers of each scenario
  std::vector<ShardReader> shards;  ///< files of rows in the order of their scenarios, without a gap
  /// Discretisation error of the values, where it was estimated.
  std::optional<study::SampledError> error = std::nullopt;

  /// Names of the film::FilmKernels with which they were computed: "avx2", "avx2, avx512".
  std::string kernels() const;

  /// A value of all scenarios, or of some; `i` counts those of Plan::values(). NaN where not solved.
  std::vector<double> values(std::size_t i) const;
  std::vector<double> values(std::size_t i, const study::ScenarioRange& range) const;  ///< in the order of the plan
  /// A curve of some scenarios at some angles, index [angle][scenario]; `i` counts study::Keep::quantities. NaN where
  /// not solved.
  std::vector<float> curve(std::size_t i, std::size_t first_angle, std::size_t n_angles,
                           const study::ScenarioRange& range) const;
  std::vector<double> row(std::uint64_t scenario) const;  ///< all values of a scenario
  std::vector<ShardReader::Unsolved> unsolved() const;    ///< unsolved scenarios of the whole plan, in their order
  /// Unsolved scenarios of a range.
  std::vector<ShardReader::Unsolved> unsolved(const study::ScenarioRange& range) const;
  /// Number of unsolved scenarios.
  std::uint64_t n_unsolved() const;

  /// The notes of one topic on single results. Nothing of a scenario that was not solved.
  struct ScenarioNotes {
    /// Those of one base.
    struct OfBase {
      std::uint64_t count = 0;                   ///< scenarios that carry it
      std::optional<study::ScenarioNote> shown;  ///< the one that comes before all others; empty where the count is 0
    };
    std::string topic;                         ///< topic of the cycle::Note
    std::vector<OfBase> bases;                 ///< in the order of the plan
    std::uint64_t count() const;               ///< number of scenarios of all bases that carry the note
    const study::ScenarioNote& shown() const;  ///< note of all bases that comes before all others
  };
  /// Topic by topic, the most serious first. The first call of this or notes() reads all rows, once.
  const std::vector<ScenarioNotes>& scenario_notes() const { return all_notes().of_scenarios; }
  /// What must be known about the plan and how it ended, one sentence each.
  const std::vector<std::string>& notes() const { return all_notes().of_plan; }
  std::vector<SharedNote> notes_of(const study::ScenarioRange& range) const;  ///< a topic may come several times

 private:
  struct Notes {
    std::vector<ScenarioNotes> of_scenarios;
    std::vector<std::string> of_plan;
  };
  const Notes& all_notes() const;
  Notes read_notes() const;

  /// Calls for each shard that has some of the scenarios: the shard, which of them, and how many come before.
  template <class Read>
  void each_part(const study::ScenarioRange& range, const Read& read) const;

  mutable std::optional<Notes> notes_;
};

/// Numbers of the factors over all scenarios, factor by factor; NaN where one leaves its base as it is.
std::vector<std::vector<double>> factor_columns(const study::Plan& plan);

/// Numbers of the factors over some scenarios, factor by factor; NaN where one leaves its base as it is.
std::vector<std::vector<double>> factor_columns(const study::Plan& plan, const study::ScenarioRange& range);

/// The names of the factors in result files: "factor_face_crown", with a number where two would be called alike.
std::vector<std::string> factor_variables(const study::Study& study);
/// The name of the variable with the texts of a choice.
std::string choice_variable(const std::string& factor_variable);

/// The texts of a factor that is a choice; empty of one that is a number.
std::vector<std::string> choice_texts(const study::Factor& factor);

/// Writes the rows as a CSV table without curves, SI, block by block. Throws OutputError.
void write_study_csv(const std::string& path, const StudyRows& rows);

}  // namespace ringfilm::io
