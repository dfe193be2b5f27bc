// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/print_job.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "cli/report/say.h"
#include "tactics/error.h"
#include "tactics/job/holds.h"
#include "tactics/job/make_pages.h"
#include "tactics/job/open_input.h"
#include "tactics/job/written.h"
#include "tactics/readers/svg/pdf.h"
#include "tactics/text/number.h"

namespace tactics {

namespace {

// CUPS shows the last of these beside the print job.
std::string_view step_words(JobStep step) {
    switch (step) {
        case JobStep::reading: return "reading";
        case JobStep::drawing: return "drawing";
        case JobStep::laying_out: return "laying out";
        case JobStep::writing: return "sending";
    }
    return "";
}

// The file of a source once more, from its beginning.
Source again(const Source& source) {
    Source copy = open_source("/dev/fd/" + std::to_string(fileno(source.file.get())));
    copy.name = source.name;
    return copy;
}

// Pages of a print job that are made together: one that is felt, or those of text one after the other.
struct Part {
    int first = 1, last = 1;
    bool text = false;        // laid out in braille
    bool as_picture = false;  // drawn from its pixels

    std::string name_among(int pages) const {
        return (last > first ? "pages " + std::to_string(first) + " to " + std::to_string(last)
                             : "page " + std::to_string(first)) +
               " of " + std::to_string(pages);
    }
};

struct PrintedPages {
    bool pdf = false;
    int first = 1, last = 1, all = 1;

    int count() const { return last - first + 1; }
};

PrintedPages pages_of(Source& source, const PrintJob& wish) {
    PrintedPages pages;
    pages.pdf = !wish.is_text && look_at(source) == Holds::pdf;
    if (!pages.pdf) return pages;
    pages.all = pages_of_any_pdf(source);
    pages.first = wish.first_page;
    pages.last = std::min(wish.last_page, pages.all);
    if (pages.count() < 1)
        throw Error(Fault::usage, "page-ranges",
                    phrase("the document has none of these pages; its last is page {0}", std::to_string(pages.all)));
    return pages;
}

// Text that has no braille table to be set in is drawn as it looks.
std::vector<Part> parts_of(const Source& source, const PrintedPages& pages, const PrintJob& wish, const Wishes& wishes) {
    if (wish.is_text) return {{1, 1, true, false}};
    std::vector<Part> parts;
    const bool as_picture = page_wish(wishes).as_picture, in_braille = !wishes.sheet.braille_table.empty();
    for (int page = pages.first; page <= pages.last; ++page) {
        const bool written = pages.pdf && !as_picture && is_page_of_text(source, page), text = written && in_braille;
        if (text && !parts.empty() && parts.back().text)
            parts.back().last = page;
        else
            parts.push_back({page, page, text, as_picture || (written && !in_braille)});
    }
    return parts;
}

// Gives how many sheets were made, after `sheets`.
std::size_t emboss_part(const Part& part, const Source& source, const PrintedPages& pages, Job job, std::size_t sheets) {
    const std::string name = part.name_among(pages.all);
    const Watch watch{.goes_on = [&](JobStep step) {
        say("INFO: " + std::string(step_words(step)) + " " + name);
        return true;
    }};
    std::vector<Phrase> notes;
    job.as_text = part.text;
    if (pages.pdf) {
        job.page = part.text ? part.first : 0;
        job.last_page = part.last;
    }
    job.first_number = sheets + 1;
    Source input = part.text ? again(source)
                             : page_of_input(again(source), source.name, {pages.pdf ? part.first : 0, part.as_picture}, notes);
    const Outcome outcome = make_pages(std::move(input), job, watch);
    for (const Note& note : outcome.notes) say("INFO: " + note.english());  // CUPS has a log of its own, in English
    if (!outcome.error.empty()) throw Error(outcome.fault, "", outcome.error);
    return outcome.layouts.front().pages;
}

}  // namespace

int copies_of(std::string_view word) { return static_cast<int>(std::clamp(parse_number(word).value_or(1), 1.0, 1000.0)); }

void fix_print_surroundings() {
    clearenv();
    setenv("PATH", "/usr/local/bin:/usr/bin:/bin", 1);
    setenv("LC_ALL", "C.UTF-8", 1);
}

void emboss_print_job(Source source, const Queue& queue, const PrintJob& wish) {
    const PrintedPages pages = pages_of(source, wish);
    Job job{{source.name, {{queue.embosser, "-", ""}}}, queue.wishes};
    if (pages.count() > 1 && !queue.labels.empty())
        throw Error(Fault::usage, "TacticsLabels",
                    phrase("labels are for a job of one page; print the page alone, or leave them out"));
    job.labels = queue.labels;
    const std::vector<Part> parts = parts_of(source, pages, wish, queue.wishes);
    std::size_t told = 0;
    for (int copy = 0; copy < wish.copies; ++copy) {
        std::size_t sheets = 0;  // of this copy
        for (const Part& part : parts) {
            const std::size_t made = emboss_part(part, source, pages, job, sheets);
            sheets += made;
            for (std::size_t i = 0; i < made; ++i) say("PAGE: " + std::to_string(++told) + " 1");
        }
    }
}

}  // namespace tactics
