// SPDX-License-Identifier: Apache-2.0
// PDFs that say they are ours: with the identifier that their bytes ask for, whatever their table and streams say, pages are
// parts of the file, none twice, and are unpacked within their limit.
#include <cstdlib>
#include <string>

#include "tactics/error.h"
#include "tactics/readers/gzip.h"
#include "tactics/readers/own_pdf.h"

using namespace tactics;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    constexpr std::size_t kMost = 1 << 20;
    std::string pdf(reinterpret_cast<const char*>(data), size);
    const std::size_t table = pdf.rfind("xref\n0 "), id = pdf.rfind(" /ID [<");
    if (table != std::string::npos && id != std::string::npos && id > table && pdf.size() - id > 39)
        pdf.replace(id + 7, 32, own_pdf_id(std::string_view(pdf).substr(0, table)));
    const auto pages = own_pdf_pages(pdf);
    if (!pages) return 0;
    const char* from = pdf.data();
    for (const std::string_view page : *pages) {
        if (page.data() < from || page.data() + page.size() > pdf.data() + pdf.size()) std::abort();
        from = page.data() + page.size();
        try {
            if (inflated(page, kMost, "fuzz.pdf").size() > kMost) std::abort();
        } catch (const Error& error) {
            if (error.what()[0] == '\0') std::abort();
        }
    }
    return 0;
}
