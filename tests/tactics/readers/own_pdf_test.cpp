// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/own_pdf.h"

#include <gtest/gtest.h>

#include "print/format.h"
#include "tactics/error.h"
#include "tactics/layout/lay_out.h"
#include "tactics/readers/gzip.h"
#include "tests/print/hard_pages.h"

namespace tactics::own_pdf_test {
namespace {

std::string written(const std::string& name, const std::vector<Page>& pages) {
    const Format& format = *find_format(name);
    std::string bytes;
    each_file(format, pages, Settings(format.options), [&](std::string_view more) { bytes += more; });
    return bytes;
}

std::vector<Page> two_pages() {
    std::vector<Page> pages;
    for (const double end : {90.0, 40.0}) {
        Drawing drawing;
        drawing.width = drawing.height = 100;
        drawing.strokes.push_back({{{10, 10}, {end, 50}}, false, LineClass::normal});
        pages.push_back(pages_of(drawing, rendered::sheet_of("a5", end > 50 ? "One" : "Two")).all.front());
    }
    return pages;
}

TEST(OwnPdf, CarriesTheSvgOfEachPage) {
    const std::vector<Page> pages = two_pages();
    const std::string pdf = written("pdf", pages);
    const auto found = own_pdf_pages(pdf);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), 2u);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_EQ(inflated((*found)[i], 1 << 20, "a.pdf"), written("svg", {pages[i]})) << "page " << i + 1;
}

TEST(OwnPdf, IsOursOnlyAsItWasWritten) {
    const std::string pdf = written("pdf", two_pages());
    EXPECT_FALSE(own_pdf_pages(""));
    EXPECT_FALSE(own_pdf_pages("%PDF-1.6\n%%EOF\n"));
    EXPECT_FALSE(own_pdf_pages(pdf + "% annotated\n%%EOF\n"));
    EXPECT_FALSE(own_pdf_pages(pdf.substr(0, pdf.size() - 1)));
    // A number that was changed in place.
    const auto box = pdf.find("/MediaBox [0 0 4");
    ASSERT_NE(box, std::string::npos);
    std::string changed = pdf;
    changed[box + 15] = '5';
    EXPECT_FALSE(own_pdf_pages(changed));
}

TEST(OwnPdf, HostileTablesAreHarmless) {
    const std::string pdf = written("pdf", two_pages());
    const std::size_t table = pdf.rfind("xref\n0 ", pdf.rfind("startxref"));
    ASSERT_LT(table, pdf.size());
    for (std::size_t at = table; at < pdf.size(); ++at)
        for (const char to : {'9', '0', ' ', '\n'}) {
            std::string changed = pdf;
            changed[at] = to;
            const auto found = own_pdf_pages(changed);
            if (!found) continue;
            for (const std::string_view page : *found) {
                ASSERT_GE(page.data(), changed.data());
                ASSERT_LE(page.data() + page.size(), changed.data() + changed.size());
            }
        }
    EXPECT_THROW(inflated("no zlib at all", 100, "a.pdf"), Error);
}

}  // namespace
}  // namespace tactics::own_pdf_test
