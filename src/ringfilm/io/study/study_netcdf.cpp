#include "ringfilm/io/study/study_netcdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "ringfilm/io/result/provenance_attributes.hpp"
#include "ringfilm/io/result/result_file_quantities.hpp"
#include "ringfilm/io/result/result_file_writer.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/study/study_curves.hpp"
#include "ringfilm/study/statistics/weighted_mean.hpp"
#include "ringfilm/study/study_words.hpp"

namespace ringfilm::io {
namespace {

using Stored = ResultFileWriter::Stored;

constexpr long kStudySchema = 5;
constexpr const char* kScenario = "scenario";
constexpr const char* kUnsolved = "unsolved";
constexpr const char* kTopic = "note_topic";
constexpr const char* kCrankAngle = "crank_angle";
constexpr const char* kRing = "ring";
constexpr std::size_t kRings = 1;

/// Scenarios that are written at once, and that make a compressed piece; fewer where curves are kept in full.
constexpr std::uint64_t kRowsAtATime = 4096, kCurvesAtATime = 256;

/// Numbers along a dimension that is stored in whole pieces.
std::uint64_t padded(std::uint64_t n, std::uint64_t piece) { return n < piece ? n : (n + piece - 1) / piece * piece; }

/// Curves of a pack have their rings in their names.
bool has_ring_axis(const StudyRows& rows) { return !rows.plan.study().bases.front().input.is_pack(); }

/// More than the file can become: its numbers not compressed, texts, and what the library needs to find them.
std::uint64_t most_bytes(const StudyRows& rows, const std::vector<StudyRows::ScenarioNotes>& notes) {
  const study::OutputSelection& keep = rows.plan.study().keep;
  const bool is_full = keep.curves == study::Curves::kAll;
  const std::uint64_t n_curves = study::kept_curves(rows.plan.study()).size(), n_angles = kept_angles(keep).size();
  const std::uint64_t n = padded(rows.plan.size(), kRowsAtATime),
                      n_of_curves = padded(rows.plan.size(), kCurvesAtATime);
  const std::uint64_t n_columns =
      rows.plan.values().quantities.size() + rows.plan.study().factors.size() + 3 + notes.size();
  const std::uint64_t columns = n * n_columns * sizeof(double);
  const std::uint64_t curves = is_full ? n_of_curves * n_curves * n_angles * sizeof(float) : 0;
  const std::uint64_t bands =
      n_curves * n_angles * rows.plan.study().bases.size() * band_shares().size() * sizeof(float);
  std::uint64_t reasons = 0;
  for (const ShardReader& shard : rows.shards) reasons += 2 * shard.reason_bytes() + 100 * shard.n_unsolved();
  std::uint64_t messages = 0;
  for (const auto& note : notes) messages += 2 * note.shown().message.size() + 1000;
  // The file keeps the place of each compressed piece, in blocks of some kB that are half empty at worst.
  constexpr std::uint64_t kPlace = 256, kVariable = 16'384, kHead = 1 << 20;
  const std::uint64_t places =
      (n / kRowsAtATime * n_columns + (is_full ? n_of_curves / kCurvesAtATime * n_curves : 0)) * kPlace;
  return columns + curves + bands + reasons + messages + places + (n_columns + n_curves) * kVariable + kHead +
         2 * rows.plan.digest_text().size() + 1000 * rows.file.files.size();
}

void write_head(ResultFileWriter& file, const StudyRows& rows) {
  const study::Study& study = rows.plan.study();
  const Provenance program = this_program();
  file.attribute("title", study.title);
  file.attribute("ringfilm_study_schema", kStudySchema);
  file.attribute("kind", study::word_of(study.kind));
  file.attribute("seed", static_cast<long>(study.seed));
  exchange_provenance(file, program);
  file.attribute("kernels", rows.kernels());
  std::vector<std::string> roles, paths, digests;
  for (const cycle::InputFile& input : rows.file.files) {
    roles.push_back(input.role);
    paths.push_back(input.path);
    digests.push_back(input.sha256);
  }
  file.texts("input_file", text("input_file_role", "for what a file was read"), roles);
  file.texts("input_file", text("input_file_path", "file as named"), paths);
  file.texts("input_file", text("input_file_sha256", "SHA-256 of its bytes"), digests);
  file.scalar(text("plan", "all on which the numbers of the scenarios depend"), rows.plan.digest_text());
  const std::vector<std::string>& notes = rows.notes();
  if (!notes.empty()) file.texts("note", text("plan_note", "what must be known about the plan"), notes);
}

/// The estimate of the numerical error, of the values themselves in their attributes.
void write_error(ResultFileWriter& file, const StudyRows& rows) {
  if (!rows.error) return;
  const study::SampledError& error = *rows.error;
  std::vector<double> scenarios;
  for (const std::uint64_t i : error.scenarios) scenarios.push_back(static_cast<double>(i));
  if (!scenarios.empty()) {
    file.numbers({"accuracy_sample"}, count("accuracy_scenario", "scenario that was integrated again on a finer grid"),
                 scenarios);
  }
  if (!error.asked.empty()) {
    file.numbers({"accuracy_asked"}, {"accuracy_asked", "%", "%", "accuracy asked for", "", ""}, error.asked);
  }
  if (const auto coverage = error.coverage()) {
    file.scalar(described("accuracy_coverage", "1", "share of the sampled values within the accuracy asked for", "",
                          "eq-sampled-error"),
                *coverage);
    file.scalar(count("accuracy_values", "sampled values of which that is the share"),
                static_cast<double>(error.n_values));
  }
  const auto& quantities = rows.plan.values().quantities;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    if (error.quantiles[i]) file.describe(quantities[i].name, "relative_error_95_percent", *error.quantiles[i]);
  }
}

/// Writes all that goes over scenarios, a block at a time.
class BlockWriter {
 public:
  BlockWriter(ResultFileWriter& file, const StudyRows& rows, const std::vector<StudyRows::ScenarioNotes>& notes)
      : file_(file),
        rows_(rows),
        notes_(notes),
        n_(rows.plan.size()),
        n_angles_(kept_angles(rows.plan.study().keep).size()) {}

  void define() {
    const study::Study& study = rows_.plan.study();
    std::vector<std::string> names;
    for (const study::Base& base : study.bases) names.push_back(base.name);
    file_.texts("base_case", text("base_name", "name of the base case"), names);
    file_.dimension(kScenario, n_);
    base_ = column(described("base", "", "base case of the scenario, counted from 0 in base_name"), Stored::kInteger);
    define_factors();
    solved_ = column(count("solved", "1 where the scenario was solved"), Stored::kByte);
    sample_ = column(count("sample", study::kSampleWords), Stored::kByte);
    for (const auto& quantity : rows_.plan.values().quantities) {
      values_.push_back(column(quantity, Stored::kDouble));
      file_.describe(quantity.name, "coordinates", coordinates_);
    }
    const std::uint64_t n_unsolved = rows_.n_unsolved();
    if (n_unsolved > 0) {
      file_.dimension(kUnsolved, n_unsolved);
      const std::vector<std::size_t> piece = {std::min(n_unsolved, kRowsAtATime)};
      unsolved_ = file_.blocks({kUnsolved}, count("unsolved_scenario", "scenario that was not solved, from 0"),
                               Stored::kInteger, piece);
      reasons_ = file_.blocks({kUnsolved}, text("unsolved_reason", "why it was not solved"), Stored::kText, piece);
    }
    define_notes();
    if (study.keep.curves == study::Curves::kAll) define_curves();
  }

  void write() {
    for (std::uint64_t first = 0; first < n_; first += kRowsAtATime)
      write_block({first, std::min(first + kRowsAtATime, n_)});
    put_unsolved(waiting_.size());
    put_note_counts();
    if (curves_.empty()) return;
    for (std::uint64_t first = 0; first < n_; first += kCurvesAtATime)
      write_curves({first, std::min(first + kCurvesAtATime, n_)});
  }

 private:
  std::optional<int> column(const cycle::Quantity& quantity, Stored stored) {
    return file_.blocks({kScenario}, quantity, stored, {static_cast<std::size_t>(std::min(n_, kRowsAtATime))});
  }

  void define_factors() {
    const study::Study& study = rows_.plan.study();
    const std::vector<std::string> variables = factor_variables(study);
    coordinates_ = "base";
    for (std::size_t j = 0; j < variables.size(); ++j) {
      const study::Factor& factor = study.factors[j];
      const std::string& variable = variables[j];
      factors_.push_back(column({variable, factor.unit, factor.display_unit, factor.name, "", ""}, Stored::kDouble));
      file_.describe(variable, "key", factor.targets.front().key);
      if (!factor.source.empty()) file_.describe(variable, "source", factor.source);
      const std::vector<std::string> texts = choice_texts(factor);
      const std::string choices = choice_variable(variable);
      if (!texts.empty())
        file_.texts(choices.c_str(), text(choices, fmt::format("choices of {}, counted from 0", factor.name)), texts);
      coordinates_.append(" ").append(variable);
    }
  }

  void define_notes() {
    if (notes_.empty()) return;
    std::vector<std::string> topics, messages;
    for (const auto& note : notes_) {
      topics.push_back(note.topic);
      messages.push_back(note.shown().message);
    }
    file_.texts(kTopic, text(kTopic, "topic of notes on single results"), topics);
    file_.texts(kTopic,
                text("note_message", "the note, with the figures of the scenario where it is worst, else of the first"),
                messages);
    note_scenario_ =
        file_.blocks({kTopic}, count("note_scenario", "scenario with the note where it is worst, else the first one"),
                     Stored::kInteger, {notes_.size()});
    note_count_ = file_.blocks({"base_case", kTopic}, count("note_count", "scenarios of the base that carry the note"),
                               Stored::kInteger, {rows_.plan.study().bases.size(), notes_.size()});
    has_note_ = file_.blocks({kScenario, kTopic}, count("has_note", "1 where the result carries the note"),
                             Stored::kByte, {static_cast<std::size_t>(std::min(n_, kRowsAtATime)), notes_.size()});
    file_.describe("has_note", "coordinates", coordinates_);
  }

  void put_note_counts() {
    if (notes_.empty()) return;
    const std::size_t n_bases = rows_.plan.study().bases.size();
    std::vector<double> shown, counts;  // [topic], [base][topic]
    for (const auto& note : notes_) shown.push_back(static_cast<double>(note.shown().scenario));
    for (std::size_t b = 0; b < n_bases; ++b) {
      for (const auto& note : notes_) counts.push_back(static_cast<double>(note.bases[b].count));
    }
    file_.put_block(*note_scenario_, {0}, {notes_.size()}, shown.data());
    file_.put_block(*note_count_, {0, 0}, {n_bases, notes_.size()}, counts.data());
  }

  void put_notes(const study::ScenarioRange& block) {
    if (!has_note_) return;
    std::vector<double> carries(block.size() * notes_.size());
    for (const SharedNote& note : rows_.notes_of(block)) {
      const auto at =
          std::find_if(notes_.begin(), notes_.end(), [&](const auto& one) { return one.topic == note.topic; });
      const auto topic = static_cast<std::size_t>(at - notes_.begin());
      for (const std::uint64_t i : note.scenarios) carries.at((i - block.first) * notes_.size() + topic) = 1;
    }
    file_.put_block(*has_note_, {block.first, 0}, {block.size(), notes_.size()}, carries.data());
  }

  void define_curves() {
    const std::vector<std::size_t> piece =
        curve_shape(static_cast<std::size_t>(std::min(n_, kCurvesAtATime)), n_angles_);
    std::vector<const char*> dimensions = {kScenario, kCrankAngle};
    if (has_ring_axis(rows_)) dimensions.push_back(kRing);
    for (const study::KeptCurve& kept : study::kept_curves(rows_.plan.study())) {
      cycle::Quantity curve = kept.quantity;
      curve.name = fmt::format("curve_{}", curve.name);
      curves_.push_back(file_.blocks(dimensions, curve, Stored::kSingle, piece));
      file_.describe(curve.name, "coordinates", coordinates_);
    }
  }

  /// Along the dimensions of a curve: scenarios, angles and the ring where there is an axis of it.
  std::vector<std::size_t> curve_shape(std::size_t scenarios, std::size_t angles, std::size_t rings = kRings) const {
    std::vector<std::size_t> shape = {scenarios, angles};
    if (has_ring_axis(rows_)) shape.push_back(rings);
    return shape;
  }

  void put(const std::optional<int>& variable, const study::ScenarioRange& block, const std::vector<double>& values) {
    if (variable) file_.put_block(*variable, {block.first}, {block.size()}, values.data());
  }

  void write_block(const study::ScenarioRange& block) {
    std::vector<double> numbers(block.size());
    for (std::uint64_t k = 0; k < block.size(); ++k)
      numbers[k] = static_cast<double>(rows_.plan.base_of(block.first + k));
    put(base_, block, numbers);
    const auto factors = factor_columns(rows_.plan, block);
    for (std::size_t j = 0; j < factors.size(); ++j) put(factors_[j], block, factors[j]);
    std::vector<ShardReader::Unsolved> unsolved = rows_.unsolved(block);
    std::fill(numbers.begin(), numbers.end(), 1.0);
    for (const auto& one : unsolved) numbers.at(one.scenario - block.first) = 0;
    put(solved_, block, numbers);
    for (std::uint64_t k = 0; k < block.size(); ++k)
      numbers[k] = rows_.plan.is_sample(rows_.plan.point_of(block.first + k)) ? 1.0 : 0.0;
    put(sample_, block, numbers);
    for (std::size_t i = 0; i < values_.size(); ++i) put(values_[i], block, rows_.values(i, block));
    put_notes(block);
    std::move(unsolved.begin(), unsolved.end(), std::back_inserter(waiting_));
    if (waiting_.size() >= kRowsAtATime) put_unsolved(kRowsAtATime);
  }

  /// Writes the first `n` that wait, so that all blocks but the last are whole pieces.
  void put_unsolved(std::size_t n) {
    if (n == 0) return;
    std::vector<double> scenarios;
    std::vector<std::string> reasons;
    const auto end = waiting_.begin() + static_cast<std::ptrdiff_t>(n);
    for (auto one = waiting_.begin(); one != end; ++one) {
      scenarios.push_back(static_cast<double>(one->scenario));
      reasons.push_back(std::move(one->reason));
    }
    waiting_.erase(waiting_.begin(), end);
    file_.put_block(unsolved_.value(), {n_unsolved_}, {n}, scenarios.data());
    file_.put_block(reasons_.value(), {n_unsolved_}, {n}, reasons);
    n_unsolved_ += n;
  }

  void write_curves(const study::ScenarioRange& block) {
    std::vector<float> turned(block.size() * n_angles_);
    for (std::size_t q = 0; q < curves_.size(); ++q) {
      if (!curves_[q]) continue;
      const std::vector<float> curve = rows_.curve(q, 0, n_angles_, block);
      for (std::uint64_t i = 0; i < block.size(); ++i) {
        for (std::size_t k = 0; k < n_angles_; ++k) turned[i * n_angles_ + k] = curve[k * block.size() + i];
      }
      const auto size = static_cast<std::size_t>(block.size());
      file_.put_block(*curves_[q], curve_shape(static_cast<std::size_t>(block.first), 0, 0),
                      curve_shape(size, n_angles_), turned.data());
    }
  }

  ResultFileWriter& file_;
  const StudyRows& rows_;
  const std::vector<StudyRows::ScenarioNotes>& notes_;
  const std::uint64_t n_;
  const std::size_t n_angles_;
  std::string coordinates_;
  std::optional<int> base_, solved_, sample_, unsolved_, reasons_, note_scenario_, note_count_, has_note_;
  std::vector<std::optional<int>> factors_, values_, curves_;
  std::vector<ShardReader::Unsolved> waiting_;
  std::uint64_t n_unsolved_ = 0;  ///< written
};

void write_axes(ResultFileWriter& file, const StudyRows& rows) {
  file.numbers({kCrankAngle}, {kCrankAngle, "degree", "degree", "crank angle, 0 at firing TDC", "varphi", ""},
               kept_angles(rows.plan.study().keep));
  if (!has_ring_axis(rows)) return;
  file.numbers({kRing}, count(kRing, "ring, counted from the chamber"), std::vector<double>{1});
}

void write_bands(ResultFileWriter& file, const StudyRows& rows) {
  file.numbers({"quantile"}, count("quantile", "share of the scenarios below"), band_shares());
  const std::vector<CurveBand> bands = curve_bands(rows);
  const std::size_t n_quantities = bands.size() / rows.plan.study().bases.size();
  for (std::size_t q = 0; q < n_quantities; ++q) {
    std::vector<float> numbers;  // [base][share][angle]
    for (std::size_t b = q; b < bands.size(); b += n_quantities) {
      for (const auto& curve : bands[b].values)
        for (const double number : curve) numbers.push_back(static_cast<float>(number));
    }
    cycle::Quantity quantity = bands[q].quantity;
    quantity.name = fmt::format("curve_{}_quantile", quantity.name);
    quantity.long_name.append(", quantiles over the scenarios");
    std::vector<const char*> dimensions = {"base_case", "quantile", kCrankAngle};
    if (has_ring_axis(rows)) dimensions.push_back(kRing);
    file.numbers(dimensions, quantity, numbers);
  }
}

/// Names and weights of operating points, and the weighted mean of each value over the bases.
void write_points(ResultFileWriter& file, const StudyRows& rows) {
  const study::Study& study = rows.plan.study();
  std::vector<std::string> names;
  std::vector<double> weights;
  for (const study::WeightedPoint& point : study.sampling.points) {
    names.push_back(point.name);
    weights.push_back(point.weight);
  }
  file.texts("operating_point", text("operating_point_name", "operating points, in their order"), names);
  file.numbers({"operating_point"}, described("operating_point_weight", "1", "weight of the point", "w"), weights);
  const std::vector<cycle::Quantity>& quantities = rows.plan.values().quantities;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    cycle::Quantity quantity = quantities[i];
    const std::vector<double> values = rows.values(i);
    std::vector<double> means;
    for (std::size_t b = 0; b < study.bases.size(); ++b) {
      means.push_back(study::weighted_mean(rows.plan, values, b).value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    quantity.name += "_weighted_mean";
    quantity.long_name += ", weighted mean over the operating points";
    quantity.equation = "eq-weighted-mean";
    file.numbers({"base_case"}, quantity, means);
  }
}

}  // namespace

void write_study_result(const std::string& path, const StudyRows& rows) {
  const study::OutputSelection& keep = rows.plan.study().keep;
  AsideFile aside(path);
  const std::vector<StudyRows::ScenarioNotes>& notes = rows.scenario_notes();
  ResultFileWriter file(path, aside, most_bytes(rows, notes));
  write_head(file, rows);
  if (keep.curves != study::Curves::kNone) write_axes(file, rows);
  BlockWriter blocks(file, rows, notes);
  blocks.define();
  write_error(file, rows);
  blocks.write();
  if (keep.curves == study::Curves::kQuantiles) write_bands(file, rows);
  if (!rows.plan.study().sampling.points.empty()) write_points(file, rows);
  file.close();
  aside.put_in_place();
}

}  // namespace ringfilm::io
