// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/cups_filter.h"

#include <fcntl.h>
#include <sys/auxv.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "cli/interrupt.h"
#include "cli/report/say.h"
#include "cli/verbs/ppd.h"
#include "cli/verbs/print_options.h"
#include "tactics/error.h"
#include "tactics/job/holds.h"
#include "tactics/job/make_pages.h"
#include "tactics/job/open_input.h"
#include "tactics/job/written.h"
#include "tactics/readers/svg/pdf.h"
#include "tactics/transport/lesser_rights.h"
#include "tactics/units.h"

namespace tactics {

namespace {

std::string text_of(const std::string& path) {
    std::ifstream file(path);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file) throw Error(Fault::failed, path, phrase("cannot be read; set the queue up again with a PPD file of tactics ppd"));
    return text;
}

// Nothing of what is about the print job decides which programs are run and where files are kept.
void fix_surroundings() {
    clearenv();
    setenv("PATH", "/usr/local/bin:/usr/bin:/bin", 1);
    setenv("LC_ALL", "C.UTF-8", 1);
}

// Becomes standard input, for whom this process will be may not be let open it.
void open_job(const std::string& path) {
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY);
    if (file < 0) open_source(path);  // which says why
    if (file < 0 || dup2(file, STDIN_FILENO) < 0) throw Error(Fault::failed, path, phrase("cannot be read"));
    if (file != STDIN_FILENO) close(file);
}

// CUPS shows the last of these beside the print job.
std::string_view words_of(JobStep step) {
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

// Text that has no braille table to be set in is drawn as it looks.
std::vector<Part> parts_of(const Source& source, bool pdf, int pages, const Wishes& wishes) {
    std::vector<Part> parts;
    const bool as_picture = page_wish(wishes).as_picture, in_braille = !wishes.sheet.braille_table.empty();
    for (int page = 1; page <= pages; ++page) {
        const bool written = pdf && !as_picture && is_page_of_text(source, page), text = written && in_braille;
        if (text && !parts.empty() && parts.back().text)
            parts.back().last = page;
        else
            parts.push_back({page, page, text, as_picture || (written && !in_braille)});
    }
    return parts;
}

// Gives how many sheets were made, after `sheets`.
std::size_t emboss_part(const Part& part, const Source& source, bool pdf, Job job, std::size_t sheets, const std::string& name) {
    const Watch watch{.goes_on = [&](JobStep step) {
        say("INFO: " + std::string(words_of(step)) + " " + name);
        return true;
    }};
    std::vector<Phrase> notes;
    job.as_text = part.text;
    job.page = part.text ? part.first : 0;
    job.last_page = part.last;
    job.first_number = sheets + 1;
    Source input =
        part.text ? again(source) : page_of_input(again(source), source.name, {pdf ? part.first : 0, part.as_picture}, notes);
    const Outcome outcome = make_pages(std::move(input), job, watch);
    for (const Note& note : outcome.notes) say("INFO: " + note.english());  // CUPS has a log of its own, in English
    if (!outcome.error.empty()) throw Error(outcome.fault, "", outcome.error);
    return outcome.layouts.front().pages;
}

int emboss_all(Source source, const Queue& queue, int copies) {
    const bool pdf = look_at(source) == Holds::pdf;
    const int pages = pdf ? pages_of_pdf(source) : 1;
    Job job{{source.name, {{queue.embosser, "-", ""}}}, queue.wishes};
    if (pages > 1 && !queue.labels.empty())
        throw Error(Fault::usage, "TacticsLabels",
                    phrase("labels are for a job of one page; print the page alone, or leave them out"));
    job.labels = queue.labels;
    const std::vector<Part> parts = parts_of(source, pdf, pages, queue.wishes);
    std::size_t told = 0;
    for (int copy = 0; copy < copies; ++copy) {
        std::size_t sheets = 0;  // of this copy
        for (const Part& part : parts) {
            const std::size_t made = emboss_part(part, source, pdf, job, sheets, part.name_among(pages));
            sheets += made;
            for (std::size_t i = 0; i < made; ++i) say("PAGE: " + std::to_string(++told) + " 1");
        }
    }
    return 0;
}

}  // namespace

bool is_started_as(std::string_view name) {
    const auto* path = reinterpret_cast<const char*>(getauxval(AT_EXECFN));
    return path != nullptr && std::filesystem::path(path).filename() == name;
}

int run_cups_filter(std::span<const std::string> words) {
    try {
        if (words.size() != 5 && words.size() != 6)
            throw Error(Fault::usage, std::string(kCupsFilterName),
                        phrase("is called by CUPS with job, user, title, copies, options and perhaps a file; to use it yourself: "
                               "tactics convert"));
        const char* named = std::getenv("PPD");
        if (named == nullptr)
            throw Error(Fault::failed, "PPD", phrase("CUPS names no PPD file; set the queue up with one of tactics ppd"));
        const std::string ppd = named, ppd_text = text_of(ppd);
        fix_surroundings();
        if (words.size() == 6) open_job(words[5]);
        take_lesser_rights();
        const Queue queue = queue_of(parse_ppd(ppd_text), ppd, words[4], words[2]);
        // With a file the filter makes the copies, else what comes after it (filter(7)).
        const int copies = words.size() == 6 ? static_cast<int>(std::clamp(parse_number(words[3]).value_or(1), 1.0, 1000.0)) : 1;
        const Interrupt interrupt([] {});
        Source job = open_source("-");
        if (words.size() == 6) job.name = words[5];
        return emboss_all(std::move(job), queue, copies);
    } catch (const std::exception& error) {
        say("ERROR: " + std::string(error.what()));
        return 1;
    }
}

}  // namespace tactics
