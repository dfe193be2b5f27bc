// SPDX-License-Identifier: Apache-2.0
#include "tactics/braille/tables.h"

#include <liblouis/liblouis.h>

#include <algorithm>

#include "tactics/braille/braille.h"
#include "tests/cli/tool.h"
#include "tests/tactics/braille/message_of.h"

namespace tactics::tables_test {
namespace {

using namespace tests;

std::string names_of(const std::vector<BrailleTable>& tables) {
    std::string names;
    for (const BrailleTable& table : tables) names += table.name + " ";
    return names;
}

TEST(BrailleTables, SayWhoseTheyAre) {
    const BrailleTable table =
        table_of("x.ctb",
                 "# a table\n#-index-name: German, contracted\r\n#-display-name:  German contracted braille \n"
                 "#+language:de\n#+language: gsw\n#+grade: 2\n#+dots:6\n#+type: literary\n+grade: 7\n");
    EXPECT_EQ(words_of(table), "de gsw, grade 2: German contracted braille");
    EXPECT_EQ(table.type + table.dots, "literary6");
    EXPECT_TRUE(table_of("y.cti", "sign a 1\n#+grade\n#").languages.empty());
    EXPECT_EQ(words_of(table_of("z", "#+language: pl\n")), "pl");
}

TEST(BrailleTables, AreFoundByTagAndByName) {
    const std::vector<BrailleTable> all{{"c8", {"de"}, "", "computer", "8", "German computer braille"},
                                        {"g2", {"de"}, "2", "literary", "", "German contracted braille"},
                                        {"x", {"nds-DE"}, "1", "literary", "", "Low German braille"},
                                        {"fr", {"fr"}, "1", "literary", "", "French braille"}};
    EXPECT_EQ(names_of(tables_for("de", all)), "g2 c8 ");
    EXPECT_EQ(names_of(tables_for("DE_at", all)), "g2 c8 ");
    EXPECT_EQ(names_of(tables_for(" German", all)), "g2 x c8 ");
    EXPECT_EQ(names_of(tables_for("man", all)) + names_of(tables_for("", all)) + names_of(tables_for("de-g3.ctb", all)), "");
}

// Each that is listed sets text, as liblouis itself finds it.
TEST(BrailleTables, ThatAreListedAreTables) {
    const std::vector<BrailleTable> tables = described_tables();
    ASSERT_GT(tables.size(), 50u);
    for (std::size_t i = 0; i < tables.size(); i += 7) EXPECT_NE(lou_getTable(tables[i].name.c_str()), nullptr) << tables[i].name;
    EXPECT_TRUE(std::any_of(tables.begin(), tables.end(), [](const BrailleTable& table) {
        return words_of(table) == "en, grade 2: Unified English contracted braille" && table.name == "en-ueb-g2.ctb";
    }));
}

TEST(BrailleTables, OfALanguageAreOffered) {
    for (const std::string language : {"de", "german", "de-AT"}) {
        const std::string told = message_of("a", language);
        EXPECT_EQ(told.find("--braille: there is no braille table \"" + language + "\"; choose de-g0"), 0u) << told;
        EXPECT_NE(told.find("de-g2.ctb (German contracted braille)"), std::string::npos) << told;
    }
}

TEST(BrailleTables, AreListedWithLanguageAndGrade) {
    const Folder folder;
    const std::string listed = run_tactics(folder, {"list", "braille"}).out;
    EXPECT_TRUE(holds(listed, "de-g2.ctb: de, grade 2: German contracted braille\n")) << listed;
    const std::string json = run_tactics(folder, {"list", "braille", "--json"}).out;
    EXPECT_TRUE(holds(json, "\"name\":\"de-g2.ctb\"") &&
                holds(json, "\"languages\":[\"de\"],\"grade\":\"2\",\"type\":\"literary\""))
        << json;
    EXPECT_TRUE(holds(run_tactics(folder, {"help", "de-g2.ctb"}).out, "--braille de-g2.ctb"));
}

}  // namespace
}  // namespace tactics::tables_test
