#include "ringfilm/io/start/start_documents.hpp"

#include <fmt/format.h>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/base/joined.hpp"
#include "ringfilm/io/text/toml_tree.hpp"

namespace ringfilm::io {
namespace {

using cycle::Case;

/// "1500 rpm", times a factor.
std::string speed_text(const Case& c, double factor = 1) {
  return quoted(text_in(factor * c.operating.speed, kRpm, 4));
}

/// `key = "contact.hardness"`; of a pack the keys of all rings, which have one number.
std::string key_of_rings(const Case& c, const std::string& key) {
  if (!c.is_pack()) return "key = " + quoted(key);
  std::vector<std::string> keys;
  for (std::size_t ring = 1; ring <= c.rings.size(); ++ring) {
    keys.push_back(quoted("ring." + std::to_string(ring) + "." + key));
  }
  return "keys = [" + joined(keys, ", ") + "]";
}

std::string head(const std::string& title, const std::string& kind, const std::string& case_path) {
  return fmt::format(
      "# A study of ringfilm; docs/manual/study.md describes the keys.\n"
      "title = {}\nkind = {}\n\n[[base]]                           # one more [[base]] is compared with this one\n"
      "name = \"case\"\ncase = {}\n",
      quoted(title), quoted(kind), quoted(case_path));
}

std::string speed_factor(const Case& c, int points) {
  return fmt::format("\n[[factor]]\nname = \"speed\"\nkey = \"operating.speed\"\nrange = [{}, {}]\npoints = {}\n",
                     speed_text(c, 0.5), speed_text(c, 2), points);
}

std::string map(const Case& c, const std::string& case_path) {
  const bool is_wiebe = c.gas.model == cycle::GasModel::kWiebe;
  const auto peak = [&](double factor) { return quoted(text_in(factor * c.gas.peak_pressure, kBar, 3)); };
  const std::string load =
      is_wiebe
          ? fmt::format(
                "\n[[factor]]\nname = \"peak pressure\"\nkey = \"gas.peak_pressure\"\nrange = [{}, {}]\npoints = 7\n",
                peak(0.7), peak(1.2))
          : fmt::format(
                "\n[[factor]]                         # typical, assumed: additive or coating\nname = "
                "\"boundary coefficient\"\n{}\nrange = [0.06, 0.14]\npoints = 5\n",
                key_of_rings(c, "contact.boundary_shear_strength_coefficient"));
  return head("Map over speed and " + std::string(is_wiebe ? "load" : "boundary coefficient"), "map", case_path) +
         speed_factor(c, 9) + load + "\n[plan]\nmethod = \"grid\"\n";
}

std::string uncertainty(const Case& c, const std::string& case_path) {
  std::string text = head("How uncertain is friction, and which input decides?", "uncertainty", case_path);
  text += fmt::format(
      "\n[[factor]]\nname = \"boundary coefficient\"\n{}\ndistribution = \"uniform\"\nlower = 0.08\nupper = 0.14\n"
      "source = \"typical, assumed: engine oils with anti-wear additive\"\n",
      key_of_rings(c, "contact.boundary_shear_strength_coefficient"));
  const Case& first = c.is_pack() ? c.rings.front() : c;
  text += fmt::format(
      "\n[[factor]]\nname = \"roughness\"\n{}\nhow = \"scale\"\ndistribution = \"normal\"\nmean = 1\ndeviation = 0.1\n"
      "truncate = [0.7, 1.3]\nsource = \"assumed: from place to place of a liner\"\n",
      key_of_rings(c, first.contact.plateau.Rpq ? "contact.plateau.Rpq" : "contact.roughness"));
  text +=
      "\n[[factor]]\nname = \"speed\"\nkey = \"operating.speed\"\nhow = \"scale\"\ndistribution = \"uniform\"\n"
      "lower = 0.98\nupper = 1.02\nsource = \"assumed: a governed test bench\"\n";
  if (c.film.supply == cycle::OilSupply::kFilmOnLiner) {
    text +=
        "\n[[factor]]\nname = \"oil supply\"\nkey = \"supply.film\"\nhow = \"scale\"\ndistribution = \"lognormal\"\n"
        "median = 1\nlog_deviation = 0.4\ntruncate = [0.3, 3]\nsource = \"assumed: hardly ever measured\"\n";
  }
  return text + "\n[plan]\nmethod = \"sobol\"\nscenarios = 64                     # more narrow the intervals\n";
}

std::string compare(const Case& c, const std::string& case_path) {
  const bool has_grade = !c.is_pack() && c.lubricant.grade.has_value();
  const std::string factor =
      has_grade ? "\n[[factor]]\nname = \"oil\"\nkey = \"lubricant.grade\"\nvalues = [\"SAE 5W-30\", \"SAE 0W-20\"]\n"
                  "source = \"typical oils of their grades (ringfilm oils)\"\n"
                : fmt::format(
                      "\n[[factor]]\nname = \"boundary coefficient\"\n{}\nvalues = [0.12, 0.08]\n"
                      "source = \"typical, assumed: without and with a friction modifier\"\n",
                      key_of_rings(c, "contact.boundary_shear_strength_coefficient"));
  return head(has_grade ? "Which oil, over speed?" : "A friction modifier, over speed", "compare", case_path) + factor +
         speed_factor(c, 4) + "\n[plan]\nmethod = \"grid\"\n";
}

}  // namespace

std::vector<std::string> start_study_kinds() { return {"map", "uncertainty", "compare"}; }

std::string start_study(const std::string& kind, const Case& c, const std::string& case_path) {
  if (kind == "map") return map(c, case_path);
  return kind == "uncertainty" ? uncertainty(c, case_path) : compare(c, case_path);
}

std::string start_life(const Case& c, const std::string& case_path) {
  if (c.is_pack()) {
    throw InputError("a life follows one ring, and the case has " + std::to_string(c.rings.size()),
                     "name the case of one ring: ringfilm new ring.toml writes one");
  }
  return fmt::format(
      "# The life of a ring for ringfilm: its face wears by Archard's law. docs/manual/guide/life.md describes the "
      "keys.\n"
      "title = \"Wear of the face\"\ncase = {}\nmode = \"archard\"\nhours = [\"0 h\", \"10 h\", \"50 h\", \"150 "
      "h\"]\n\n"
      "[wear]\ncoefficient = \"1e-19 m2/N\"         # typical, assumed: a hard coating; or \"fit\" from measured "
      "faces\n\n"
      "[duty]\n\n[[duty.point]]                     # one for each operating point, with its share of the cycles\n"
      "name = \"of the case\"\nweight = 1\nspeed = {}\n",
      quoted(case_path), speed_text(c));
}

}  // namespace ringfilm::io
