#include "ringfilm/io/table/text_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "ringfilm/base/error.hpp"
#include "ringfilm/io/table/text_cells.hpp"
#include "ringfilm/io/text/text_encoding.hpp"

namespace ringfilm::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr TableRules kNamed{TableHeader::kRequired, Gaps::kRefused}, kHeights{TableHeader::kOptional, Gaps::kKept};

TextTable table_of(const std::string& text, const TableRules& rules = kNamed, const TableReading& stated = {}) {
  return read_text_tables("a.csv", text, rules, stated).front();
}

std::string refusal_of(const std::string& text, const TableRules& rules = kNamed, const TableReading& stated = {}) {
  try {
    table_of(text, rules, stated);
    return "";
  } catch (const InputError& error) {
    return describe(error.faults());
  }
}

std::vector<std::string> names_of(const TextTable& table) {
  std::vector<std::string> names;
  for (const Heading& column : table.columns) names.push_back(column.name + "|" + column.unit.value_or("?"));
  return names;
}

TEST(TextCells, NumbersAndGapsOfOtherPrograms) {
  EXPECT_EQ(number_of("1.0D-3", false), 1e-3);
  EXPECT_EQ(number_of("-2,5d+1", true), -25);
  EXPECT_EQ(number_of("+3", false), 3);
  for (const char* word : {"d3", "inf", "nan", "1,5", "1.5x", "0x10", ""})
    EXPECT_EQ(number_of(word, false), std::nullopt) << word;
  for (const char* word : {"", "NaN", "No Data", "***", "---", "NA", "n/a", "1.#QNAN", "-1.#IND", "BAD", "Masked",
                           "#NUM!", "1.#INF", "-inf", "-", "."}) {
    EXPECT_TRUE(is_missing_word(word)) << word;
  }
  for (const char* word : {"0", "x", "height", "banana"}) EXPECT_FALSE(is_missing_word(word)) << word;
}

TEST(TextCells, SeparatorsBetweenQuotesPartNothing) {
  const std::string line = "\"Crank angle, deg\",\"Pressure; bar\" , 3";
  ASSERT_EQ(separator_of(line), ',');
  const std::vector<PlacedCell> cells = cells_of(line, ',');
  ASSERT_EQ(cells.size(), 3u);
  EXPECT_EQ(cells[0].text, "Crank angle, deg");
  EXPECT_EQ(cells[0].column, 2);
  EXPECT_EQ(cells[1].text, "Pressure; bar");
  EXPECT_EQ(cells[2].text, "3");
  EXPECT_EQ(cells_of("5\" pipe,2", ',').size(), 2u) << "a single quote is a letter";
}

TEST(TextEncoding, Windows1252AndUtf16BecomeUtf8) {
  EXPECT_EQ(decoded("KW [\xB0KW]\n")->text, "KW [\u00B0KW]\n");
  EXPECT_EQ(decoded("\x80 5\n")->text, "\u20AC 5\n") << "Latin-1 has no euro";
  EXPECT_EQ(decoded(std::string("\xFF\xFE"
                                "1\0\xB5\0\n\0",
                                8))
                ->text,
            "1\u00B5\n");
  EXPECT_EQ(decoded(std::string("\xFE\xFF\0"
                                "1\0\n",
                                6))
                ->text,
            "1\n");
  const std::string letters = "x [\xB5m];z\n0;1,5\n";
  std::string little, big;
  for (const char letter : letters) {
    little += {letter, '\0'};
    big += {'\0', letter};
  }
  EXPECT_EQ(decoded(little)->text, "x [\u00B5m];z\n0;1,5\n") << "UTF-16 without its mark";
  EXPECT_EQ(decoded(big)->text, decoded(little)->text);
  EXPECT_EQ(decoded(std::string("MZ\0\0\1\0x\0y\0z\0a\0b\0", 18)), std::nullopt) << "binary";
  EXPECT_EQ(decoded("1\u00B5\n"), std::nullopt) << "UTF-8 already";
  EXPECT_EQ(decoded(std::string("\xB0\x01", 2)), std::nullopt) << "binary";
}

TEST(TextTable, LinesInFrontOfTheHeaderAreSkippedAndListed) {
  const TextTable table =
      table_of("Test 17, engine 3, 1500 rpm\nDate;2024-01-01\nx [mm];z [mm]\n0,0;0,012\n0,5;0,011\nEND OF DATA\n");
  EXPECT_EQ(table.separator, ';');
  EXPECT_EQ(table.header_line, 3);
  EXPECT_THAT(names_of(table), ElementsAre("x|mm", "z|mm"));
  EXPECT_THAT(table.cells, ElementsAre(0, 0.012, 0.5, 0.011));
  EXPECT_THAT(table.account(), HasSubstr("the columns are named in line 3: x [mm], z [mm]"));
  EXPECT_THAT(table.account(), HasSubstr("2 lines from 1 to 2 (Test 17, engine 3, 1500 rpm)"));
  EXPECT_THAT(table.account(), HasSubstr("skipped behind the numbers: line 6 (END OF DATA)"));
  EXPECT_EQ(table_of("x [mm],z [mm]\n0,1\n1,2\n").account(), "") << "nothing to report of a plain table";
}

TEST(TextTable, WordsBetweenTheNumbersAreAFault) {
  EXPECT_THAT(refusal_of("x,z\n0,1\n1,2\nEND,OF\n3,4\n"), HasSubstr("a.csv:4:1: \"END\" is not a number"));
  EXPECT_THAT(refusal_of("1,2,3,4\n5,6,7,8\nx,y,z,v\n1,2,3,4\n", kHeights),
              HasSubstr("a.csv:3:1: \"x\" is not a finite"));
  EXPECT_THAT(refusal_of("1,2,three,4\n5,6,7,8\n9,1,2,3\n", kHeights), HasSubstr("a.csv:1:5: \"three\""))
      << "a row with a fault in it is not a line in front of the table";
}

TEST(TextTable, TheHeadersOfTestBenches) {
  const TextTable table = table_of("CA;PCYL1\n\u00B0CA;bar\n1;1\n-360;1,5\n-359;2\n");
  EXPECT_THAT(names_of(table), ElementsAre("CA|\u00B0CA", "PCYL1|bar"));
  EXPECT_THAT(table.cells, ElementsAre(-360, 1.5, -359, 2));
  EXPECT_EQ(table_of("CA;P\ndeg;bar\n1;1\n2;1\n3;1\n").rows(), 3u) << "here the ones are samples";
  // Names, what they mean, units.
  EXPECT_THAT(names_of(table_of("Bench 3\nCA;P\ndeg;bar\n0;1\n1;2\n")), ElementsAre("CA|deg", "P|bar"));
}

TEST(TextTable, ColumnsPartedByBlanks) {
  const TextTable table = table_of("angle [deg]   p [bar]\n  0   1.0\n  1   1.5\n");
  EXPECT_THAT(names_of(table), ElementsAre("angle|deg", "p|bar"));
  EXPECT_THAT(table.cells, ElementsAre(0, 1, 1, 1.5));
}

TEST(TextTable, CommentsOfOtherProgramsAndAHeaderAmongThem) {
  for (const char* sign : {"#", "%", "//"}) {
    const TextTable table = table_of(std::string(sign) + " x [um]  z [nm]\n0 1\n1 2\n");
    EXPECT_THAT(names_of(table), ElementsAre("x|um", "z|nm")) << sign;
  }
  EXPECT_THAT(table_of("sep=;\n; a comment\nx;z\n0;1\n;2\n", {TableHeader::kRequired, Gaps::kKept}).rows(), 2u);
}

TEST(TextTable, UnitsInNamesAsProgramsWriteThem) {
  for (const char* name : {"Pressure / bar", "Pressure (bar)", "Pressure_bar", "Pressure, bar", "Pressure bar"}) {
    const std::optional<Heading> heading = with_unit_of_name(heading_of(name), is_any_unit);
    ASSERT_TRUE(heading) << name;
    EXPECT_EQ(heading->name, "Pressure") << name;
    EXPECT_EQ(heading->unit, "bar") << name;
  }
  EXPECT_EQ(heading_of("X_[um]").name, "X");
  for (const char* name : {"p_load50", "crank_angle", "p (cyl 1)", "Pressure"}) {
    EXPECT_FALSE(with_unit_of_name(heading_of(name), is_any_unit)) << name;
  }
}

TEST(TextTable, WhatTheUserStatesOverrules) {
  TableReading stated;
  EXPECT_THAT(refusal_of("0,1\n1,2\n"), HasSubstr("--columns"));
  stated.columns = "angle [deg], p [bar]";
  EXPECT_THAT(names_of(table_of("0,1\n1,2\n", kNamed, stated)), ElementsAre("angle|deg", "p|bar"));
  EXPECT_EQ(table_of("Winkel;Druck\n0;1\n1;2\n", kNamed, stated).rows(), 2u);
  EXPECT_THAT(refusal_of("0,1,2\n1,2,3\n", kNamed, stated),
              HasSubstr("2 columns are stated, and the row has 3 values"));
  stated = {};
  stated.skip_lines = 2;
  EXPECT_THAT(table_of("10\n2\n3\n4\n", kHeights, stated).cells, ElementsAre(3, 4));
  stated = {};
  stated.missing = {"-9999", "leer"};
  const TextTable table = table_of("1,-9999.0,leer,4\n5,6,7,8\n", kHeights, stated);
  EXPECT_TRUE(std::isnan(table.at(0, 1)) && std::isnan(table.at(0, 2)));
  EXPECT_EQ(table.at(1, 1), 6);
}

TEST(TextTable, CommasThatMayPartThousandsAreRefused) {
  const std::string thousands = "x [um]\tz [nm]\n0\t998\n1\t1,002\n2\t12,345\n";
  EXPECT_THAT(refusal_of(thousands), HasSubstr("a.csv:3:3: \"1,002\" may be 1002 or 1.002"));
  EXPECT_THAT(refusal_of(thousands), HasSubstr("other numbers of the column have three digits or more without one"));
  EXPECT_THAT(refusal_of(thousands), HasSubstr("if it is 1002, write thousands without commas"));
  EXPECT_THAT(refusal_of("0.5;1,002\n1.0;2,003\n", kHeights), HasSubstr("have decimal points"));
  EXPECT_THAT(refusal_of("x,z\n0,\"1,300\"\n1,\"1,400\"\n"), HasSubstr("commas separate the columns"));
  EXPECT_THAT(refusal_of("x;z\n0;1,234.5\n1;2\n"), HasSubstr("a.csv:2:3: \"1,234.5\" has separators of thousands"));
  EXPECT_THAT(refusal_of("x;z\n0;12.05.2024\n1;2\n"), HasSubstr("is not a number"));
  // One number that cannot be grouped shows that all commas are decimal.
  for (const char* rows : {"0;998\n1;1,002\n2;0,500\n", "0;998\n1;1,002\n2;1,02\n", "0;998\n1;1,002\n2;1500,000\n"}) {
    EXPECT_EQ(table_of(std::string("x;z\n") + rows).at(1, 1), 1.002) << rows;
  }
  const TextTable table = table_of("x;z\n0;1,234\n1;5,678\n");
  EXPECT_EQ(table.at(1, 1), 5.678);
  EXPECT_THAT(table.account(), HasSubstr("decimal commas"));
}

TEST(TextTable, QuotedDecimalCommasBetweenCommas) {
  EXPECT_THAT(table_of("\"x [um]\",\"z [um]\"\n\"0,5\",\"1,3000\"\n\"1,0\",\"-1,4\"\n").cells,
              ElementsAre(0.5, 1.3, 1, -1.4));
  EXPECT_THAT(table_of("x [um],z [um]\n0,\"1,3000\"\n1,\"1,4\"\n", kHeights).cells, ElementsAre(0, 1.3, 1, 1.4));
  EXPECT_THAT(table_of("\"0,25\",\"0,5\",\"1\",\"2\"\n\"0,1\",\"4\",\"5\",\"6\"\n", kHeights).n_columns, 4u);
}

TEST(TextTable, OneNumberALineWithADecimalComma) {
  const std::string heights = "1,3000\n1,0672\n-0,5228\n0,25\n";
  EXPECT_THAT(
      refusal_of(heights, kHeights),
      HasSubstr("a.csv:2:3: \"0672\" is not a whole number: the 2 values of a row may be 1 with decimal commas"));
  EXPECT_THAT(refusal_of(heights, kHeights), HasSubstr("--columns \"z [um]\" for one number"));
  TableReading stated;
  for (const char* columns : {"z [um]", "z [um];", "z [um],"}) {
    stated.columns = columns;
    EXPECT_THAT(table_of(heights, kHeights, stated).cells, ElementsAre(1.3, 1.0672, -0.5228, 0.25)) << columns;
  }
  stated.columns = "z [um]";
  EXPECT_THAT(table_of("1\n1,0672\n-0,5228\n", kHeights, stated).cells, ElementsAre(1, 1.0672, -0.5228));
  stated.columns = "x [um], z [um]";
  EXPECT_THAT(table_of("1,3000\n2,0672\n", kHeights, stated).cells, ElementsAre(1, 3000, 2, 672));
  stated.columns = "z [um]";
  EXPECT_THAT(refusal_of("0.5;1.3;2\n1;1.4;2\n", kHeights, stated), HasSubstr("1 column is stated, and the row has 3"));
  EXPECT_TRUE(table_of("0,12\n1,15\n", kHeights).may_be_pairs);
  EXPECT_FALSE(table_of("0,1.2\n1,15\n", kHeights).may_be_pairs);
  EXPECT_THAT(refusal_of("x [um],z [um]\n0,5000,1,0300\n1,0000,1,3982\n", kHeights),
              HasSubstr("with decimal commas, separate the columns by semicolons"));
}

TEST(TextTable, ACommentNamesTheColumnsAsAHeaderWould) {
  for (const char* header : {"# x_um y_um", "# x(um) y(um)", "# x / um, y / um", "#x (um)\ty (um)"}) {
    EXPECT_EQ(table_of(std::string(header) + "\n0 1\n1 2\n", kHeights).columns.size(), 2u) << header;
  }
  EXPECT_TRUE(table_of("# recorded yesterday\n0 1\n1 2\n", kHeights).columns.empty());
}

TEST(TextTable, TheLineRightAboveTheNumbersNamesThem) {
  for (const char* head : {"Meta Data\nFile Type,Profile\n\n", "Meta Data\nFile Type,Profile\n"}) {
    const TextTable table =
        table_of(std::string(head) + "Lateral (um),Total Profile (A)\n0.0,13000.0,\n0.5,1e4,\n", kHeights);
    ASSERT_EQ(table.columns.size(), 2u);
    EXPECT_EQ(table.columns[1].name, "Total Profile (A)");
  }
  EXPECT_TRUE(table_of("[Header]\nInstrument=Form Talysurf\n[Data]\n0.0 1.3\n0.5 1.4\n", kHeights).columns.empty());
}

TEST(TextTable, LinesOfOldMacintoshFilesEndWithACarriageReturn) {
  EXPECT_THAT(table_of("x,z\r0,1\r1,2\r").cells, ElementsAre(0, 1, 1, 2));
  EXPECT_THAT(table_of("x,z\r\n0,1\r\n1,2\r\n").row_lines, ElementsAre(2, 3));
  EXPECT_THAT(table_of("1,2,3,4\r5,6,7,8\r9,1,2,3", kHeights).row_lines, ElementsAre(1, 2, 3));
  EXPECT_THAT(table_of("x,z\n0,1\r1,2\n2,3\r\n").row_lines, ElementsAre(2, 3, 4));
}

TEST(TextTable, TrueAndFalseStateWhatIsValid) {
  EXPECT_THAT(table_of("Scan 3\nx [um];z [um];valid\n0;1;TRUE\n1;2;false\n", kHeights).cells,
              ElementsAre(0, 1, 1, 1, 2, 0));
  EXPECT_THAT(refusal_of("x;z\n0;true\n1;2\n"), HasSubstr("\"true\" is not a number"));
}

TEST(TextTable, GapsAreListedWithTheirFaults) {
  const TextTable table = table_of("x,z\n0,1\n1,\n2,nan\n", {TableHeader::kRequired, Gaps::kListed});
  ASSERT_EQ(table.n_gaps, 2u);
  EXPECT_EQ(table.gaps[1].row, 2u);
  EXPECT_EQ(table.gaps[1].column, 1u);
  EXPECT_EQ(table.gaps[0].fault.message, "a value is missing");
  EXPECT_EQ(table.gaps[0].fault.mark.line, 3);
}

}  // namespace
}  // namespace ringfilm::io
