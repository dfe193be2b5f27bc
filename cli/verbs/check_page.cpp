// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/check_page.h"

#include "print/format.h"
#include "tactics/error.h"
#include "tactics/job/figure.h"
#include "tactics/job/holds.h"
#include "tactics/job/make_pages.h"
#include "tactics/job/open_input.h"
#include "tactics/readers/svg/own_page.h"
#include "tactics/readers/svg/pdf.h"

namespace tactics {

namespace {

// The page as convert makes it, in the medium's own size and without a title; its braille comes from words in the picture.
FoundPage page_of_picture(Source source, const PageWish& wish) {
    Job job{{source.name, {{find_format("text"), "", ""}}}, {}};
    job.chain = wish.chain;
    job.table = wish.table;
    job.allowed = wish.allowed;
    job.sheet.medium = wish.medium;
    job.sheet.margin = wish.margin;
    job.paper = wish.paper ? *wish.paper : find_paper(has_fixed_dots(*wish.medium) ? "11x11.5" : "a4", "--paper");
    Outcome outcome = make_pages(std::move(source), job);
    if (!outcome.error.empty()) throw Error(outcome.fault, "", outcome.error);
    FoundPage found;
    found.page = std::move(outcome.layouts.front().shown.front());
    const bool drawn = !outcome.recipe.empty();
    found.notes.push_back(
        drawn
            ? phrase(
                  "this is a picture, checked as convert would draw it (recipe {0}, medium {1}); a page is checked as SVG or PDF",
                  outcome.recipe, wish.medium->name)
            : phrase("this is a {0}, checked as convert would draw it (medium {1}); a page is checked as SVG or PDF",
                     outcome.picture.format, wish.medium->name));
    for (const Note& note : outcome.notes) found.notes.push_back(note.words);
    const MendingTold& told = outcome.layouts.front().mended;
    for (const Phrase& note : {told.advice, told.doubt})
        if (!note.empty()) found.notes.push_back(note);
    if (found.page.picture) found.notes.push_back(phrase("a picture of pixels is looked at for its ink and beside braille only"));
    return found;
}

// Of a page that we wrote the lines themselves count, not the curves that are drawn for them.
FoundPage page_of_svg(Source& source, double margin, const PageWish& wish) {
    const std::string bytes = bytes_of(source.file.get());
    FoundPage found = read_svg(bytes, source.name, margin, wish.paper);
    if (auto own = read_own_page(bytes, source.name)) {
        if (wish.asks_medium || wish.asks_margin) own->page.live = found.page.live;
        found.page = std::move(own->page);
        for (const Phrase& note : own->notes) found.notes.push_back(note);
    }
    return found;
}

}  // namespace

const Medium& medium_of(const Page& page, const PageWish& wish) {
    if (!wish.asks_medium)
        for (const Medium& medium : media())
            if (medium.name == page.medium) return medium;
    return *wish.medium;
}

FoundPage page_of(const std::string& file, const PageWish& wish) {
    Source source = open_source(file);
    const double margin = wish.margin.value_or(wish.medium->margin);
    const Holds holds = look_at(source);
    if (wish.pdf_page > 0 && holds != Holds::pdf)
        throw Error(Fault::usage, "--page", phrase("{0} is no PDF; leave it out", source.name));
    const bool own = is_own_pdf(source);
    if (holds == Holds::pdf && !own && wish.pdf_page > 0) {
        const int pages = pages_of_pdf(source);
        if (wish.pdf_page > pages)
            throw Error(Fault::usage, source.name,
                        phrase("there is no page {0}, but pages 1 to {1}", std::to_string(wish.pdf_page), std::to_string(pages)));
    }
    if (holds != Holds::svg && holds != Holds::pdf) return page_of_picture(std::move(source), wish);
    std::vector<Phrase> notes;
    if (own) source = page_of_input(std::move(source), file, {wish.pdf_page}, notes);
    FoundPage found = holds == Holds::pdf && !own ? read_svg(pdf_as_svg(source, wish.pdf_page), source.name, margin, wish.paper)
                                                  : page_of_svg(source, margin, wish);
    found.notes.insert(found.notes.end(), notes.begin(), notes.end());
    if (wish.chain.as_drawn || asks_for_a_way(wish.chain))
        found.notes.push_back(
            phrase("it is a page already, so --recipe, --filter, --detail, --as-drawn and settings of filters do nothing to it"));
    return found;
}

}  // namespace tactics
