// SPDX-License-Identifier: Apache-2.0
// `tactics similar`: which drawing there is already of what is wanted.
#include <algorithm>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/chain.h"
#include "cli/command.h"
#include "cli/page_flags.h"
#include "cli/report/progress.h"
#include "cli/report/say.h"
#include "cli/report/user_language.h"
#include "cli/request.h"
#include "tactics/error.h"
#include "tactics/information/likeness.h"
#include "tactics/job/disk.h"
#include "tactics/job/holds.h"
#include "tactics/job/open_input.h"
#include "tactics/job/scene_of_file.h"
#include "tactics/job/workers.h"
#include "tactics/text/json.h"
#include "tactics/text/table.h"
#include "tactics/text/words.h"
#include "tactics/units.h"

namespace tactics {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 100000;
constexpr int kUsualCount = 10, kMostCount = 1000;

constexpr Flag kSimilarFlags[] = {
    {"--count", "-n", "N", "how many to list, the nearest first; default: 10", false, "5 10 20"},
    {"--any-way-up", "", "", "also compare the figure turned by quarters and as a mirror image", false, ""},
    kRecipeFlag,
    kFilterFlag,
    {"--set", "-s", "NAME.OPTION=VALUE", "change a setting in every step of a filter. May be given several times", true,
     "settings"},
    kDetailFlag,
    kPdfPageFlag,
    kAllowFlag,
    {"--quiet", "-q", "", "no progress, and no report of files that could not be compared", false, ""},
    {"--json", "", "", "one JSON object per line, the nearest first", false, ""},
};

struct SimilarPlan {
    std::string figure;
    std::vector<std::string> files;  ///< to compare
    std::vector<Phrase> faults;      ///< of files that cannot be compared
    Wishes drawing;
    std::size_t count = kUsualCount;
    bool any_way_up = false;
};

// Those below it, in the order of their names. Hidden ones are somebody else's.
void add_files(SimilarPlan& plan, const std::string& folder) {
    std::error_code fault;
    std::vector<std::string> files, folders;
    for (fs::directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault)) {
        if (at->path().filename().string().starts_with('.')) continue;
        std::error_code unknown;
        if (at->is_regular_file(unknown)) files.push_back(at->path().string());
        if (at->is_directory(unknown) && !at->is_symlink(unknown)) folders.push_back(at->path().string());
    }
    if (fault) plan.faults.push_back(phrase("{0}: {1}", folder, phrase("this folder cannot be read: {0}", fault.message())));
    std::sort(files.begin(), files.end());
    std::sort(folders.begin(), folders.end());
    plan.files.insert(plan.files.end(), files.begin(), files.end());
    if (plan.files.size() > kMostFiles)
        throw Error(Fault::usage, folder,
                    phrase("these are more than {0} files; name a part of them", std::to_string(kMostFiles)));
    for (const std::string& inner : folders) add_files(plan, inner);
}

SimilarPlan plan_similar(const Given& given) {
    if (given.words.size() < 2)
        throw Error(
            Fault::usage, "similar",
            phrase("name a figure, and the folder or the files to look in; for example: tactics similar heart.png drawings/"));
    const Disk disk = real_disk();
    SimilarPlan plan;
    plan.figure = given.words[0];
    if (given.has("--count")) {
        const auto count = parse_number(given.value("--count"));
        if (!count || *count < 1 || *count > kMostCount || *count != static_cast<int>(*count))
            throw Error(Fault::usage, "--count", phrase("it is a whole number from 1 to {0}", std::to_string(kMostCount)));
        plan.count = static_cast<std::size_t>(*count);
    }
    plan.any_way_up = given.has("--any-way-up");
    plan.drawing.chain = read_chain(given, disk);
    if (plan.drawing.chain.base) plan.drawing.recipe = finish(plan.drawing.chain, *plan.drawing.chain.base);
    plan.drawing.page = page_value(given);
    plan.drawing.allowed = allowed_formats(given);
    for (std::size_t i = 1; i < given.words.size(); ++i) {
        if (disk.is_folder(given.words[i]))
            add_files(plan, given.words[i]);
        else
            plan.files.push_back(given.words[i]);
    }
    std::set<std::string> known;
    if (plan.figure != "-") known.insert(disk.identity(plan.figure));
    std::erase_if(plan.files, [&](const std::string& file) { return !known.insert(disk.identity(file)).second; });
    if (plan.files.empty() && !plan.faults.empty()) throw Error(Fault::failed, "", plan.faults.front());
    if (plan.files.empty()) throw Error(Fault::failed, given.words[1], phrase("there is no other file to compare it with"));
    return plan;
}

// The page option applies to PDFs, whatever else is in the folder.
Look look_of_file(const std::string& path, Wishes wishes) {
    Source source = open_source(path);
    source.allowed = wishes.allowed;
    if (look_at(source) != Holds::pdf) wishes.page = 0;
    return look_of(drawing_of_file(std::move(source), path, wishes).grid, path);
}

struct Compared {
    std::string file;
    Likeness likeness;
};

struct Comparisons {
    std::vector<Compared> all;  ///< the nearest first
    std::vector<Phrase> faults;
};

Comparisons compare_all(const SimilarPlan& plan, const Look& figure, bool quiet) {
    std::vector<std::optional<Likeness>> found(plan.files.size());
    std::vector<Failure> failures(plan.files.size());
    Progress progress(plan.files.size(), quiet ? ProgressWay::none : ProgressWay::automatic);
    std::mutex telling;
    std::size_t done = 0;
    share_out(plan.files.size(), 0, [&](std::size_t i) {
        failures[i] = failure_of(
            plan.files[i], [&] { found[i] = likeness(figure, look_of_file(plan.files[i], plan.drawing), plan.any_way_up); });
        const std::lock_guard lock(telling);
        progress.show(++done);
    });
    progress.clear();
    Comparisons comparisons{{}, plan.faults};
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i]) comparisons.all.push_back({plan.files[i], *found[i]});
        if (!failures[i].text.empty()) comparisons.faults.push_back(failures[i].text);
    }
    std::stable_sort(comparisons.all.begin(), comparisons.all.end(),
                     [](const Compared& a, const Compared& b) { return a.likeness.share > b.likeness.share; });
    return comparisons;
}

Phrase words_of_similar(const Alignment& alignment) {
    constexpr SourceWords kTurns[] = {"as it is", "turned a quarter", "upside down", "turned three quarters"};
    const Phrase turned = phrase(kTurns[alignment.quarter_turns]);
    if (!alignment.mirrored) return turned;
    return alignment.quarter_turns > 0 ? phrase("mirrored, {0}", turned) : phrase("mirrored");
}

std::string json_of_similar(const Compared& one) {
    JsonAnswer json;
    json.add("file", one.file);
    json.add("share", one.likeness.share);
    json.add("mutual_bits_a_cell", one.likeness.mutual);
    json.add("turned_degrees", 90.0 * one.likeness.alignment.quarter_turns);
    json.add_raw("mirrored", one.likeness.alignment.mirrored ? "true" : "false");
    json.add("scale", one.likeness.alignment.scale);
    return json.text();
}

std::string similar_told(const std::vector<Compared>& nearest, bool any_way_up) {
    const auto said = [](const Phrase& words) { return words.in(user_language()); };
    std::vector<Row> rows = {{said(phrase("shared")), said(phrase("file"))}};
    if (any_way_up) rows.front().insert(rows.front().begin() + 1, said(phrase("lies")));
    for (const Compared& one : nearest) {
        Row row = {percent(one.likeness.share), one.file};
        if (any_way_up) row.insert(row.begin() + 1, said(words_of_similar(one.likeness.alignment)));
        rows.push_back(std::move(row));
    }
    return aligned(std::move(rows));
}

int run_similar(const Given& given) {
    const SimilarPlan plan = plan_similar(given);
    const bool json = given.has("--json"), quiet = given.has("--quiet");
    const Look figure = look_of_file(plan.figure, plan.drawing);
    Comparisons comparisons = compare_all(plan, figure, quiet || json);
    if (!quiet && !comparisons.faults.empty()) {
        say(phrase("{0} could not be compared:", std::to_string(comparisons.faults.size())));
        for (const Phrase& fault : comparisons.faults) say("  " + fault.in(user_language()));
    }
    if (comparisons.all.empty()) throw Error(Fault::failed, plan.figure, phrase("nothing could be compared with it"));
    comparisons.all.resize(std::min(comparisons.all.size(), plan.count));
    if (json)
        for (const Compared& one : comparisons.all) print_out(json_of_similar(one) + "\n");
    else
        print_out(similar_told(comparisons.all, plan.any_way_up));
    return 0;
}

}  // namespace

extern const Command similar_command;
const Command similar_command{
    .name = "similar",
    .summary = "find the drawings in a folder that are most like a figure, to reuse one",
    .words = "FIGURE FOLDER|FILE...",
    .details =
        "Each file, whatever it holds, is drawn as convert would draw it on a bare page. Two drawings are compared regardless "
        "of their position and size on their pages. The result is the share of the figure's own bits that the other drawing "
        "gives, from the mutual information of where their lines are near. 100 % is the same drawing; drawings of different "
        "things share some 5 to 20 %. Folders are searched with their subfolders, except for hidden files. Files that cannot be "
        "drawn are named and left out.",
    .example =
        "tactics similar heart.png drawings/\n"
        "tactics similar map.svg atlas/ more/*.svg --any-way-up --count 5\n"
        "tactics similar photo.jpg drawings/ --recipe photo --json",
    .flags = kSimilarFlags,
    .offers = "files",
    .run = run_similar,
};

}  // namespace tactics
