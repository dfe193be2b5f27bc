// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/open_input.h"

#include <algorithm>
#include <cerrno>
#include <optional>
#include <string_view>
#include <system_error>

#include "tactics/error.h"
#include "tactics/job/figure.h"
#include "tactics/job/holds.h"
#include "tactics/job/written.h"
#include "tactics/readers/gzip.h"
#include "tactics/readers/own_pdf.h"
#include "tactics/readers/svg/cairo_glyphs.h"
#include "tactics/readers/svg/pdf.h"
#include "tactics/readers/xml.h"
#include "tactics/transport/temporary_file.h"

namespace tactics {

namespace {

// As a file that is gone when it is closed.
Source kept(const std::string& bytes, const std::string& name) {
    Source source{name, temporary_file()};
    std::FILE* file = source.file.get();
    if (file == nullptr || std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size() || std::fflush(file) != 0)
        throw Error(Fault::failed, name,
                    phrase("cannot be kept in a temporary file: {0}; {1}", std::generic_category().message(errno),
                           temporary_file_cure()));
    std::rewind(file);
    return source;
}

// The pages of a PDF that we wrote are read as they were, without a program that reads PDF.
struct OwnPages {
    std::string bytes = {};
    std::optional<std::vector<std::string_view>> svgs = {};  // parts of the bytes
};

// The whole of a file is read only if its end is one of ours.
bool ends_as_ours(std::FILE* file) {
    std::string end(kOwnPdfEnd, '\0');
    if (std::fseek(file, 0, SEEK_END) != 0) return false;
    const long size = std::ftell(file);
    const bool found = size > 0 && std::fseek(file, std::max(0L, size - static_cast<long>(end.size())), SEEK_SET) == 0;
    end.resize(found ? std::fread(end.data(), 1, end.size(), file) : 0);
    std::rewind(file);
    return may_be_own_pdf(end);
}

OwnPages own_pages_in(const Source& pdf) {
    if (!ends_as_ours(pdf.file.get())) return {};
    OwnPages own{bytes_of(pdf.file.get())};
    std::rewind(pdf.file.get());
    own.svgs = own_pdf_pages(own.bytes);
    return own;
}

}  // namespace

PdfPageWish page_wish(const Wishes& wishes) { return {wishes.page, wishes.recipe || asks_for_a_way(wishes.chain)}; }

Source open_input(const std::string& path, const PdfPageWish& wish, std::vector<Phrase>& notes) {
    return page_of_input(open_source(path), path, wish, notes);
}

int pages_of_any_pdf(const Source& pdf) {
    const OwnPages own = own_pages_in(pdf);
    return own.svgs ? static_cast<int>(own.svgs->size()) : pages_of_pdf(pdf);
}

bool is_own_pdf(Source& source) { return look_at(source) == Holds::pdf && own_pages_in(source).svgs.has_value(); }

Source page_of_input(Source source, const std::string& path, const PdfPageWish& wish, std::vector<Phrase>& notes) {
    if (look_at(source) != Holds::pdf) {
        if (wish.page > 0) throw Error(Fault::usage, spelled("page"), phrase("{0} is no PDF; leave it out", path));
        return source;
    }
    const OwnPages own = own_pages_in(source);
    const int pages = own.svgs ? static_cast<int>(own.svgs->size()) : pages_of_pdf(source), page = std::max(1, wish.page);
    if (page > pages)
        throw Error(Fault::usage, source.name,
                    phrase("there is no page {0}, but pages 1 to {1}", std::to_string(page), std::to_string(pages)));
    if (wish.page == 0 && pages > 1)
        notes.push_back(phrase("this is page 1 of {0}; {1} 2 is the next", std::to_string(pages), spelled("page")));
    if (own.svgs && !wish.as_picture)
        return kept(inflated((*own.svgs)[static_cast<std::size_t>(page) - 1], kMostXmlBytes + 1, source.name), source.name);
    if (!wish.as_picture) {
        const PdfText text = pdf_text(source, page);
        const auto svg = pdf_page_as_svg(source, page, text);
        if (is_text(text, svg ? drawn_in(*svg) : 1))
            throw Error(Fault::failed, source.name,
                        phrase("page {0} is text, {1} words, and would be felt as rubble; lay it out in braille with {2}, or "
                               "draw a part of it with {3} \"crop ...\"",
                               std::to_string(page), std::to_string(text.count()), spelled("text"), spelled("filter")));
        if (svg) return kept(*svg, source.name);
    }
    return kept(pdf_page_as_png(source, page), source.name);
}

}  // namespace tactics
