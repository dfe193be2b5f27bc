#include "tactics/braille.h"

#include <liblouis/liblouis.h>

#include <cstdlib>
#include <mutex>
#include <optional>

#include "tactics/error.h"
#include "tactics/utf8.h"

namespace tactics {

namespace {

static_assert(sizeof(widechar) == 4, "liblouis must be built with 4-byte characters (--enable-ucs4), as Debian's is");

// One line of a page; longer text is a slip, and liblouis is not made for hostile sizes.
constexpr std::size_t kLongestText = 10'000;
// liblouis joins a table's name to its folder in a buffer of 4096 bytes without asking how long it is.
constexpr std::size_t kLongestTableName = 255;

// liblouis keeps its compiled tables, its work buffers and its log callback in variables of its own, without a lock:
// two translations at once damage each other. A translation takes tens of microseconds, so one lock for all is enough.
std::mutex liblouis_lock;

// The callback gets no pointer of ours, so what liblouis complains of goes through here; held by the lock above.
std::string* first_complaint = nullptr;

void take_log(logLevels level, const char* message) {
    if (level >= LOU_LOG_ERROR && first_complaint != nullptr && first_complaint->empty()) *first_complaint = message;
}

// The lock, and liblouis speaking to us instead of the terminal.
class Session {
public:
    Session() : hold_(liblouis_lock) {
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

// Nothing if the text is not UTF-8.
std::optional<std::vector<widechar>> decode(std::string_view utf8) {
    std::vector<widechar> text;
    text.reserve(utf8.size());
    while (!utf8.empty()) {
        const char32_t letter = take_letter(utf8);
        if (letter == kNoLetter) return std::nullopt;
        // A control character has no cell, and liblouis ends the text at a NUL.
        const bool control = letter < 0x20 || (letter >= 0x7F && letter < 0xA0);
        text.push_back(static_cast<widechar>(control ? U' ' : letter));
    }
    return text;
}

std::string printable(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
    return text;
}

// Says which tables there are. Needs the lock; asking liblouis costs about 8 ms, and only on the way to an error.
std::string table_advice(std::string_view table) {
    char** paths = lou_listTables();
    std::vector<std::string> names;
    std::string folder;
    for (char** path = paths; path != nullptr && *path != nullptr; ++path) {
        const std::string_view text(*path);
        const auto slash = text.rfind('/');
        if (slash != std::string_view::npos && folder.empty()) folder = text.substr(0, slash);
        names.emplace_back(slash == std::string_view::npos ? text : text.substr(slash + 1));
        std::free(*path);
    }
    std::free(paths);
    if (names.empty()) return "; no tables are installed: apt-get install liblouis-data";
    const std::vector<std::string_view> views(names.begin(), names.end());
    return did_you_mean(table, views) + "; list them with: ls " + folder;
}

[[noreturn]] void refuse_table(const std::string& table, const std::string& complaint) {
    const std::string shown = printable(table.substr(0, 80));
    // A name that cannot be found, or a file that is there but is no table: liblouis says the line and what is wrong.
    const bool missing = complaint.empty() || complaint.find("Cannot resolve") != std::string::npos;
    if (missing) throw Error(Fault::usage, "--braille", "there is no braille table \"" + shown + "\"" + table_advice(table));
    throw Error(Fault::usage, "--braille",
                "\"" + shown + "\" is not a braille table that can be used: " + printable(complaint) + table_advice(""));
}

}  // namespace

std::vector<std::uint8_t> to_braille(std::string_view utf8, std::string_view table) {
    if (utf8.size() > kLongestText)
        throw Error(Fault::usage, "--title", "the text is too long to be set in braille (over 10000 bytes); shorten it");
    const auto text = decode(utf8);
    if (!text)
        throw Error(Fault::usage, "--title", "the text for braille is not UTF-8; convert it with iconv, or set a UTF-8 locale");

    const std::string name(table.substr(0, table.find('\0')));
    const Session session;
    // liblouis 3.24 crashes on an empty name.
    if (name.empty() || name.size() > kLongestTableName || name.size() != table.size()) refuse_table(name, "");
    if (lou_getTable(name.c_str()) == nullptr) refuse_table(name, session.complaint());

    if (text->empty()) return {};  // liblouis calls that a failure

    std::vector<widechar> cells(text->size() * 4 + 64);
    for (;;) {
        int in = static_cast<int>(text->size());
        int out = static_cast<int>(cells.size());
        // dotsIO and ucBrl: dots as U+2800..U+28FF whatever characters the table is made to show them with.
        if (lou_translateString(name.c_str(), text->data(), &in, cells.data(), &out, nullptr, nullptr, dotsIO | ucBrl) == 0)
            refuse_table(name, session.complaint());
        // It stops where the room ends, and may still say that it took all of the text: half the room must be left.
        if (in == static_cast<int>(text->size()) && static_cast<std::size_t>(out) <= cells.size() / 2) {
            cells.resize(static_cast<std::size_t>(out));
            break;
        }
        // No table needs a hundred cells for a character.
        if (cells.size() > text->size() * 200 + 10'000)
            throw Error(Fault::failed, "--braille",
                        "table \"" + printable(name) + "\" cannot set this text; try another table");
        cells.resize(cells.size() * 2);
    }
    std::vector<std::uint8_t> dots;
    dots.reserve(cells.size());
    for (const widechar cell : cells) dots.push_back(static_cast<std::uint8_t>(cell & 0xFFu));
    return dots;
}

char brf_letter(std::uint8_t cell) {
    // Index = dots 1-6 as bits 0-5.
    constexpr std::string_view kLetters = " A1B'K2L@CIF/MSP\"E3H9O6R^DJG>NTQ,*5<-U8V.%[$+X!&;:4\\0Z7(_?W]#Y)=";
    static_assert(kLetters.size() == 64);
    return kLetters[cell & 0x3Fu];
}

}  // namespace tactics
