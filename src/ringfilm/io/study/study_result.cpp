#include "ringfilm/io/study/study_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <set>

#include "ringfilm/cycle/advice/note_topics.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/study/factor_notes.hpp"
#include "ringfilm/io/study/study_stopping_rule.hpp"

namespace ringfilm::io {
namespace {

/// Scenarios that are held in memory at once.
constexpr std::uint64_t kRowsReadAtATime = 4096;

std::string csv_number(double value) { return std::isnan(value) ? "nan" : fmt::format("{}", value + 0.0); }

std::string csv_header(const std::string& name, const std::string& unit) {
  return unit.empty() || unit == "1" ? name : fmt::format("{} [{}]", name, unit);
}

std::string csv_text(const std::string& text) {
  std::string quoted_text = "\"";
  for (const char c : text) quoted_text.append(c == '"' ? 2 : 1, c);
  return quoted_text.append(1, '"');
}

}  // namespace

std::string StudyRows::kernels() const {
  std::set<std::string> names;
  for (const ShardReader& shard : shards) names.insert(shard.header().kernels);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::vector<double> StudyRows::values(std::size_t i) const {
  std::vector<double> all;
  all.reserve(plan.size());
  for (const ShardReader& shard : shards) shard.append_values(i, all);
  return all;
}

template <class Read>
void StudyRows::each_part(const study::ScenarioRange& range, const Read& read) const {
  for (const ShardReader& shard : shards) {
    const study::ScenarioRange part{std::max(range.first, shard.header().first),
                                    std::min(range.end, shard.header().end)};
    if (part.first < part.end) read(shard, part, part.first - range.first);
  }
}

std::vector<double> StudyRows::values(std::size_t i, const study::ScenarioRange& range) const {
  std::vector<double> all(range.size());
  each_part(range, [&](const ShardReader& shard, const study::ScenarioRange& part, std::uint64_t before) {
    shard.read_values(i, part, all.data() + before);
  });
  return all;
}

std::vector<double> StudyRows::row(std::uint64_t scenario) const {
  std::vector<double> all;
  for (std::size_t i = 0; i < plan.values().quantities.size(); ++i) {
    all.push_back(values(i, {scenario, scenario + 1}).front());
  }
  return all;
}

std::vector<float> StudyRows::curve(std::size_t i, std::size_t first_angle, std::size_t n_angles,
                                    const study::ScenarioRange& range) const {
  std::vector<float> all(n_angles * range.size());
  each_part(range, [&](const ShardReader& shard, const study::ScenarioRange& part, std::uint64_t before) {
    shard.read_curve(i, first_angle, n_angles, part, all.data() + before, range.size());
  });
  return all;
}

std::uint64_t StudyRows::n_unsolved() const {
  std::uint64_t n = 0;
  for (const ShardReader& shard : shards) n += shard.n_unsolved();
  return n;
}

std::vector<ShardReader::Unsolved> StudyRows::unsolved() const {
  std::vector<ShardReader::Unsolved> all;
  for (const ShardReader& shard : shards) shard.append_unsolved(all);
  return all;
}

std::uint64_t StudyRows::ScenarioNotes::count() const {
  return std::accumulate(bases.begin(), bases.end(), std::uint64_t{0},
                         [](std::uint64_t n, const OfBase& base) { return n + base.count; });
}

const study::ScenarioNote& StudyRows::ScenarioNotes::shown() const {
  const study::ScenarioNote* best = nullptr;
  for (const OfBase& base : bases) {
    if (base.shown && (best == nullptr || base.shown->comes_before(*best))) best = &*base.shown;
  }
  return *best;
}

std::vector<SharedNote> StudyRows::notes_of(const study::ScenarioRange& range) const {
  std::vector<SharedNote> all;
  each_part(range, [&all](const ShardReader& shard, const study::ScenarioRange& part, std::uint64_t) {
    shard.append_notes(part, all);
  });
  return all;
}

namespace {

/// Collects the notes on scenarios, topic by topic.
class NotesByTopic {
 public:
  explicit NotesByTopic(const study::Plan& plan) : plan_(plan) {}

  /// @param message the note of scenario `note.first`
  void add(const SharedNote& note, const study::ScenarioNote& message) {
    auto& bases = by_topic_[{cycle::note_rank(note.topic), note.topic}];
    bases.resize(plan_.study().bases.size());
    for (const std::uint64_t i : note.scenarios) {
      StudyRows::ScenarioNotes::OfBase& base = bases[plan_.base_of(i)];
      ++base.count;
      if (!base.shown || message.comes_before(*base.shown)) base.shown = message;
    }
  }

  std::vector<StudyRows::ScenarioNotes> all() && {
    std::vector<StudyRows::ScenarioNotes> all;
    for (auto& [key, bases] : by_topic_) all.push_back({key.second, std::move(bases)});
    return all;
  }

 private:
  const study::Plan& plan_;
  std::map<std::pair<std::size_t, std::string>, std::vector<StudyRows::ScenarioNotes::OfBase>> by_topic_;
};

void add_rows(const StudyRows& rows, FactorNotes& factors, const study::ScenarioRange& range) {
  std::vector<std::vector<double>> columns;
  for (const std::size_t i : factors.columns()) columns.push_back(rows.values(i, range));
  std::vector<double> row(columns.size());
  for (std::uint64_t k = 0; k < range.size() && !columns.empty(); ++k) {
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = columns[i][k];
    factors.add(range.first + k, row);
  }
}

}  // namespace

StudyRows::Notes StudyRows::read_notes() const {
  const std::optional<study::StoppingRule>& until = plan.study().sampling.until;
  FactorNotes factors(plan);
  NotesByTopic by_topic(plan);
  std::vector<double> of_until;
  for (std::uint64_t first = 0; first < plan.size(); first += kRowsReadAtATime) {
    const study::ScenarioRange block{first, std::min(first + kRowsReadAtATime, plan.size())};
    for (const SharedNote& note : notes_of(block)) {
      const auto value = [&](std::size_t i) { return values(i, {note.first, note.first + 1}).front(); };
      const auto badness = plan.values().has_cycle ? cycle::note_badness(note.topic, value) : std::nullopt;
      by_topic.add(note, {note.first, note.message, badness});
    }
    if (until) {
      const std::vector<double> part = values(*plan.values().index(until->value), block);
      of_until.insert(of_until.end(), part.begin(), part.end());
    }
    add_rows(*this, factors, block);
  }
  Notes notes{std::move(by_topic).all(), plan.notes()};
  for (std::string& note : until_notes(plan, of_until)) notes.of_plan.push_back(std::move(note));
  for (std::string& note : factors.notes()) notes.of_plan.push_back(std::move(note));
  const bool is_mixed = std::any_of(shards.begin(), shards.end(), [this](const ShardReader& shard) {
    return shard.header().kernels != shards.front().header().kernels;
  });
  if (is_mixed) {
    notes.of_plan.push_back(
        fmt::format("the parts were computed with different kernels ({}), which round differently: the last digits are "
                    "not those of one run",
                    kernels()));
  }
  return notes;
}

const StudyRows::Notes& StudyRows::all_notes() const {
  if (!notes_) notes_ = read_notes();
  return *notes_;
}

std::vector<ShardReader::Unsolved> StudyRows::unsolved(const study::ScenarioRange& range) const {
  std::vector<ShardReader::Unsolved> all;
  each_part(range, [&all](const ShardReader& shard, const study::ScenarioRange& part, std::uint64_t) {
    shard.append_unsolved(part, all);
  });
  return all;
}

std::vector<std::vector<double>> factor_columns(const study::Plan& plan) {
  return factor_columns(plan, {0, plan.size()});
}

std::vector<std::vector<double>> factor_columns(const study::Plan& plan, const study::ScenarioRange& range) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::vector<double>> columns(plan.study().factors.size());
  for (auto& column : columns) column.reserve(range.size());
  for (std::uint64_t i = range.first; i < range.end; ++i) {
    const study::Point point = plan.point(i);
    for (std::size_t j = 0; j < columns.size(); ++j) columns[j].push_back(point.values[j].value_or(none));
  }
  return columns;
}

std::string choice_variable(const std::string& factor_variable) { return fmt::format("{}_choice", factor_variable); }

std::vector<std::string> factor_variables(const study::Study& study) {
  constexpr std::size_t kMax = 200;  // NetCDF takes 256
  std::vector<std::string> variables;
  std::set<std::string> taken;
  for (const study::Factor& factor : study.factors) {
    std::string name = "factor_";
    for (const char c : factor.name.substr(0, kMax))
      name.append(1, std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_');
    const bool has_texts = std::holds_alternative<study::Choices>(factor.variation);
    const auto is_taken = [&](const std::string& variable) {
      return taken.contains(variable) || (has_texts && taken.contains(choice_variable(variable)));
    };
    std::string variable = name;
    for (std::size_t n = variables.size() + 1; is_taken(variable); ++n) variable = fmt::format("{}_{}", name, n);
    taken.insert(variable);
    if (has_texts) taken.insert(choice_variable(variable));
    variables.push_back(variable);
  }
  return variables;
}

std::vector<std::string> choice_texts(const study::Factor& factor) {
  std::vector<std::string> texts;
  if (const auto* choices = std::get_if<study::Choices>(&factor.variation)) {
    for (const study::Choice& choice : choices->values) texts.push_back(choice.text);
  }
  return texts;
}

void write_study_csv(const std::string& path, const StudyRows& rows) {
  const study::Study& study = rows.plan.study();
  const auto& quantities = rows.plan.values().quantities;
  AsideFile aside(path);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(aside.path().c_str(), "wb"), &std::fclose);
  if (file == nullptr) fail_to_write(path, errno);
  const auto write = [&](const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size()) fail_to_write(path, errno);
  };
  std::string line = "scenario,base";
  const auto cell = [&line](const std::string& text) { line.append(",").append(text); };
  const std::vector<std::string> variables = factor_variables(study);
  for (std::size_t j = 0; j < variables.size(); ++j) cell(csv_header(variables[j], study.factors[j].unit));
  for (const auto& quantity : quantities) cell(csv_header(quantity.name, quantity.unit));
  cell("reason");
  cell("notes");
  write(line.append("\n"));
  std::vector<std::vector<std::string>> texts;
  for (const study::Factor& factor : study.factors) texts.push_back(choice_texts(factor));
  for (std::uint64_t first = 0; first < rows.plan.size(); first += kRowsReadAtATime) {
    const study::ScenarioRange block{first, std::min(first + kRowsReadAtATime, rows.plan.size())};
    const auto factors = factor_columns(rows.plan, block);
    std::vector<std::vector<double>> values;
    for (std::size_t i = 0; i < quantities.size(); ++i) values.push_back(rows.values(i, block));
    const auto unsolved = rows.unsolved(block);
    auto next_unsolved = unsolved.begin();
    std::vector<std::string> topics(block.size());
    for (const SharedNote& note : rows.notes_of(block)) {
      for (const std::uint64_t i : note.scenarios) {
        std::string& of_row = topics[i - first];
        of_row.append(of_row.empty() ? "" : "; ").append(note.topic);
      }
    }
    for (std::uint64_t k = 0; k < block.size(); ++k) {
      const std::uint64_t i = first + k;
      line = fmt::format("{},{}", i, csv_text(study.bases[rows.plan.base_of(i)].name));
      for (std::size_t j = 0; j < factors.size(); ++j) {
        const double x = factors[j][k];
        const bool is_number = texts[j].empty() || std::isnan(x);
        cell(is_number ? csv_number(x) : csv_text(texts[j].at(static_cast<std::size_t>(x))));
      }
      for (const auto& column : values) cell(csv_number(column[k]));
      const bool is_unsolved = next_unsolved != unsolved.end() && next_unsolved->scenario == i;
      cell(is_unsolved ? csv_text((next_unsolved++)->reason) : "");
      cell(topics[k].empty() ? "" : csv_text(topics[k]));
      write(line.append("\n"));
    }
  }
  if (std::fflush(file.get()) != 0) fail_to_write(path, errno);
  aside.put_in_place();
}

}  // namespace ringfilm::io
