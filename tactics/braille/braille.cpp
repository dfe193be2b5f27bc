// SPDX-License-Identifier: Apache-2.0
#include "tactics/braille/braille.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "tactics/braille/louis.h"
#include "tactics/error.h"
#include "tactics/text/utf8.h"
#include "tactics/transport/child.h"
#include "tactics/transport/program_folder.h"

namespace tactics {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestShownTable = 255;
constexpr std::size_t kMostCells = 4u << 20;  // of an answer: a hundred and more for each letter of the longest text
constexpr const char* kTables = TACTICS_LOUIS_TABLES;

bool is_file(const std::string& path) {
    std::error_code unknown;
    return fs::is_regular_file(path, unknown);
}

std::vector<std::string> parts_of(const std::string& text) {
    std::vector<std::string> parts(1);
    for (const char c : text)
        if (c == ',')
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

// Folders for users' own tables, which can be given by name (liblouis(7)).
std::vector<std::string> own_folders() {
    const char* folders = std::getenv("LOUIS_TABLEPATH");
    return folders == nullptr || *folders == '\0' ? std::vector<std::string>() : parts_of(folders);
}

struct FoundTable {
    LouisTable table;
    std::vector<std::string> folders;  // of files that did not come with liblouis; empty: all did
};

// A plain name means liblouis's own table, regardless of files in the current folder.
std::string path_of_table(const std::string& name) {
    if (name.empty()) return "";
    const bool named = name.find('/') == std::string::npos;
    if (named)
        for (const std::string& folder : own_folders())
            if (is_file(folder + "/" + name)) return fs::absolute(folder + "/" + name).string();
    if (named && is_file(kTables + ("/" + name))) return kTables + ("/" + name);
    return is_file(name) ? fs::absolute(name).string() : "";
}

FoundTable find_table(std::string_view name) {
    const std::string shown(name.substr(0, name.find('\0')));
    const FoundTable none{{"", shown}, {}};
    if (shown.size() > kLongestShownTable || shown.size() != name.size()) return none;
    FoundTable found = none;
    for (const std::string& part : parts_of(shown)) {
        const std::string path = path_of_table(part);
        if (path.empty() || path.find(',') != std::string::npos) return none;
        found.table.path += (found.table.path.empty() ? "" : ",") + path;
        std::error_code unknown;
        const fs::path own = fs::path(path).parent_path();
        if (own == kTables) continue;
        const fs::path true_one = fs::canonical(path, unknown).parent_path();
        if (true_one == fs::canonical(kTables, unknown)) continue;
        found.folders.insert(found.folders.end(), {own.string(), true_one.string()});
    }
    return found;
}

// The child's answer for such a table. A malicious table could control it.
std::vector<std::uint8_t> cells_of(const ChildAnswer& answer, const std::string& shown) {
    const std::string name = to_line(shown.substr(0, 80));
    using End = ChildAnswer::End;
    if (answer.end == End::missing || !answer.fault.empty())
        throw Error(Fault::failed, spelled("braille"),
                    phrase("a table of your own needs the programs tactics-louis and tactics-cage, which cannot be started; "
                           "install them beside tactics, or name a table of liblouis"));
    if (answer.end == End::too_long || answer.end == End::too_much)
        throw Error(Fault::usage, spelled("braille"),
                    phrase("\"{0}\" takes liblouis over 10 seconds or far too many cells; mend the table or take another", name));
    if (answer.end != End::done || answer.out.empty())
        throw Error(Fault::usage, spelled("braille"),
                    phrase("\"{0}\" breaks liblouis, as one does that includes itself; mend the table or take another", name));
    const std::string_view rest = std::string_view(answer.out).substr(1);
    if (answer.out[0] == 'c') return {rest.begin(), rest.end()};
    throw Error(answer.out[0] == 'f' ? Fault::failed : Fault::usage, "", to_line(rest.substr(0, 1000)));
}

std::vector<std::uint8_t> cells_in_cage(std::string_view utf8, FoundTable found, std::string_view text_place) {
    CagedChild child;
    child.words = {own_program("tactics-louis"), found.table.path, found.table.shown, std::string(text_place), spelled("")};
    child.input = utf8;
    child.limits = {std::chrono::seconds(10), kMostCells};
    child.memory = std::size_t{512} << 20;
    child.readable = std::move(found.folders);
    child.readable.push_back(kTables);
    for (std::string& folder : own_folders()) child.readable.push_back(std::move(folder));
    return cells_of(run_caged(child), found.table.shown);
}

// A page asks for the same words several times, to see where they have room, and a child for each would take longer than the
// page.
std::vector<std::uint8_t> cells_in_cage_once(std::string_view utf8, FoundTable found, std::string_view text_place) {
    constexpr std::size_t kMostKept = 10'000;
    static std::mutex guard;
    static std::map<std::pair<std::string, std::string>, std::vector<std::uint8_t>> kept;
    const std::pair key(found.table.path, std::string(utf8));
    {
        const std::lock_guard lock(guard);
        if (const auto known = kept.find(key); known != kept.end()) return known->second;
    }
    auto cells = cells_in_cage(utf8, std::move(found), text_place);
    const std::lock_guard lock(guard);
    if (kept.size() < kMostKept) kept.emplace(key, cells);
    return cells;
}

}  // namespace

std::vector<std::uint8_t> to_braille(std::string_view utf8, std::string_view table, std::string_view text_place) {
    FoundTable found = find_table(table);
    if (found.folders.empty()) return cells_by_louis(utf8, found.table, text_place);
    return cells_in_cage_once(utf8, std::move(found), text_place);
}

std::vector<std::string> braille_tables() {
    constexpr std::size_t kLongest = 40;  // of a choice in a PPD file (CUPS, ppd.h: PPD_MAX_NAME)
    std::vector<std::string> names = louis_tables();
    std::erase_if(names, [](const std::string& name) { return name.ends_with(".tbl") || name.size() > kLongest; });
    return names;
}

char brf_letter(std::uint8_t cell) {
    // Index = dots 1-6 as bits 0-5.
    constexpr std::string_view kLetters = " A1B'K2L@CIF/MSP\"E3H9O6R^DJG>NTQ,*5<-U8V.%[$+X!&;:4\\0Z7(_?W]#Y)=";
    static_assert(kLetters.size() == 64);
    return kLetters[cell & 0x3Fu];
}

}  // namespace tactics
