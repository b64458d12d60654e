#include "inverse/case_server.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/find_by_name.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/text/suggestion.hpp"
#include "ringfilm/io/text/toml_tree.hpp"
#include "ringfilm/run/inverse/case_numbers.hpp"

namespace ringfilm::app {
namespace {

using nlohmann::ordered_json;

const std::vector<std::string> kRequestKeys = {"id", "case", "toml", "set", "quantities", "curves", "compute"};

/// A case as text in a file beside where the program runs, so that its file names mean what they do there.
class CaseText {
 public:
  explicit CaseText(const std::string& text) : path_(fmt::format(".ringfilm-serve-{}.toml", ::getpid())) {
    std::ofstream file(path_, std::ios::binary | std::ios::trunc);
    file << text;
    file.close();
    if (!file) throw OutputError(path_ + ": could not be written: a case as text is kept there while it is read");
  }
  CaseText(const CaseText&) = delete;
  CaseText& operator=(const CaseText&) = delete;
  ~CaseText() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// A text of a request.
std::string text_of(const ordered_json& request, const std::string& key) {
  const ordered_json& value = request.at(key);
  if (value.is_string()) return value.get<std::string>();
  throw InputError(fmt::format("{} = {} is not a text", key, value.dump()),
                   fmt::format("for example \"{}\": \"...\"", key));
}

std::vector<std::string> texts_of(const ordered_json& request, const std::string& key) {
  std::vector<std::string> texts;
  if (!request.contains(key)) return texts;
  const ordered_json& list = request.at(key);
  const auto is_text = [](const ordered_json& one) { return one.is_string(); };
  if (!list.is_array() || !std::all_of(list.begin(), list.end(), is_text)) {
    throw InputError(fmt::format("{} = {} is not a list of names", key, list.dump()),
                     fmt::format("for example \"{}\": [\"fmep\"]", key));
  }
  for (const ordered_json& one : list) texts.push_back(one.get<std::string>());
  return texts;
}

/// A value of "set" as TOML.
std::string toml_of(const ordered_json& value) {
  if (value.is_string()) return io::quoted(value.get<std::string>());
  if (value.is_object()) {
    std::string text;
    for (const auto& [key, one] : value.items()) text += (text.empty() ? " " : ", ") + key + " = " + toml_of(one);
    return "{" + text + " }";
  }
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const ordered_json& one : value) text += (text.empty() ? "" : ", ") + toml_of(one);
  return "[" + text + "]";
}

std::vector<io::Override> settings_of(const ordered_json& request) {
  std::vector<io::Override> settings;
  if (!request.contains("set")) return settings;
  const ordered_json& set = request.at("set");
  if (!set.is_object()) {
    throw InputError("set = " + set.dump() + " is not an object",
                     R"(for example "set": {"operating.speed": "3000 rpm"})");
  }
  // null takes a key out of the case, as an empty value of --set does.
  for (const auto& [key, value] : set.items()) {
    settings.push_back({key, value.is_null() ? "" : toml_of(value), "\"set\""});
  }
  return settings;
}

void check_keys(const ordered_json& request) {
  if (!request.is_object()) throw InputError("a request is a JSON object", R"(for example {"set": {}})");
  for (const auto& [key, value] : request.items()) {
    if (std::find(kRequestKeys.begin(), kRequestKeys.end(), key) != kRequestKeys.end()) continue;
    throw InputError(fmt::format("unknown key {}{}", key, io::did_you_mean(key, kRequestKeys)),
                     "a request may have id, case or toml, set, quantities, curves and compute");
  }
  if (request.contains("case") && request.contains("toml")) {
    throw InputError("a request has both case and toml", "keep one of the two");
  }
}

/// Throws InputError for a name that the case does not give.
void check_names(const std::vector<std::string>& names, const std::vector<cycle::Quantity>& known,
                 const std::string& what) {
  std::vector<std::string> all;
  for (const cycle::Quantity& quantity : known) all.push_back(quantity.name);
  for (const std::string& name : names) {
    if (find_by_name(known, name) != nullptr) continue;
    throw InputError(fmt::format("the case gives no {} {}{}", what, name, io::did_you_mean(name, all)),
                     "a request without quantities gets all values");
  }
}

ordered_json fault_object(const Fault& fault) {
  ordered_json object = {{"message", fault.message}, {"remedy", fault.remedy}};
  if (!fault.mark.file.empty()) object["file"] = fault.mark.file;
  if (fault.mark.line > 0) object["line"] = fault.mark.line;
  return object;
}

ordered_json error_list(const std::string& message) {
  return ordered_json::array({{{"message", message}, {"remedy", ""}}});
}

cycle::Case requested_case(const ordered_json& request, const std::string& base, const io::Units& units) {
  cycle::CasePurpose purpose = cycle::CasePurpose::kFilm;
  if (request.contains("compute")) {
    const std::string compute = text_of(request, "compute");
    if (compute != "films" && compute != "gas") {
      throw InputError("compute = \"" + compute + "\" is not known", "choose \"films\" or \"gas\"");
    }
    if (compute == "gas") purpose = cycle::CasePurpose::kGasPath;
  }
  const std::vector<io::Override> settings = settings_of(request);
  std::vector<io::DroppedKey> dropped;
  if (request.contains("toml")) {
    const CaseText text(text_of(request, "toml"));
    return io::read_case_dropping(text.path(), settings, units, dropped, purpose);
  }
  const std::string path = request.contains("case") ? text_of(request, "case") : base;
  if (path.empty()) {
    throw InputError("the request names no case", "add case or toml, or start the program with a case");
  }
  return io::read_case_dropping(path, settings, units, dropped, purpose);
}

ordered_json result_of(const ordered_json& request, const std::string& base, const io::Units& units) {
  check_keys(request);
  const cycle::Case input = requested_case(request, base, units);
  const std::vector<std::string> names = texts_of(request, "quantities"), curves = texts_of(request, "curves");
  check_names(names, run::value_quantities(input), "value");
  check_names(curves, run::curve_quantities(input), "curve");
  const run::CaseNumbers numbers = run::case_numbers(input, curves);
  ordered_json answer = {{"values", ordered_json::object()}};
  for (const auto& [name, value] : numbers.values) {
    if (names.empty() || std::find(names.begin(), names.end(), name) != names.end()) answer["values"][name] = value;
  }
  if (curves.empty()) return answer;
  answer["crank_angle"] = numbers.crank_angle_deg;
  answer["curves"] = numbers.curves;
  return answer;
}

}  // namespace

std::string CaseServer::answer(const std::string& line) const {
  ordered_json answer = ordered_json::object();
  const ordered_json request = ordered_json::parse(line, nullptr, false);
  if (request.is_object() && request.contains("id")) answer["id"] = request.at("id");
  try {
    if (request.is_discarded()) {
      answer["errors"] = error_list("the line is not JSON");
    } else {
      answer.update(result_of(request, base_, units_));
    }
  } catch (const InputError& error) {
    answer["errors"] = ordered_json::array();
    for (const Fault& fault : error.faults()) answer["errors"].push_back(fault_object(fault));
  } catch (const ConvergenceError& error) {
    answer["errors"] = error_list(error.what());
    if (error.crank_angle_deg()) answer["errors"][0]["crank_angle"] = *error.crank_angle_deg();
  } catch (const std::exception& error) {
    // A request must not end the program: the fault is in the answer.
    answer["errors"] = error_list(error.what());
  }
  return answer.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace ringfilm::app
