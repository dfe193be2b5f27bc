// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/cups_filter.h"

#include <fcntl.h>
#include <sys/auxv.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "cli/interrupt.h"
#include "cli/report/say.h"
#include "cli/verbs/ppd.h"
#include "cli/verbs/print_job.h"
#include "cli/verbs/print_options.h"
#include "tactics/error.h"
#include "tactics/transport/lesser_rights.h"

namespace tactics {

namespace {

std::string text_of(const std::string& path) {
    std::ifstream file(path);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file) throw Error(Fault::failed, path, phrase("cannot be read; set the queue up again with a PPD file of tactics ppd"));
    return text;
}

// Becomes standard input, for whom this process will be may not be let open it.
void open_job(const std::string& path) {
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY);
    if (file < 0) open_source(path);  // which says why
    if (file < 0 || dup2(file, STDIN_FILENO) < 0) throw Error(Fault::failed, path, phrase("cannot be read"));
    if (file != STDIN_FILENO) close(file);
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
        fix_print_surroundings();
        if (words.size() == 6) open_job(words[5]);
        take_lesser_rights();
        const Queue queue = queue_of(parse_ppd(ppd_text), ppd, parse_cups_options(words[4]), words[2]);
        // With a file the filter makes the copies, else what comes after it (filter(7)).
        PrintJob wish;
        if (words.size() == 6) wish.copies = copies_of(words[3]);
        const Interrupt interrupt([] {});
        Source job = open_source("-");
        if (words.size() == 6) job.name = words[5];
        emboss_print_job(std::move(job), queue, wish);
        return 0;
    } catch (const std::exception& error) {
        say("ERROR: " + std::string(error.what()));
        return 1;
    }
}

}  // namespace tactics
