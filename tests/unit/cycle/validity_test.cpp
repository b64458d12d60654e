#include "ringfilm/cycle/advice/validity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/advice/advice.hpp"
#include "ringfilm/cycle/advice/note_topics.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/simulate.hpp"
#include "styles_case.hpp"

namespace ringfilm::cycle::testing {
namespace {

/// One sample of a ring as engines have it.
Sample usual_sample() {
  Sample s{};
  s.crank_angle_deg = 90;
  s.piston_velocity = -10;
  s.min_film_thickness = 2e-6;
  s.lambda_ratio = 4;
  s.peak_film_pressure = 20e6;
  s.viscous_friction_liner = -20;
  s.viscous_friction_ring = -20;
  return s;
}

std::vector<Note> notes_of(const std::vector<Sample>& samples, double fmep) {
  const Setup setup = prepare(styles_new_ring());
  CycleValues values;
  values.fmep = fmep;
  std::vector<Note> notes;
  append_validity_notes(setup, face_grid(setup), samples, values, {}, notes);
  return notes;
}

std::vector<std::string> topics(const Sample& sample, double fmep = 20e3) {
  std::vector<std::string> all;
  for (const Note& note : notes_of({usual_sample(), sample}, fmep)) all.push_back(note.topic);
  return all;
}

using ::testing::Contains;
using ::testing::IsSubsetOf;
using ::testing::Not;

TEST(Validity, ResultsOfARingHaveNoNoteOnLimits) {
  EXPECT_THAT(topics(usual_sample()), IsSubsetOf({"shear-rate-high", "synthetic-trace"}));
}

TEST(Validity, AsperitiesThatCannotBeElasticAreNoted) {
  const auto with_contact = [](double mean_real_pressure) {
    Sample s = usual_sample();
    s.mean_real_pressure = mean_real_pressure;
    return topics(s);
  };
  const std::vector<std::string> hard = with_contact(18e9), soft = with_contact(1e9);
  EXPECT_THAT(hard, ::testing::IsSupersetOf({"contact-beyond-hardness", "asperity-slopes-high"}));
  EXPECT_THAT(hard, Not(Contains("contact-plastic")));
  EXPECT_THAT(soft, Contains("contact-plastic"));
  EXPECT_THAT(soft, Not(Contains("contact-beyond-hardness")));
  EXPECT_THAT(with_contact(0), Not(Contains("contact-plastic")));  // asperities carry nothing
}

TEST(Validity, HardnessOfTheCaseIsThatOfItsNotes) {
  Case c = styles_new_ring();
  c.contact.hardness = 30e9;
  const CycleResult result = simulate(prepare(c));
  EXPECT_NEAR(result.derived.at("plasticity_index"), 14.68 / 12, 0.01);  // that of 2.5 GPa, over 12
  for (const Note& note : result.notes) EXPECT_NE(note.topic, "contact-beyond-hardness");
  const Sample& s = result.samples[20];
  EXPECT_DOUBLE_EQ(s.mean_real_pressure, s.asperity_load / s.asperity_contact_area);
  EXPECT_GE(result.values.peak_mean_real_pressure, s.mean_real_pressure);
}

TEST(Validity, NotesCountTheirCrankSteps) {
  Sample thin = usual_sample();
  thin.min_film_thickness = 1e-10;
  const std::vector<Note> notes = notes_of({thin, usual_sample(), thin}, 0);
  const auto found =
      std::find_if(notes.begin(), notes.end(), [](const Note& note) { return note.topic == "film-below-molecules"; });
  ASSERT_NE(found, notes.end());
  EXPECT_EQ(found->count, 2);
  EXPECT_THAT(found->message, ::testing::HasSubstr("film down to 0.1 nm (at 90 degree)"));
}

TEST(Validity, ResultsThatNoRingCanHaveAreNoted) {
  Sample s = usual_sample();
  s.min_film_thickness = 0.9e-9;
  EXPECT_THAT(topics(s), Contains("film-below-molecules"));
  s = usual_sample();
  s.min_film_thickness = 0.15e-3;  // its ends would meet at 0.01 * 89 mm/(2 pi) = 0.142 mm
  EXPECT_THAT(topics(s), Contains("film-too-thick"));
  s = usual_sample();
  s.peak_film_pressure = 0.41e9;
  EXPECT_THAT(topics(s), Contains("film-pressure-high"));
  s = usual_sample();
  s.viscous_friction_ring = 4e3;  // on pi * 89 mm * 1.2 mm: 11.9 MPa
  EXPECT_THAT(topics(s), Contains("shear-stress-high"));
  EXPECT_THAT(topics(usual_sample(), 1.1e6), Contains("friction-too-high"));
}

TEST(Validity, FrictionThatIsMostlyOfTheBoundaryIsNoted) {
  const auto note_with_share = [](double share) -> std::string {
    const auto setup = prepare(styles_new_ring());
    CycleValues values;
    values.mean_power_loss = 50;
    values.mean_boundary_power = share * values.mean_power_loss;
    std::vector<Note> notes;
    append_validity_notes(setup, face_grid(setup), {usual_sample()}, values, {}, notes);
    const auto found =
        std::find_if(notes.begin(), notes.end(), [](const Note& n) { return n.topic == "friction-mostly-boundary"; });
    return found == notes.end() ? "" : found->message;
  };
  EXPECT_EQ(note_with_share(0.69), "");
  EXPECT_THAT(note_with_share(0.92), ::testing::HasSubstr("92 % of the friction energy is boundary friction"));
  EXPECT_THAT(note_with_share(0.92), ::testing::HasSubstr("(contact.roughness)"));
  EXPECT_EQ(note_topic("friction-mostly-boundary")->trust, Trust::kFull);
}

TEST(Validity, ATensionThatNoRingHasIsNoted) {
  const auto noted = [](double force) {
    Case c = styles_new_ring();
    c.ring.elastic_pressure.reset();
    c.ring.tangential_force = force;
    const std::vector<Note> notes = advice(prepare(c));
    return std::any_of(notes.begin(), notes.end(), [](const Note& n) { return n.topic == "ring-tension-high"; });
  };
  EXPECT_FALSE(noted(10));
  EXPECT_FALSE(noted(106)) << "2 MPa, as the lands of an oil ring";
  EXPECT_TRUE(noted(1000));
}

TEST(Validity, SizesOfNoEngineAndASupplyOfMoleculesAreNoted) {
  const auto noted = [](const char* topic, const auto& change) {
    Case c = styles_new_ring();
    change(c);
    const std::vector<Note> notes = advice(prepare(c));
    return std::any_of(notes.begin(), notes.end(), [&](const Note& n) { return n.topic == topic; });
  };
  EXPECT_FALSE(noted("engine-size-unusual", [](Case&) {}));
  EXPECT_TRUE(noted("engine-size-unusual", [](Case& c) { c.engine.bore /= 10; })) << "8.9 mm";
  const auto supplied = [](double film) {
    return [film](Case& c) {
      c.film.cavitation = Cavitation::kMassConserving;
      c.film.chamber_edge = c.film.crankcase_edge = EdgeFluid::kGas;
      c.film.supply = OilSupply::kGiven;
      c.supply.film = {{0, film}};
    };
  };
  EXPECT_FALSE(noted("supply-film-thin", supplied(1e-6)));
  EXPECT_TRUE(noted("supply-film-thin", supplied(1e-9))) << "nm in place of um";
}

TEST(Validity, NotesOfASetupAreInOrderOfSeverity) {
  Case c = styles_new_ring();
  c.ring.elastic_pressure = 10e6;
  c.operating.oil_temperature = 273.15 + 180;  // above the highest stated viscosity
  const std::vector<Note> notes = advice(prepare(c));
  ASSERT_GE(notes.size(), 2u);
  EXPECT_TRUE(std::is_sorted(notes.begin(), notes.end(),
                             [](const Note& a, const Note& b) { return note_rank(a.topic) < note_rank(b.topic); }));
}

/// A cycle of one degree a sample, in which the ring slides by 0.25 mm a degree and loses the same power everywhere;
/// its film is thinnest at 500 degree.
std::vector<Sample> even_cycle() {
  std::vector<Sample> base(720, usual_sample());
  for (std::size_t k = 0; k < base.size(); ++k) {
    base[k].crank_angle_deg = static_cast<double>(k);
    base[k].sliding_distance = 0.25e-3 * static_cast<double>(k);
    base[k].power_loss = 20;
    base[k].min_film_thickness = k == 500 ? 1e-6 : 2e-6;
  }
  return base;
}

Note note_of_steps(const std::vector<UncontrolledStep>& steps, std::optional<double> accuracy = {}) {
  Case c = styles_new_ring();
  c.ring.face_width = 1.2e-3;
  Setup setup = prepare(c);
  setup.input.solver.accuracy = accuracy;
  std::vector<Note> notes;
  append_step_note(setup, even_cycle(), steps, notes);
  return notes.size() == 1 ? notes.front() : Note{};
}

// A path of twice the face, 2.4 mm, has 10 samples of 720: with an error of 20 % these are 0.28 % of the work.
TEST(Validity, TheNoteOnStepControlHasPlaceSizeAndEffectOfItsSteps) {
  const Note one = note_of_steps({{100.5, 0.2}});
  EXPECT_EQ(one.topic, "step-control-without-effect");
  EXPECT_EQ(one.count, 1);
  EXPECT_EQ(one.message,
            "steps of 1/64 of the crank step with an error in time of more than 5 %, at 100.5 degree, the largest 20 "
            "%: friction work and smallest film of the cycle may be off by 0.3 % (accuracy 0.5 %)");
  EXPECT_EQ(note_of_steps({{100.5, 0.2}}, 0.1).topic, "step-control-at-its-limit") << "a finer accuracy";
  const Note several = note_of_steps({{300.25, 0.3}, {100.5, 7}});
  EXPECT_EQ(several.topic, "step-control-at-its-limit");
  EXPECT_EQ(several.count, 2);
  EXPECT_THAT(several.message, ::testing::HasSubstr("between 100.5 and 300.2 degree, the largest 700 %"));
  EXPECT_THAT(several.message, ::testing::HasSubstr("off by 2 %")) << "(1 + 0.3) 10/720";
  const Note of_thinnest = note_of_steps({{495.0, 0.06}});
  EXPECT_EQ(of_thinnest.topic, "step-control-at-its-limit") << "the smallest film is off by 6 %";
  EXPECT_THAT(of_thinnest.message, ::testing::HasSubstr("off by 6 %"));
  EXPECT_EQ(note_of_steps({{480.0, 0.06}}).topic, "step-control-without-effect") << "too far before it";
  EXPECT_EQ(note_of_steps({}).topic, "");
  for (const Note& note : {one, several}) {
    for (const char* key : {"solver.crank_step", "solver.accuracy"})
      EXPECT_EQ(note.message.find(key), std::string::npos) << "no remedy that does not remove it";
  }
}

TEST(Validity, TheNoteOnLongCellsCountsTheCellsOfTheGrid) {
  cycle::Setup setup = prepare(styles_new_ring());
  Sample s = usual_sample();
  s.min_film_thickness = 1e-14;
  for (const CellsOfFace cells : {CellsOfFace::kUniform, CellsOfFace::kGraded}) {
    setup.cells = cells;
    const film::FilmGrid grid = face_grid(setup);
    std::vector<Note> notes;
    append_validity_notes(setup, grid, {s}, {}, {}, notes);
    const auto found =
        std::find_if(notes.begin(), notes.end(), [](const Note& note) { return note.topic == "cells-too-long"; });
    ASSERT_NE(found, notes.end());
    const std::string n = std::to_string(grid.n_cells());
    EXPECT_THAT(found->message,
                ::testing::HasSubstr(cells == CellsOfFace::kUniform ? "take more solver.cells than " + n
                                                                    : "the " + n + " cells are graded"));
  }
}

// The three ways to state the tension end at the same elastic pressure.
TEST(Validity, ATensionBeyondTheRangeOfTheElasticPressureIsRefused) {
  const auto breaches = [](double force, double width) {
    Case c = styles_new_ring();
    c.ring.elastic_pressure.reset();
    c.ring.tangential_force = force;
    c.ring.face_width = width;
    return broken_rules(c);
  };
  const double at_limit = 1e8 * 1.2e-3 * 0.089 / 2;  // F_t = p_e b B/2
  EXPECT_TRUE(breaches(0.999 * at_limit, 1.2e-3).empty());
  ASSERT_EQ(breaches(1.001 * at_limit, 1.2e-3).size(), 1u);
  EXPECT_EQ(breaches(1.001 * at_limit, 1.2e-3).front().key, "ring.tangential_force");
  EXPECT_EQ(breaches(10, 1e-9).size(), 1u);
}

std::vector<std::string> topics_of(const Case& c) {
  const Setup setup = prepare(c);
  std::vector<Note> notes = advice(setup);
  append_validity_notes(setup, face_grid(setup), {usual_sample()}, {}, {}, notes);
  std::vector<std::string> all;
  for (const Note& note : notes) all.push_back(note.topic);
  return all;
}

TEST(Validity, FewCellsAreNoted) {
  Case c = styles_new_ring();
  c.solver.cells = 49;
  EXPECT_THAT(topics_of(c), Contains("coarse-grid"));
  c.solver.cells = 50;
  EXPECT_THAT(topics_of(c), Not(Contains("coarse-grid")));
}

TEST(Validity, FewPointsOfACurvedFaceAreNoted) {
  const auto parabola = [](int n_points) {
    Case c = styles_new_ring();
    c.ring.face.form = FaceForm::kPoints;
    for (int k = 0; k < n_points; ++k) {
      const double share = k / (n_points - 1.0);
      c.ring.face.x.push_back(share * c.ring.face_width);
      c.ring.face.height.push_back(10e-6 * (2 * share - 1) * (2 * share - 1));
    }
    return topics_of(c);
  };
  for (const int n_points : {2, 3, 4, 5, 7}) EXPECT_THAT(parabola(n_points), Contains("face-points-few")) << n_points;
  for (const int n_points : {21, 200}) EXPECT_THAT(parabola(n_points), Not(Contains("face-points-few"))) << n_points;
}

TEST(Validity, AViscosityOfNoOilIsNoted) {
  const auto noted = [](double factor, double celsius) {
    Case c = styles_new_ring();
    c.operating.oil_temperature = celsius + 273.15;
    for (TemperatureValue& point : c.lubricant.kinematic_viscosity) point.value *= factor;
    return topics_of(c);
  };
  for (const double celsius : {-30.0, 40.0, 120.0}) {
    EXPECT_THAT(noted(1, celsius), Not(Contains("viscosity-high"))) << celsius;
    EXPECT_THAT(noted(1, celsius), Not(Contains("viscosity-low"))) << celsius;
  }
  EXPECT_THAT(noted(1000, 40), Contains("viscosity-high"));
  EXPECT_THAT(noted(1000, 120), Contains("viscosity-high"));
  EXPECT_THAT(noted(0.04, 40), Contains("viscosity-low"));
}

}  // namespace
}  // namespace ringfilm::cycle::testing
