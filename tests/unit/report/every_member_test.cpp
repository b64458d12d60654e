#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "page_data.hpp"
#include "result_example.hpp"
#include "ringfilm/base/members.hpp"
#include "ringfilm/cycle/pack/gas_quantities.hpp"
#include "ringfilm/io/life/life_output.hpp"
#include "ringfilm/io/result/gas_json.hpp"
#include "ringfilm/io/result/input_members.hpp"
#include "ringfilm/io/result/pack_sums.hpp"
#include "ringfilm/io/result/result_document.hpp"
#include "ringfilm/io/result/result_json.hpp"
#include "ringfilm/report/html.hpp"
#include "ringfilm/report/life_page.hpp"

/// Each output has each member of the records of a result, of a pack, of its gas and of a life. Python reads the JSON.
namespace ringfilm::report {
namespace {

using nlohmann::ordered_json;

gas_path::GasPathResult gas_of_two_regions() {
  gas_path::GasPathResult gas;
  gas.duration = 0.08;
  gas.regions = {{"chamber", 1e6, 10, 2e5, 450, 400, 0.1, 1e-9}, {"crankcase", 1e5, 0, 1e5, 330, 360, 0, 0}};
  gas.composition.emplace();
  for (const char* name : {"fresh charge", "burnt gas", "air", "hydrogen", "water"}) {
    gas.composition->scalars.push_back({name, 1e-7, 1e-8, 1e-9, 0.2, 0.3});
  }
  gas.paths = {{gas_path::PathKind::kEndGap, 0, 0, 1}};
  gas.transported = {1e-6};
  gas.back = {1e-7};
  gas.motion.resize(1);
  gas.motion[0] = {true, 2, true, -12.5, 30, 0.25, 1e-3, 40, 0.5};
  return gas;
}

io::ResultDocument pack_of_two_rings() {
  io::ResultDocument ring;
  ring.inputs.push_back({"engine.bore", "0.1", "100 mm", false, "", 0.1});
  for (const auto& quantity : cycle::cycle_quantities()) ring.result.values.*quantity.value = 1.5;
  ring.result.derived["oil_density"] = 800;
  cycle::StrokeProfile& stroke = ring.result.stroke;
  stroke.liner_position = {0.02, 0.04};
  for (auto* films : {&stroke.film_ahead, &stroke.film_behind}) films->fill({1e-6, 2e-6});
  io::ResultDocument pack = io::pack_document("a pack", {ring, ring});
  pack.gas = io::pack_gas(gas_of_two_regions(), 287);
  pack.oil_losses = {{"evaporation", "kg/s", 1e-7, 2e-7, 3e-7, "how much renews", "supply.reach"},
                     {cycle::kTotalOilLoss, "kg/s", 1e-7, 2e-7, 3e-7, "all at once"}};
  return pack;
}

io::LifeDocument life_of_one_state() {
  io::LifeDocument document;
  document.file.life.points.resize(1);
  life::LifeState& state = document.result.states.emplace_back();
  state.x = {0, 1e-3};
  state.face_height = {0, 1e-6};
  state.values.assign(life::life_quantities().size(), 1.5);
  state.points = {state.values};
  state.point_gas = {gas_path::gas_sums(gas_of_two_regions(), 287)};
  state.worn = life::worn_profile({1e-6, 2e-6}, 1.5e-9, 20e-6);
  state.worn->running_in_roughness = 0.4e-6;
  state.worn->smoothing_share = 0.3;
  state.worn->blow_by = 1e-5;
  state.least_wear.resize(1);
  state.from_measured.resize(1);
  state.other_paths = {state.values};
  state.other_worn = {state.worn};
  document.result.other_paths.resize(1);
  return document;
}

template <class Quantities, class Check>
void expect_each(const Quantities& quantities, const Check& has) {
  for (const cycle::Quantity& quantity : quantities) EXPECT_TRUE(has(quantity.name)) << quantity.name;
}

/// Does an object have each member of a record, whatever its value?
template <class Record, class Object>
void expect_members(const Object& object) {
  for_each_member<Record>([&](const auto& member) { EXPECT_TRUE(object.contains(member.name)) << member.name; });
}

/// Does a result file have them behind a prefix? Names of variables are plain text in NetCDF-4.
template <class Record>
void expect_variables(const std::string& file, const std::string& prefix) {
  for_each_member<Record>([&](const auto& member) {
    EXPECT_NE(file.find(prefix + member.name), std::string::npos) << prefix << member.name;
  });
}

auto in_object(const ordered_json& object) {
  return [&object](const std::string& name) { return object.contains(name) && !object[name].is_null(); };
}

auto in_text(const std::string& text, const std::string& before) {
  return [&text, before](const std::string& name) { return text.find(before + name) != std::string::npos; };
}

/// A description of a quantity in the data of a page.
auto on_page(const std::string& page) {
  return [&page](const std::string& name) { return page.find("\"name\":\"" + name + "\"") != std::string::npos; };
}

TEST(EveryMember, OfTheRecordsOfAResultIsInJson) {
  const io::ResultDocument document = io::example_document();
  const ordered_json json = ordered_json::parse(io::result_json(document)), &entry = json["ledger"][1];
  expect_members<io::Provenance>(json);
  expect_members<cycle::Note>(json["notes"][1]);
  expect_members<study::GridRun>(json["error_estimate"]["runs"][0]);
  expect_members<study::LedgerEntry>(entry);
  expect_members<study::LedgerVariant>(entry["variants"][0]);
  expect_members<study::PublishedValue>(json["comparison"][0]);
  expect_members<study::ComparisonRow>(json["comparison"][0]);

  const ordered_json check =
      ordered_json::parse(io::check_json({"example.toml", document.inputs, {document.ledger}, document.result.notes}));
  expect_members<io::CaseEntry>(check["stated"][0]);
  expect_members<io::CaseEntry>(check["default_inputs"][0]);
  expect_members<study::LedgerEntry>(check["modelling_assumptions"][0]);
  expect_members<cycle::Note>(check["notes"][0]);
}

TEST(EveryMember, OfTheRecordsOfAResultIsInFilesAndOnPages) {
  io::ResultDocument document = io::example_document();
  document.contact.phi_s = document.contact.phi_x;
  const std::string file = io::result_bytes(document);
  expect_variables<io::Provenance>(file, "");
  expect_variables<cycle::Note>(file, "note_");
  expect_variables<study::GridRun>(file, "grid_run_");
  expect_variables<study::LedgerEntry>(file, "ledger_");
  expect_variables<study::LedgerVariant>(file, "variant_");
  expect_variables<study::PublishedValue>(file, "comparison_");
  expect_variables<study::ComparisonRow>(file, "comparison_");
  expect_variables<io::CaseEntry>(file, "input_");
  expect_variables<cycle::InputFile>(file, "file_");
  expect_variables<cycle::ContactCurves>(file, "contact_law_");
  expect_variables<cycle::ContactCurves::Law>(file, "contact_law_");

  const nlohmann::json data = example::data_of(report_page({document}, {})), &page = data["cases"][0];
  expect_members<io::Provenance>(page["provenance"]);
  expect_members<cycle::Note>(page["notes"][0]);
  expect_members<study::GridRun>(page["errors"]["runs"][0]);
  expect_members<study::LedgerEntry>(page["ledger"][1]);
  expect_members<study::LedgerVariant>(page["ledger"][1]["variants"][0]);
  expect_members<study::PublishedValue>(page["comparison"][0]);
  expect_members<study::ComparisonRow>(page["comparison"][0]);
  expect_members<io::CaseEntry>(page["inputs"][0]);
  expect_members<cycle::InputFile>(page["files"][0]);
  expect_members<cycle::ContactCurves>(page["contact"]);
  expect_members<cycle::ContactCurves::Law>(page["contact"]["laws"][0]);
}

TEST(EveryMember, OfAPackAndItsGasIsInEachOutput) {
  const io::ResultDocument pack = pack_of_two_rings();
  const ordered_json json = ordered_json::parse(io::result_json(pack));
  expect_each(cycle::summed_quantities(), in_object(json["all_rings"]));
  expect_each(cycle::summed_quantities(), in_object(json["by_ring"][1]));
  expect_each(cycle::summed_quantities(), in_object(json["units"]));
  expect_each(io::pack_oil_quantities(), in_object(json["oil"]));
  EXPECT_EQ(json["oil_consumption"]["evaporation"]["assumption"], "how much renews");
  for_each_member<cycle::NarrowedBand>([&](const auto& member) {
    EXPECT_TRUE(json["oil_consumption"]["narrowed_by"][0].contains(member.name)) << member.name;
  });
  expect_each(cycle::gas_sum_quantities(), in_object(json["gas"]));
  expect_each(cycle::gas_ring_quantities(), in_object(json["gas"]["ring_motion"][0]));
  expect_each(cycle::gas_path_quantities(), in_object(json["gas"]["paths"][0]));
  expect_each(cycle::gas_region_quantities(), in_object(json["gas"]["regions"][0]));
  expect_each(cycle::gas_scalar_quantities(), in_object(json["gas"]["composition"][0]));

  const std::string file = io::result_bytes(pack);
  expect_each(cycle::summed_quantities(), in_text(file, "pack_"));
  expect_each(io::pack_oil_quantities(), in_text(file, ""));
  for_each_member<cycle::OilLoss>([&](const auto& member) {
    EXPECT_NE(file.find(std::string("oil_loss_") + member.name), std::string::npos) << member.name;
  });
  expect_each(cycle::gas_sum_quantities(), in_text(file, ""));
  expect_each(cycle::gas_ring_quantities(), in_text(file, "gas_ring_"));
  expect_each(cycle::gas_path_quantities(), in_text(file, "gas_path_"));
  expect_each(cycle::gas_region_quantities(), in_text(file, "gas_region_"));
  expect_each(cycle::gas_scalar_quantities(), in_text(file, "gas_scalar_"));

  const std::string page = report_page({pack}, {});
  expect_each(io::pack_oil_quantities(), on_page(page));
  EXPECT_NE(page.find("how much renews"), std::string::npos);
  expect_each(cycle::gas_sum_quantities(), on_page(page));
  expect_each(cycle::gas_ring_quantities(), on_page(page));
  expect_each(cycle::gas_path_quantities(), on_page(page));
  expect_each(cycle::gas_region_quantities(), on_page(page));
  expect_each(cycle::gas_scalar_quantities(), on_page(page));
  const std::size_t by_ring = page.find("\"by_ring\":[");
  const std::string sums = page.substr(by_ring, page.find(']', by_ring) - by_ring);
  expect_each(cycle::summed_quantities(), in_text(sums, "\""));
}

TEST(EveryMember, OfALifeIsInEachOutput) {
  const io::LifeDocument document = life_of_one_state();
  const ordered_json json = ordered_json::parse(io::life_json(document)), &state = json["states"][0];
  for (const ordered_json& object : {state, state["band"], json["units"]}) {
    expect_each(life::life_quantities(), in_object(object));
    expect_each(life::worn_quantities(), in_object(object));
  }
  expect_members<life::RingState>(state);
  expect_members<life::WearBound>(state["least_wear"][0]);
  expect_members<life::FaceDistance>(state["measured_face_distance"][0]);
  expect_each(life::life_quantities(), in_object(state["points"][0]));
  expect_each(cycle::gas_sum_quantities(), in_object(state["points"][0]));

  const std::string path = testing::TempDir() + "every_member_life.nc";
  io::write_life(path, document);
  std::ifstream stream(path, std::ios::binary);
  const std::string file{std::istreambuf_iterator<char>(stream), {}};
  std::remove(path.c_str());
  expect_each(life::life_quantities(), in_text(file, ""));
  expect_each(life::worn_quantities(), in_text(file, ""));
  expect_variables<life::RingState>(file, "");

  const std::string page = life_page(document);
  expect_each(life::life_quantities(), on_page(page));
  expect_each(life::worn_quantities(), on_page(page));
}

}  // namespace
}  // namespace ringfilm::report
