#include "ringfilm/io/study_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "ringfilm/io/atomic_file.hpp"
#include "ringfilm/io/result_file_writer.hpp"

namespace ringfilm::io {
namespace {

constexpr long kStudySchema = 1;
constexpr const char* kScenario = "scenario";

const char* kind_name(study::StudyKind kind) {
  switch (kind) {
    case study::StudyKind::kMap:
      return "map";
    case study::StudyKind::kUncertainty:
      return "uncertainty";
    case study::StudyKind::kCompare:
      return "compare";
    case study::StudyKind::kScreening:
      return "screening";
  }
  return "";
}

/// What a row says besides numbers.
struct RowHead {
  long base = 0;
  bool solved = true;
};

std::vector<RowHead> heads(const StudyRows& rows, const std::vector<ShardReader::Unsolved>& unsolved) {
  std::vector<RowHead> all(rows.plan.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i].base = static_cast<long>(rows.plan.base_of(i));
  for (const auto& one : unsolved) all.at(one.scenario).solved = false;
  return all;
}

std::vector<std::string> choice_texts(const study::Factor& factor) {
  std::vector<std::string> texts;
  if (const auto* choices = std::get_if<study::Choices>(&factor.variation)) {
    for (const study::Choice& choice : choices->values) texts.push_back(choice.text);
  }
  return texts;
}

void write_head(ResultFileWriter& file, const StudyRows& rows) {
  const study::Study& study = rows.plan.study();
  const Provenance program = this_program();
  file.attribute("title", study.title);
  file.attribute("ringfilm_study_schema", kStudySchema);
  file.attribute("kind", std::string(kind_name(study.kind)));
  file.attribute("seed", static_cast<long>(study.seed));
  file.attribute("program", program.program);
  file.attribute("commit", program.commit);
  file.attribute("compiler", program.compiler);
  std::vector<std::string> roles, paths, digests;
  for (const cycle::InputFile& input : rows.file.files) {
    roles.push_back(input.role);
    paths.push_back(input.path);
    digests.push_back(input.sha256);
  }
  file.texts("input_file", {"input_file_role", "", "", "for what a file was read", "", ""}, roles);
  file.texts("input_file", {"input_file_path", "", "", "file as named", "", ""}, paths);
  file.texts("input_file", {"input_file_sha256", "", "", "SHA-256 of its bytes", "", ""}, digests);
  file.scalar({"plan", "", "", "all on which the numbers of the scenarios depend", "", ""}, rows.plan.digest_text());
  if (!rows.plan.notes().empty())
    file.texts("note", {"plan_note", "", "", "what must be known about the plan", "", ""}, rows.plan.notes());
}

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

std::vector<std::vector<double>> factor_columns(const study::Plan& plan) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::vector<double>> columns(plan.study().factors.size());
  for (auto& column : columns) column.reserve(plan.size());
  for (std::uint64_t i = 0; i < plan.size(); ++i) {
    const study::Point point = plan.point(i);
    for (std::size_t j = 0; j < columns.size(); ++j) columns[j].push_back(point.values[j].value_or(none));
  }
  return columns;
}

std::vector<std::string> factor_variables(const study::Study& study) {
  std::vector<std::string> variables;
  for (const study::Factor& factor : study.factors) {
    std::string variable = "factor_";
    for (const char c : factor.name) variable.append(1, std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_');
    if (std::find(variables.begin(), variables.end(), variable) != variables.end())
      variable.append("_").append(std::to_string(variables.size() + 1));
    variables.push_back(variable);
  }
  return variables;
}

void write_study_result(const std::string& path, const StudyRows& rows) {
  const study::Study& study = rows.plan.study();
  ResultFileWriter file(path);
  write_head(file, rows);
  const auto unsolved = rows.unsolved();
  const std::vector<RowHead> all_heads = heads(rows, unsolved);
  file.rows(kScenario, all_heads);
  std::vector<std::string> names;
  for (const study::Base& base : study.bases) names.push_back(base.name);
  file.texts("base_case", {"base_name", "", "", "name of the base case", "", ""}, names);
  file.column(kScenario, {"base", "", "", "base case of the scenario, counted from 0 in base_name", "", ""}, all_heads,
              &RowHead::base);
  std::string coordinates = "base";
  const auto columns = factor_columns(rows.plan);
  const std::vector<std::string> variables = factor_variables(study);
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const study::Factor& factor = study.factors[j];
    const std::string& variable = variables[j];
    file.numbers({kScenario}, {variable, factor.unit, factor.display_unit, factor.name, "", ""}, columns[j]);
    file.describe(variable, "key", factor.targets.front().key);
    const std::vector<std::string> texts = choice_texts(factor);
    const std::string choices = variable + "_choice";
    if (!texts.empty())
      file.texts(choices.c_str(), {choices, "", "", fmt::format("choices of {}, counted from 0", factor.name), "", ""},
                 texts);
    coordinates.append(" ").append(variable);
  }
  file.column(kScenario, {"solved", "1", "", "1 where the scenario was solved", "", ""}, all_heads, &RowHead::solved);
  std::vector<double> numbers;
  std::vector<std::string> reasons;
  for (const auto& one : unsolved) {
    numbers.push_back(static_cast<double>(one.scenario));
    reasons.push_back(one.reason);
  }
  if (!unsolved.empty()) {
    file.numbers({"unsolved"}, {"unsolved_scenario", "1", "", "scenario that was not solved, from 0", "", ""}, numbers);
    file.texts("unsolved", {"unsolved_reason", "", "", "why it was not solved", "", ""}, reasons);
  }
  const auto& quantities = cycle::cycle_quantities();
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    file.numbers({kScenario}, quantities[i], rows.values(i));
    file.describe(quantities[i].name, "coordinates", coordinates);
  }
  write_atomically(path, file.bytes());
}

void write_study_csv(const std::string& path, const StudyRows& rows) {
  const study::Study& study = rows.plan.study();
  const auto& quantities = cycle::cycle_quantities();
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
  write(line.append("\n"));
  const auto factors = factor_columns(rows.plan);
  std::vector<std::vector<double>> values;
  for (std::size_t i = 0; i < quantities.size(); ++i) values.push_back(rows.values(i));
  const auto unsolved = rows.unsolved();
  auto next_unsolved = unsolved.begin();
  std::vector<std::vector<std::string>> texts;
  for (const study::Factor& factor : study.factors) texts.push_back(choice_texts(factor));
  for (std::uint64_t i = 0; i < rows.plan.size(); ++i) {
    line = fmt::format("{},{}", i, csv_text(study.bases[rows.plan.base_of(i)].name));
    for (std::size_t j = 0; j < factors.size(); ++j) {
      const double x = factors[j][i];
      const bool is_number = texts[j].empty() || std::isnan(x);
      cell(is_number ? csv_number(x) : csv_text(texts[j].at(static_cast<std::size_t>(x))));
    }
    for (const auto& column : values) cell(csv_number(column[i]));
    const bool is_unsolved = next_unsolved != unsolved.end() && next_unsolved->scenario == i;
    cell(is_unsolved ? csv_text((next_unsolved++)->reason) : "");
    write(line.append("\n"));
  }
  if (std::fflush(file.get()) != 0) fail_to_write(path, errno);
  aside.put_in_place();
}

}  // namespace ringfilm::io
