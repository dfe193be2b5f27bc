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

// Objects in front of a table of our kind, with the identifier that they ask for.
std::string forged(const std::string& objects, const std::vector<std::size_t>& offsets) {
    const std::string before = "%PDF-1.6\n" + objects;
    std::string pdf = before + "xref\n0 " + std::to_string(offsets.size() + 1) + "\n0000000000 65535 f \n";
    for (const std::size_t offset : offsets) {
        const std::string digits = std::to_string(offset);
        pdf += std::string(10 - digits.size(), '0') + digits + " 00000 n \n";
    }
    return pdf + "trailer\n<< /Size 9 /ID [<" + own_pdf_id(before) + ">] >>\nstartxref\n" + std::to_string(before.size()) +
           "\n%%EOF\n";
}

TEST(OwnPdf, WhatAForgedTableNamesTwiceOrALengthOversteps) {
    const std::string entries = "1 0 obj\n<< " + std::string(kOwnPageEntries), stream = ">>\nstream\nabcd\nendstream\nendobj\n";
    const std::string whole = entries + "/Length 4 " + stream;
    const std::string both = forged(whole + whole, {9, 9 + whole.size()});
    const auto once = own_pdf_pages(both);
    ASSERT_TRUE(once);
    EXPECT_EQ(*once, (std::vector<std::string_view>{"abcd", "abcd"}));
    // One object for many entries would be searched again and again.
    EXPECT_FALSE(own_pdf_pages(forged(whole + whole, std::vector<std::size_t>(100000, 9))));
    EXPECT_FALSE(own_pdf_pages(forged(whole + whole, {9 + whole.size(), 9})));
    // A stream ends with its object, and one without a length or a beginning is none.
    EXPECT_FALSE(own_pdf_pages(forged(entries + "/Length 4000 " + stream, {9})));
    EXPECT_FALSE(own_pdf_pages(forged(entries + "/Length 45 " + stream + whole, {9, 9 + entries.size()})));
    EXPECT_FALSE(own_pdf_pages(forged(entries + stream, {9})));
    EXPECT_FALSE(own_pdf_pages(forged(entries + "/Length 4 >>\nabcd\n", {9})));
    EXPECT_FALSE(own_pdf_pages(forged(whole, {4000})));
}

TEST(OwnPdf, ItsEndTellsWhetherItMayBeOurs) {
    const std::string pdf = written("pdf", two_pages());
    EXPECT_TRUE(may_be_own_pdf(pdf.substr(pdf.size() - kOwnPdfEnd)));
    EXPECT_TRUE(may_be_own_pdf(pdf));
    EXPECT_FALSE(may_be_own_pdf(pdf.substr(0, pdf.size() - 1)));
    EXPECT_FALSE(may_be_own_pdf("trailer\n<< /Size 9 /ID [<00112233445566778899AABBCCDDEEFF>] >>\nstartxref\n9\n%%EOF\n"));
}

}  // namespace
}  // namespace tactics::own_pdf_test
