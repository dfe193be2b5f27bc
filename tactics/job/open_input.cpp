// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/open_input.h"

#include <algorithm>

#include "tactics/error.h"
#include "tactics/job/holds.h"
#include "tactics/job/written.h"
#include "tactics/readers/svg/cairo_glyphs.h"
#include "tactics/readers/svg/pdf.h"
#include "tactics/transport/temporary_file.h"

namespace tactics {

namespace {

// As a file that is gone when it is closed.
Source kept(const std::string& bytes, const std::string& name) {
    Source source{name, temporary_file()};
    std::FILE* file = source.file.get();
    if (file == nullptr || std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size() || std::fflush(file) != 0)
        throw Error(Fault::failed, name, "cannot be kept in a temporary file; " + temporary_file_cure());
    std::rewind(file);
    return source;
}

}  // namespace

PdfPageWish page_wish(const Wishes& wishes) { return {wishes.page, wishes.recipe || asks_for_a_way(wishes.chain)}; }

Source open_input(const std::string& path, const PdfPageWish& wish, std::vector<std::string>& notes) {
    return page_of_input(open_source(path), path, wish, notes);
}

Source page_of_input(Source source, const std::string& path, const PdfPageWish& wish, std::vector<std::string>& notes) {
    if (look_at(source) != Holds::pdf) {
        if (wish.page > 0) throw Error(Fault::usage, spelled("page"), path + " is no PDF; leave it out");
        return source;
    }
    const int pages = pages_of_pdf(source), page = std::max(1, wish.page);
    if (page > pages)
        throw Error(Fault::usage, source.name,
                    "there is no page " + std::to_string(page) + ", but pages 1 to " + std::to_string(pages));
    if (wish.page == 0 && pages > 1)
        notes.push_back("this is page 1 of " + std::to_string(pages) + "; " + spelled("page") + " 2 is the next");
    if (!wish.as_picture) {
        const PdfText text = pdf_text(source, page);
        const auto svg = pdf_page_as_svg(source, page, text);
        if (is_text(text, svg ? drawn_in(*svg) : 1))
            throw Error(Fault::failed, source.name,
                        "page " + std::to_string(page) + " is text, " + std::to_string(text.count()) +
                            " words, and would be felt as rubble; lay it out in braille with " + spelled("text") +
                            ", or draw a part of it with " + spelled("filter") + " \"crop ...\"");
        if (svg) return kept(*svg, source.name);
    }
    return kept(pdf_page_as_png(source, page), source.name);
}

}  // namespace tactics
