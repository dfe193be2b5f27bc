// SPDX-License-Identifier: Apache-2.0
// Braille on a page, read back from the rendered PDF dot by dot and translated back into the words it was made of.
#include <gtest/gtest.h>
#include <liblouis/liblouis.h>

#include <string>
#include <vector>

#include "tactics/braille/braille.h"
#include "tactics/layout/lay_out.h"
#include "tactics/text/utf8.h"
#include "tests/print/braille_reader.h"

namespace tactics::braille_from_pdf_test {
namespace {

using rendered::FileFolder;

struct Language {
    const char* table;
    std::vector<std::string> beginnings, ends;
};

const Language kLanguages[] = {
    {"en-ueb-g2.ctb",
     {"The river", "A bridge", "Old town", "Every house", "My heart", "Under water", "Station 7", "Hill 340"},
     {" is near", " of stone", " and the church", ", 12 km", " in 1905", " for children", " with trees", " or nothing",
      " was there"}},
    // This table marks no capitals.
    {"de-g1.ctb",
     {"der fluss", "eine brücke", "die straße", "jedes haus", "höhe 340", "große stadt", "zug 7", "mein herz"},
     {" am see", " aus stein", " und die kirche", ", 12 km", " im jahr 1905", " für kinder", " mit bäumen", " oder nichts",
      " war da"}},
    {"fr-bfu-comp6.utb",
     {"la rivière", "un pont", "vieille ville", "chaque maison", "mon cœur", "sous l'eau", "gare", "forêt"},
     {" est près", " de pierre", " et l'église", " à gauche", " pour enfants", " avec arbres", " ou rien", " était là",
      " où ça"}},
};

std::string back(const std::vector<std::uint8_t>& cells, const char* table) {
    std::vector<widechar> in, out(4096);
    for (const std::uint8_t cell : cells) in.push_back(0x8000u + cell);
    int taken = static_cast<int>(in.size()), given = static_cast<int>(out.size());
    if (lou_backTranslateString(table, in.data(), &taken, out.data(), &given, nullptr, nullptr, dotsIO | ucBrl) == 0) return "";
    std::string text;
    for (int i = 0; i < given; ++i) append_letter(text, static_cast<char32_t>(out[static_cast<std::size_t>(i)]));
    return text;
}

TEST(Braille, ReadBackFromTheRenderedPdfIsTheTextThatWasGiven) {
    NEED_TOOL("pdftoppm");
    constexpr int kDpi = 150;
    constexpr std::size_t kLines = 24;  // on a sheet
    const FileFolder folder;
    std::size_t read = 0;
    for (const Language& language : kLanguages)
        for (const NamedCell& cell : {cells()[0], cells()[1]}) {
            std::vector<std::string> texts;
            for (const auto& beginning : language.beginnings)
                for (const auto& end : language.ends) texts.push_back(beginning + end);
            // What the table itself does not lead back to its text says nothing of the page.
            std::erase_if(
                texts, [&](const std::string& text) { return back(to_braille(text, language.table), language.table) != text; });
            ASSERT_GE(texts.size(), 60u) << language.table;
            for (std::size_t first = 0; first < texts.size(); first += kLines) {
                Sheet sheet;
                sheet.paper = find_paper("a4", "test");
                sheet.orientation = Orientation::portrait;
                sheet.medium = &find_medium("swell", "test");
                sheet.print_title = false;
                sheet.braille_table = language.table;
                sheet.cell = cell.size;
                Drawing drawing{180, 270, {}, {}, {}};
                const std::size_t count = std::min(kLines, texts.size() - first);
                for (std::size_t i = 0; i < count; ++i)
                    drawing.labels.push_back(
                        {{3.0 * static_cast<double>(i % 5), 11.0 * static_cast<double>(i)}, 0, 0, texts[first + i]});
                const Page page = lay_out(drawing, sheet);
                const auto lines = rendered::cells_of(
                    rendered::dots_on(rendered::by_poppler(folder, rendered::encode(page, "pdf"), kDpi), kDpi, cell.size.dot),
                    cell.size);
                ASSERT_EQ(lines.size(), count) << language.table << ", " << cell.name;
                for (std::size_t i = 0; i < count; ++i, ++read)
                    EXPECT_EQ(back(lines[i], language.table), texts[first + i]) << language.table << ", " << cell.name;
            }
        }
    EXPECT_GE(read, 400u);  // over 200 texts in three languages, in two sizes of cells
}

}  // namespace
}  // namespace tactics::braille_from_pdf_test
