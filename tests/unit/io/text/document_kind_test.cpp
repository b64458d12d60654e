#include "ringfilm/io/text/document_kind.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ringfilm/case/keys/case_fields.hpp"

namespace ringfilm::io {
namespace {

using ::testing::HasSubstr;

TomlValue tree(const std::string& text) {
  SourceText source;
  source.text = text;
  return parse_toml(source);
}

TEST(DocumentKind, EverySectionOfACaseIsTakenForACase) {
  for (const cycle::Field& field : cycle::case_fields()) {
    const std::size_t dot = field.key.find('.');
    if (dot == std::string::npos) continue;
    const TomlValue root = tree("[" + field.key.substr(0, dot) + "]\n");
    EXPECT_NO_THROW(check_document_kind(root, DocumentKind::kCase, "x.toml")) << field.key;
    EXPECT_THROW(check_document_kind(root, DocumentKind::kStudy, "x.toml"), InputError) << field.key;
    EXPECT_THROW(check_document_kind(root, DocumentKind::kLife, "x.toml"), InputError) << field.key;
  }
}

TEST(DocumentKind, NamesWhatTheFileIsAndTheCommandThatReadsIt) {
  try {
    check_document_kind(tree("title = \"x\"\n[plan]\nmethod = \"grid\"\n"), DocumentKind::kCase, "x.toml");
    ADD_FAILURE() << "taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("x.toml: this file is a study, not a case"));
    EXPECT_THAT(error.what(), HasSubstr("ringfilm study x.toml --output FOLDER"));
  }
}

TEST(DocumentKind, LeavesAFileWithAKeyOfItsOwnKindOrOfNoneToItsReader) {
  EXPECT_NO_THROW(check_document_kind(tree("hours = [\"0 h\"]\n[ring]\n"), DocumentKind::kLife, "x.toml"));
  EXPECT_NO_THROW(check_document_kind(tree("title = \"x\"\nmuddle = 1\n"), DocumentKind::kStudy, "x.toml"));
}

}  // namespace
}  // namespace ringfilm::io
