#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "case_example.hpp"
#include "ringfilm/io/storage/shipped.hpp"

namespace ringfilm::io {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// What reading `path` reports; empty if it could be read.
std::string message_of(const std::string& path) {
  try {
    read_case(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CaseSources, IncludesAreRelativeToTheFileThatNamesThem) {
  CaseText text;
  text.top += "include = [\"parts/ring.toml\"]\n";
  text.ring = text.face = "";
  const CaseFolder folder(text);
  std::filesystem::create_directory(folder / "parts");
  folder.write("parts/ring.toml",
               "include = \"face.toml\"\n[ring]\nface_width = \"1.5 mm\"\nelastic_pressure = \"0.1 MPa\"\n");
  folder.write("parts/face.toml", "[ring.face]\nform = \"points\"\nfile = \"face.csv\"\n");
  folder.write("parts/face.csv", "x [mm],height [um]\n0,10\n1.5,0\n");
  const cycle::Case c = folder.read();
  EXPECT_EQ(c.ring.face_width, 1.5e-3);
  EXPECT_EQ(c.ring.face.points_file, folder / "parts/face.csv");
  ASSERT_EQ(c.files.size(), 5u);
  EXPECT_EQ(c.files[1].role, "include");
}

TEST(CaseSources, AKeyInTwoFilesNamesBothPlaces) {
  CaseText text;
  text.top += "include = [\"a.toml\"]\n";
  const CaseFolder folder(text);
  folder.write("a.toml", "[engine]\nbore = \"90 mm\"\n");
  const std::string reported = folder.faults();
  EXPECT_THAT(reported, HasSubstr("case.toml:4:1: engine.bore is given twice"));
  EXPECT_THAT(reported, HasSubstr("delete line 2 of a.toml or line 4 of case.toml"));
}

TEST(CaseSources, AnIncludeOfItselfIsRefused) {
  CaseText text;
  text.top += "include = [\"a.toml\"]\n";
  const CaseFolder folder(text);
  folder.write("a.toml", "include = [\"./case.toml\"]\n");
  EXPECT_THAT(folder.faults(), HasSubstr("a.toml:1:12: case.toml includes itself"));
}

TEST(CaseSources, EachFileIsIncludedOnceUnderWhateverSpelling) {
  CaseText text;
  text.top += "include = [\"0.toml\"]\n";
  const CaseFolder folder(text);
  std::filesystem::create_directory(folder / "d");
  std::filesystem::create_symlink("0.toml", folder / "link.toml");
  const std::vector<std::string> spellings = {"\"./", "\"d/../", "\"d/.././", "\""};
  constexpr std::size_t kFiles = 8;
  for (std::size_t i = 0; i < kFiles; ++i) {
    std::string names = "\"link.toml\"";
    for (std::size_t j = 0; j < kFiles; ++j) names += ", " + spellings[(i + j) % 4] + std::to_string(j) + ".toml\"";
    folder.write(std::to_string(i) + ".toml", "include = [" + names + "]\n");
  }
  try {
    folder.read();
    FAIL() << "not refused";
  } catch (const InputError& error) {
    // Every include but the first of each file, and no more.
    EXPECT_EQ(error.faults().size(), kFiles * (kFiles + 1) - (kFiles - 1));
    EXPECT_THAT(error.what(), HasSubstr("0.toml includes itself"));
  }
  const std::string reported = folder.faults();
  EXPECT_THAT(reported, HasSubstr("link.toml includes itself"));
  EXPECT_THAT(reported, HasSubstr(".toml is included twice\n"));
}

TEST(CaseSources, MoreFilesThanACaseHasSectionsAreRefused) {
  CaseText text;
  std::string names;
  for (int i = 0; i < 40; ++i) names += (i > 0 ? ", " : "") + ("\"" + std::to_string(i)) + ".toml\"";
  text.top += "include = [" + names + "]\n";
  const CaseFolder folder(text);
  for (int i = 0; i < 40; ++i) folder.write(std::to_string(i) + ".toml", "# nothing\n[engine]\n");
  EXPECT_THAT(folder.faults(), HasSubstr("more than 32 files are included"));
}

TEST(CaseSources, ALongListOfFaultsEndsWithHowManyThereAreMore) {
  CaseText text;
  for (int i = 0; i < 1000; ++i) text.top += "unknown_" + std::to_string(i) + " = 1\n";
  const std::string reported = faults_of(text);
  EXPECT_THAT(reported, HasSubstr("unknown key unknown_99\n"));
  EXPECT_THAT(reported, Not(HasSubstr("unknown_100")));
  EXPECT_THAT(reported, HasSubstr("\nand 900 more\n"));
}

TEST(CaseSources, ControlCharactersAreRefusedInEveryTextOfAFile) {
  CaseText text;
  text.top = "title = \"a\\u0000b\"\n";
  EXPECT_THAT(faults_of(text), HasSubstr("case.toml:1:9: \"a\\u0000b\" holds the control character U+0000"));
  text.top = "title = \"\\u001b[31m\"\ninclude = [\"x\\u009b.toml\"]\n\"k\\u0007\" = 1\n";
  const std::string reported = faults_of(text);
  EXPECT_THAT(reported, HasSubstr("\"\\u001B[31m\" holds the control character U+001B"));
  EXPECT_THAT(reported, HasSubstr("holds the control character U+009B"));
  EXPECT_THAT(reported, HasSubstr("the key \"k\\u0007\" holds the control character U+0007"));
  text.top = "title = \"two\\nlines\"\n";
  EXPECT_THAT(faults_of(text), HasSubstr("title = \"two\\u000Alines\" holds the control character U+000A"));
}

TEST(CaseSources, ControlCharactersAreRefusedInSettingsOnTheCommandLine) {
  EXPECT_THAT(faults_of({}, {{"title", "\x1b[2J"}}), HasSubstr("holds the control character U+001B"));
  EXPECT_THAT(faults_of({}, {{"title", "\"a\\u0000b\""}}), HasSubstr("holds the control character U+0000"));
  EXPECT_THAT(faults_of({}, {{"operating.speed", "\"1500 rpm\\u0000\""}}), HasSubstr("control character"));
  EXPECT_THAT(faults_of({}, {{"gas.cylinder_pressure", "\"p.csv\\u0000x\""}}), HasSubstr("U+0000"));
  EXPECT_THAT(faults_of({}, {{"title", "\u00B5m and \u00E4"}}), "");
}

TEST(CaseSources, DeepIncludesAreRefused) {
  CaseText text;
  text.top += "include = [\"0.toml\"]\n";
  const CaseFolder folder(text);
  for (int i = 0; i < 12; ++i) {
    folder.write(std::to_string(i) + ".toml", "include = [\"" + std::to_string(i + 1) + ".toml\"]\n");
  }
  EXPECT_THAT(folder.faults(), HasSubstr("files are included more than 8 deep"));
}

TEST(CaseSources, AMissingIncludeIsReportedWhereItIsNamed) {
  CaseText text;
  text.top += "include = [\"gone.toml\"]\n";
  text.ring = "";
  const std::string reported = faults_of(text);
  EXPECT_THAT(reported, HasSubstr("case.toml:2:12: include = \"gone.toml\": there is no such file"));
  // With a file missing the missing keys are unknown.
  EXPECT_THAT(reported, Not(HasSubstr("is missing")));
}

TEST(CaseSources, OverridesReplaceKeysOfAllFiles) {
  const CaseFolder folder;
  const cycle::Case c = folder.read({{"operating.speed", "3000 rpm"},
                                     {"contact.composite_modulus", "\"135 GPa\""},
                                     {"solver.cells", "400"},
                                     {"film.cavitation", "reynolds-exit"},
                                     {"output.fields", "[\"20 degree\"]"},
                                     {"title", "2026"}});
  EXPECT_DOUBLE_EQ(c.operating.speed, 2 * 157.07963267948966);
  EXPECT_EQ(c.contact.composite_modulus, 135e9);
  EXPECT_EQ(c.solver.cells, 400);
  EXPECT_EQ(c.film.cavitation, cycle::Cavitation::kReynoldsExit);
  EXPECT_EQ(c.output.field_angles_deg.size(), 1u);
  EXPECT_EQ(c.title, "2026");
}

TEST(CaseSources, AnEmptyOverrideTakesAKeyOut) {
  const cycle::Case c = CaseFolder().read({{"ring.elastic_pressure", ""}, {"ring.tangential_force", "12 N"}});
  EXPECT_FALSE(c.ring.elastic_pressure.has_value());
  EXPECT_EQ(c.ring.tangential_force, 12.0);
}

TEST(CaseSources, OverridesAreCheckedLikeTheFile) {
  const std::string reported = CaseFolder().faults(
      {{"operating.sped", "3000 rpm"}, {"engine.bore", "89"}, {"engine.stroke", "80 bar"}, {"solver.cells", "[1"}});
  EXPECT_THAT(reported, HasSubstr("--set: unknown key operating.sped; did you mean operating.speed?"));
  EXPECT_THAT(reported, HasSubstr("--set: engine.bore = 89 has no unit"));
  EXPECT_THAT(reported, HasSubstr("--set: engine.stroke = \"80 bar\" is not a length"));
  EXPECT_THAT(reported, HasSubstr("--set: solver.cells = \"[1\" is not a whole number"));
}

TEST(CaseSources, AnOverrideCanRepairAFaultyValue) {
  CaseText text;
  text.ring = "[ring]\nface_width = 1.2\nelastic_pressure = \"0.2 MPa\"\n";
  EXPECT_THAT(CaseFolder(text).faults({{"ring.face_width", "1.2 mm"}}), IsEmpty());
}

TEST(CaseSources, AByteOrderMarkAndLineEndsOfOtherSystemsAreReadAndNoted) {
  const CaseFolder folder;
  std::string text = "\xEF\xBB\xBF";
  for (const char c : CaseText().text()) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  folder.write("case.toml", text);
  const cycle::Case c = folder.read();
  ASSERT_EQ(c.notes.size(), 1u);
  EXPECT_THAT(c.notes[0], HasSubstr("byte-order mark"));
}

TEST(CaseSources, WhatIsNotACaseFileIsRefusedBeforeItIsParsed) {
  const CaseFolder folder;
  EXPECT_THAT(message_of(folder / "gone.toml"), HasSubstr("gone.toml: there is no such file"));
  EXPECT_THAT(message_of(folder / "."), HasSubstr("this is a folder, not a file"));
  folder.write("x.toml", std::string("title = \"a\0b\"\n", 13));
  EXPECT_THAT(message_of(folder / "x.toml"), HasSubstr("x.toml:1:11: the file is binary, not text"));
  folder.write("x.toml", "");
  EXPECT_THAT(message_of(folder / "x.toml"), HasSubstr("the file is empty"));
  folder.write("x.toml", " \n\n");
  EXPECT_THAT(message_of(folder / "x.toml"), HasSubstr("the file is empty"));
  folder.write("x.toml", "title = \"M\xFCller\"\n");
  EXPECT_THAT(message_of(folder / "x.toml"), HasSubstr("x.toml:1:11: the file is not UTF-8 text"));
  folder.write("x.toml", "\xFF\xFEt\0");
  EXPECT_THAT(message_of(folder / "x.toml"), HasSubstr("UTF-16"));
  folder.write("x.toml", std::string(5 << 20, 'a'));
  EXPECT_THAT(message_of(folder / "x.toml"), HasSubstr("the file is larger than 4 MB"));
  folder.write("x.toml", "b\xC3\xB6r = 1\n");
  EXPECT_THAT(message_of(folder / "x.toml"), HasSubstr("x.toml:1:2: a key must be written in ASCII letters"));
}

TEST(CaseSources, TextThatBreaksTomlParsersIsRefused) {
  const CaseFolder folder;
  std::string deep_key = "a";
  for (int i = 0; i < 100000; ++i) deep_key += ".a";
  for (const std::string& text :
       {std::string("[="), std::string("[*]"), std::string("a = [="), std::string("a = \"\"\""), std::string("a = {"),
        "a = " + std::string(100000, '['), "a = " + std::string(100000, '{'), deep_key + " = 1", std::string("[a\n]"),
        std::string("a = 1 b = 2"), std::string("= 1"), std::string("a"), std::string("a = 1979-05-27T"),
        std::string("a = 9223372036854775808"), std::string("a = \"\\uD800\"")}) {
    folder.write("x.toml", text + "\n");
    EXPECT_THAT(message_of(folder / "x.toml"), HasSubstr("x.toml:")) << text.substr(0, 20);
  }
}

TEST(CaseSources, AShippedOilOutOfReachIsReportedByTheNameThatIsFoundFromAnywhere) {
  ASSERT_EQ(::setenv("RINGFILM_DATA", RINGFILM_SOURCE_FOLDER, 1), 0);
  const ScratchFolder folder;
  const std::string path =
      folder.write("case.toml", "[lubricant]\nfile = \"../gone/data/lubricants/styles2014.toml\"\n");
  try {
    read_case(path, {});
    FAIL() << "an oil that is not there was read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("found from anywhere as \"data/lubricants/styles2014.toml\""));
  }
  ASSERT_EQ(::unsetenv("RINGFILM_DATA"), 0);
}

TEST(CaseSources, TheShippedFolderIsFoundByTheEnvironment) {
  ASSERT_EQ(::setenv("RINGFILM_DATA", RINGFILM_SOURCE_FOLDER, 1), 0);
  EXPECT_EQ(shipped_folder(), RINGFILM_SOURCE_FOLDER);
  CaseText text;
  text.lubricant = "[lubricant]\nfile = \"data/lubricants/styles2014.toml\"\n";
  EXPECT_EQ(CaseFolder(text).read().lubricant.kinematic_viscosity.size(), 2u);
  ASSERT_EQ(::setenv("RINGFILM_DATA", "/nowhere", 1), 0);
  EXPECT_THROW(shipped_folder(), InputError);
  ASSERT_EQ(::unsetenv("RINGFILM_DATA"), 0);
}

TEST(CaseSources, TheShippedFolderIsFoundAmongTheSharedDataOfTheSystem) {
  const ScratchFolder folder;
  const std::filesystem::path shared = folder / "share";
  std::filesystem::create_directories(shared / "ringfilm" / "cases");
  ASSERT_EQ(::setenv("XDG_DATA_DIRS", ("/nowhere::ours:" + shared.string()).c_str(), 1), 0);
  EXPECT_NE(find_shipped_folder(), (shared / "ringfilm").string()) << "data/ is not there";
  std::filesystem::create_directories(shared / "ringfilm" / "data");
  EXPECT_EQ(find_shipped_folder(), (shared / "ringfilm").string());
  ASSERT_EQ(::unsetenv("XDG_DATA_DIRS"), 0);
}

}  // namespace
}  // namespace ringfilm::io
