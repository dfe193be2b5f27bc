// SPDX-License-Identifier: Apache-2.0
#include "tactics/braille/louis.h"

#include <liblouis/liblouis.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>

#include "tactics/braille/tables.h"
#include "tactics/error.h"
#include "tactics/text/formula_letters.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

static_assert(sizeof(widechar) == 4, "liblouis must be built with 4-byte characters (--enable-ucs4), as Debian's is");

// One line of a page; longer text is a slip, and liblouis is not made for hostile sizes.
constexpr std::size_t kLongestText = 10'000;
// liblouis joins a table's name to its folder in a buffer of 4096 bytes without asking how long it is.
constexpr std::size_t kLongestTableName = 2000;

// liblouis keeps its compiled tables, its work buffers and its log callback in global variables without a lock, so two concurrent
// translations damage each other. A translation takes tens of microseconds, so one lock for all is enough.
std::mutex liblouis_lock;

// The callback gets no pointer of ours, so liblouis's complaints go through here; guarded by the lock above.
std::string* first_complaint = nullptr;

void take_log(logLevels level, const char* message) {
    if (level >= LOU_LOG_ERROR && first_complaint != nullptr && first_complaint->empty()) *first_complaint = message;
}

// liblouis 3.24 copies it and its own folder into 2048 bytes without counting (compileTranslationTable.c, getTablePath).
void check_search_path() {
    constexpr std::size_t kLongest = 1500;
    const char* folders = std::getenv("LOUIS_TABLEPATH");
    if (folders != nullptr && std::string_view(folders).size() > kLongest)
        throw Error(
            Fault::usage, "LOUIS_TABLEPATH",
            phrase("is longer than liblouis bears ({0} bytes); name fewer folders, or unset it", std::to_string(kLongest)));
}

// The lock, and liblouis speaking to us instead of the terminal.
class Session {
public:
    Session() : hold_(liblouis_lock) {
        check_search_path();
        first_complaint = &complaint_;
        lou_registerLogCallback(take_log);
    }
    ~Session() { first_complaint = nullptr; }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    const std::string& complaint() const { return complaint_; }

private:
    std::lock_guard<std::mutex> hold_;
    std::string complaint_;
};

// As one clean line: what is not seen has no cell, and liblouis ends the text at a NUL. Nothing if it is not UTF-8.
std::optional<std::vector<widechar>> decode(std::string_view utf8) {
    for (std::string_view rest = utf8; !rest.empty();)
        if (take_letter(rest) == kNoLetter) return std::nullopt;
    const std::string line = to_line(utf8);
    std::vector<widechar> text;
    text.reserve(line.size());
    for (std::string_view rest = line; !rest.empty();) text.push_back(static_cast<widechar>(take_letter(rest)));
    return text;
}

std::string printable(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
    return text;
}

// Lists the tables. liblouis itself would open every file in every folder of LOUIS_TABLEPATH for this.
Phrase table_advice(std::string_view table) {
    if (table.find("nemeth") != std::string_view::npos)
        return phrase(
            "; liblouis has Nemeth for MathML only, not for plain text; en-ueb-g1.ctb has signs for numbers and formulae");
    constexpr std::size_t kMost = 8;  // maximum listed for a language; few have more literary tables
    const std::vector<std::string> names = louis_tables();
    if (names.empty()) return phrase("; no tables are installed: apt-get install liblouis-data");
    std::vector<BrailleTable> fitting = tables_for(table, described_tables());
    if (fitting.size() > kMost) fitting.resize(kMost);
    std::string told;
    for (const BrailleTable& one : fitting) told += (told.empty() ? "" : ", ") + one.name + " (" + one.title + ")";
    if (!told.empty()) return phrase("; choose {0}, or another of tactics list braille", told);
    const std::vector<std::string_view> views(names.begin(), names.end());
    return phrase("{0}; see tactics list braille", did_you_mean(table, views));
}

// A complaint of liblouis may hold any bytes of the file, so only its line number is used.
std::string faulty_line(std::string_view complaint) {
    const auto end = complaint.find(": error: ");
    if (end == std::string_view::npos) return "";
    const auto start = complaint.substr(0, end).rfind(':') + 1;
    const std::string_view number = complaint.substr(start, end - start);
    const bool line = !number.empty() && number != "0" && number.find_first_not_of("0123456789") == std::string_view::npos;
    return line ? std::string(number) : "";
}

[[noreturn]] void refuse_table(const LouisTable& table, const std::string& complaint) {
    const std::string shown = printable(table.shown.substr(0, 80));
    // A name that cannot be found, or a file that is there but is no table.
    const bool missing = complaint.empty() || complaint.find("Cannot resolve") != std::string::npos;
    if (missing)
        throw Error(Fault::usage, spelled("braille"),
                    phrase("there is no braille table \"{0}\"{1}", shown, table_advice(table.shown)));
    const std::string line = faulty_line(complaint);
    throw Error(Fault::usage, spelled("braille"),
                line.empty()
                    ? phrase("\"{0}\" is no liblouis table{1}", shown, table_advice(""))
                    : phrase("\"{0}\" is no liblouis table (it does not understand line {1}){2}", shown, line, table_advice("")));
}

// As cells U+2800 + dots. Needs the session; an empty text is to liblouis a failure.
std::vector<widechar> translate(const LouisTable& table, const std::vector<widechar>& text, int mode, const Session& session) {
    std::vector<widechar> cells(text.size() * 4 + 64);
    for (;;) {
        int in = static_cast<int>(text.size());
        int out = static_cast<int>(cells.size());
        // dotsIO and ucBrl: dots as U+2800..U+28FF whatever characters the table is made to show them with.
        if (lou_translateString(table.path.c_str(), text.data(), &in, cells.data(), &out, nullptr, nullptr,
                                dotsIO | ucBrl | mode) == 0)
            refuse_table(table, session.complaint());
        // It stops where the room ends, and may still say that it took all of the text: half the room must be left.
        if (in == static_cast<int>(text.size()) && static_cast<std::size_t>(out) <= cells.size() / 2) {
            cells.resize(static_cast<std::size_t>(out));
            return cells;
        }
        // No table needs a hundred cells for a character.
        if (cells.size() > text.size() * 200 + 10'000)
            throw Error(Fault::failed, spelled("braille"),
                        phrase("table \"{0}\" cannot set this text; try another table", printable(table.shown)));
        cells.resize(cells.size() * 2);
    }
}

// A letter that the table lacks comes out as its hexadecimal number, which nobody can read. With the option to leave such letters
// out, liblouis outputs something else for them.
bool lacks_letters(const LouisTable& table, const std::vector<widechar>& text, const std::vector<widechar>& cells,
                   const Session& session) {
    return translate(table, text, noUndefined, session) != cells;
}

// The letters are tried alone: where the two translations part says less, as some tables join letters in several passes.
[[noreturn]] void refuse_letters(const LouisTable& table, const std::vector<widechar>& text, const Session& session,
                                 std::string_view text_place) {
    std::string missing = "all of the text";
    std::set<widechar> tried;
    for (const widechar letter : text) {
        const std::vector<widechar> alone{letter};
        if (!tried.insert(letter).second || !lacks_letters(table, alone, translate(table, alone, 0, session), session)) continue;
        std::string sign;
        append_letter(sign, letter);
        std::array<char, 16> number{};
        std::snprintf(number.data(), number.size(), "U+%04X", static_cast<unsigned>(letter));
        missing = "\"" + sign + "\" (" + number.data() + ")";
        break;
    }
    throw Error(
        Fault::usage, text_place,
        phrase(
            "braille table \"{0}\" has no cells for {1}; name a table that has them with {2}, or leave braille out with {2} none",
            printable(table.shown), missing, spelled("braille")));
}

}  // namespace

std::string louis_folder() { return TACTICS_LOUIS_TABLES; }

std::vector<std::string> louis_tables() {
    std::vector<std::string> names;
    std::error_code unknown;
    for (const auto& entry : std::filesystem::directory_iterator(TACTICS_LOUIS_TABLES, unknown)) {
        std::string name = entry.path().filename().string();
        if (name.ends_with(".ctb") || name.ends_with(".utb") || name.ends_with(".tbl")) names.push_back(std::move(name));
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<std::uint8_t> cells_by_louis(std::string_view utf8, const LouisTable& table, std::string_view text_place) {
    if (utf8.size() > kLongestText)
        throw Error(Fault::usage, text_place, phrase("the text is too long to be set in braille (over 10000 bytes); shorten it"));
    const auto text = decode(utf8);
    if (!text)
        throw Error(Fault::usage, text_place,
                    phrase("the text for braille is not UTF-8; convert it with iconv, or set a UTF-8 locale"));

    const Session session;
    // liblouis 3.24 crashes on an empty name.
    if (table.path.empty() || table.path.size() > kLongestTableName) refuse_table(table, "");
    if (lou_getTable(table.path.c_str()) == nullptr) refuse_table(table, session.complaint());

    if (text->empty()) return {};

    std::vector<widechar> cells = translate(table, *text, 0, session);
    if (lacks_letters(table, *text, cells, session)) {
        // Those of formulas, which have codes of their own for each look.
        std::vector<widechar> plain = *text;
        for (widechar& letter : plain) letter = static_cast<widechar>(plain_code(static_cast<char32_t>(letter)));
        cells = translate(table, plain, 0, session);
        if (lacks_letters(table, plain, cells, session)) refuse_letters(table, *text, session, text_place);
    }
    std::vector<std::uint8_t> dots;
    dots.reserve(cells.size());
    for (const widechar cell : cells) dots.push_back(static_cast<std::uint8_t>(cell & 0xFFu));
    return dots;
}

std::vector<bool> divisions_by_louis(std::string_view word, const std::string& table) {
    constexpr std::size_t kLongestWord = 99;  // liblouis 3.24 takes fewer than HYPHSTRING (100) letters
    const auto text = decode(word);
    if (!text || text->empty() || text->size() > kLongestWord) return {};
    const Session session;
    std::vector<char> marks(text->size() + 1, '0');
    if (lou_getTable(table.c_str()) == nullptr ||
        lou_hyphenate(table.c_str(), text->data(), static_cast<int>(text->size()), marks.data(), 0) == 0)
        return {};
    std::vector<bool> divided;
    for (std::size_t i = 0; i < text->size(); ++i) divided.push_back(marks[i] == '1');
    return divided;
}

}  // namespace tactics
