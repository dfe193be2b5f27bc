// SPDX-License-Identifier: Apache-2.0
// Machines that are sent lines of cells.
#include <string>

#include "print/machines/machines.h"
#include "print/machines/sheet_feed.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr unsigned char kEsc = 0x1b;

// CR, LF, FF and letters; a machine's other commands are tried first: `special` returns how many bytes it used.
template <typename Special>
Punched punch_text(std::string_view bytes, CellHead head, Special special) {
    SheetFeed feed(head);
    std::size_t at = 0;
    while (at < bytes.size()) {
        feed.at(at);
        if (const std::size_t taken = special(bytes.substr(at), at, feed); taken > 0) {
            at += taken;
            continue;
        }
        const auto c = static_cast<unsigned char>(bytes[at]);
        if (c == 0x1a) {
            feed.end_job(++at);
            continue;
        }
        if (c == '\r')
            feed.carriage_return();
        else if (c == '\n')
            feed.line_feed();
        else if (c == '\f')
            feed.form_feed(at + 1);
        else if (const auto cell = cell_of_letter(c))
            feed.set_cell(*cell);
        else
            feed.note(at, phrase("a byte that is no letter of braille"));
        ++at;
    }
    return feed.finish(bytes.size());
}

// ESC and a command followed by that many letters; unlisted commands are reported.
struct Command {
    char letter;
    std::size_t more;
};

template <std::size_t kCount>
std::size_t skip_command(std::string_view rest, std::size_t at, SheetFeed& feed, const Command (&commands)[kCount]) {
    if (static_cast<unsigned char>(rest[0]) != kEsc) return 0;
    for (const Command& command : commands)
        if (rest.size() >= 2 + command.more && rest[1] == command.letter) {
            feed.set_up(at + 2 + command.more);
            return 2 + command.more;
        }
    feed.note(at, phrase("an ESC command that is not known here"));
    return std::min<std::size_t>(2, rest.size());
}

}  // namespace

Punched punch_generic(std::string_view bytes, const Settings& settings) {
    const CellHead head{{settings.number("left"), settings.number("top")},
                        settings.number("dot"),
                        settings.number("cell"),
                        settings.number("line")};
    const bool eight = settings.choice("dots") == "8";
    return punch_text(bytes, head, [eight](std::string_view rest, std::size_t, SheetFeed& feed) -> std::size_t {
        if (!eight) return 0;
        std::string_view after = rest;
        const char32_t letter = take_letter(after);
        if (letter < 0x2800 || letter > 0x28FF) return 0;
        feed.set_cell(static_cast<std::uint8_t>(letter - 0x2800));
        return rest.size() - after.size();
    });
}

// After the last line of a page, whose number the job gives, it feeds automatically. Its commands are letters or control bytes.
Punched punch_enabling(std::string_view bytes, const Settings& settings) {
    const bool nls = settings.choice("cell") == "nls";
    const CellHead head = nls ? CellHead{{6.72, 6.72}, 2.34, 6.096, 10.16} : CellHead{{6.8, 6.8}, 2.5, 6, 10};
    int lines = 0, line = 0;
    return punch_text(bytes, head, [=](std::string_view rest, std::size_t at, SheetFeed& feed) mutable -> std::size_t {
        static constexpr Command kCommands[] = {{'A', 2},  {'K', 1},  {'W', 1},  {'i', 1},  {'s', 1},  {'L', 1},
                                                {'R', 1},  {'T', 1},  {'Q', 1},  {0x00, 0}, {0x01, 2}, {0x0b, 1},
                                                {0x0c, 1}, {0x0f, 1}, {0x11, 1}, {0x12, 1}, {0x14, 1}, {0x17, 1},
                                                {0x23, 1}, {0x29, 1}, {0x33, 1}, {0x34, 1}};
        if (static_cast<unsigned char>(rest[0]) == kEsc) {
            if (rest.size() >= 3 && (rest[1] == 'Q' || rest[1] == 0x11))
                lines = static_cast<unsigned char>(rest[2]) - (rest[1] == 'Q' ? 0x40 : 0);
            return skip_command(rest, at, feed, kCommands);
        }
        if (rest[0] == '\f') line = 0;
        if (rest[0] != '\n' || lines <= 0 || ++line < lines) return 0;
        line = 0;
        feed.form_feed(at + 1);
        return 1;
    });
}

// A form feed on a page that nothing was sent for feeds nothing.
Punched punch_braillo(std::string_view bytes, const Settings& settings) {
    const bool now = settings.choice("firmware") == "17", sides = settings.choice("firmware") != "11";
    bool untouched = true;
    return punch_text(
        bytes, {{6.8, 6.8}, 2.5, 6.03, 10}, [=](std::string_view rest, std::size_t at, SheetFeed& feed) mutable -> std::size_t {
            static constexpr Command kNow[] = {{'S', 1}, {'C', 1}, {'J', 1}, {'A', 2}, {'B', 2}, {'H', 1}, {'N', 1}, {'R', 1}};
            static constexpr Command kWithSides[] = {{'E', 0}, {'S', 1}, {'6', 0}, {0x1f, 1}, {0x1e, 1}, {'A', 0}, {'Q', 1}};
            static constexpr Command kFirst[] = {{'E', 0}, {'6', 0}, {0x1f, 1}, {0x1e, 1}, {'A', 0}};
            if (static_cast<unsigned char>(rest[0]) == kEsc)
                return now     ? skip_command(rest, at, feed, kNow)
                       : sides ? skip_command(rest, at, feed, kWithSides)
                               : skip_command(rest, at, feed, kFirst);
            const bool feeds_nothing = rest[0] == '\f' && untouched;
            untouched = rest[0] == '\f';
            if (!feeds_nothing) return 0;
            feed.note(at, phrase("a form feed on an empty page, which is not taken"));
            return 1;
        });
}

// In transparent mode all bytes are cells, and ESC begins everything else.
Punched punch_cidat(std::string_view bytes, const Settings&) {
    bool transparent = false;
    return punch_text(
        bytes, {{6.8, 6.8}, 2.5, 6.35, 10.16},
        [&transparent](std::string_view rest, std::size_t at, SheetFeed& feed) -> std::size_t {
            const auto c = static_cast<unsigned char>(rest[0]);
            if (c != kEsc) {
                if (!transparent) return 0;
                if (c > 0x3F) feed.note(at, phrase("a byte that is no cell of 6 dots"));
                feed.set_cell(c & 0x3F);
                return 1;
            }
            const char command = rest.size() > 1 ? rest[1] : '\0';
            // Two capitals, digits, LF; one of them alone may be a command of its own.
            const auto is_capital = [&](std::size_t i) { return i < rest.size() && rest[i] >= 'A' && rest[i] <= 'Z'; };
            if (const auto end = rest.find('\n'); is_capital(1) && is_capital(2) && end != std::string_view::npos && end <= 10) {
                feed.set_up(at + end + 1);
                return end + 1;
            }
            switch (command) {
                case 0x1b: feed.set_cell(0x1b); return 2;
                case '\n': feed.line_feed(); return 2;
                case '\f': feed.form_feed(at + 2); return 2;
                case 'T':
                    transparent = false;
                    feed.end_job(at + 2);
                    return 2;
                case ')': transparent = true; [[fallthrough]];
                case '*':
                case '3':
                case 'P':
                case 'Q': feed.set_up(at + 2); return 2;
                case '.':
                case '/':
                case '0':
                case '1': {
                    const std::size_t taken = std::min<std::size_t>(3, rest.size());
                    feed.set_up(at + taken);
                    return taken;
                }
                default: break;
            }
            feed.note(at, phrase("an ESC command that is not known here"));
            return std::min<std::size_t>(2, rest.size());
        });
}

Punched punch_mountbatten(std::string_view bytes, const Settings&) {
    return punch_text(
        bytes, {{15.8, 15.8}, 2.5, 5.9, 10.1}, [](std::string_view rest, std::size_t at, SheetFeed& feed) -> std::size_t {
            if (rest[0] != '{') return 0;
            const auto end = rest.find('}');
            if (end == std::string_view::npos) {
                feed.note(at, phrase("a command without its }"));
                return rest.size();
            }
            const std::string_view command = rest.substr(1, end - 1);
            if (command == "np")
                feed.line_feed();
            else if (command == "man" || command == "bc 1" || command == "lm 0" || command == "rm 0" || command == "tm 0")
                feed.set_up(at + end + 1);
            else
                feed.note(at, phrase("a command that is not known here"));
            return end + 1;
        });
}

// 01 00 00, pages with 0C between them, 03.
Punched punch_nippon(std::string_view bytes, const Settings&) {
    SheetFeed feed({{6.8, 6.8}, 2.5, 6, 10});
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    std::size_t at = 0;
    bool in_job = false;
    while (at < bytes.size()) {
        feed.at(at);
        const std::string_view rest = bytes.substr(at);
        if (!in_job) {
            in_job = rest.starts_with(std::string_view("\x01\0\0", 3));
            if (!in_job) break;
            feed.set_up(at += 3);
            continue;
        }
        if (byte(at) == 3) {
            feed.end_job(++at);
            in_job = false;
            continue;
        }
        if (rest.size() < 3 || byte(at) != 2 || byte(at + 1) != 1) break;
        feed.begin();
        unsigned lines = byte(at + 2);
        for (at += 3; lines > 0 && at < bytes.size(); --lines) {
            const std::size_t length = byte(at);  // of the following bytes
            if (length < 2 || bytes.size() - at < length + 1 || bytes.substr(at + length - 1, 2) != "\r\n") {
                feed.note(at, phrase("a line that is not as long as it says"));
                return feed.finish(bytes.size());
            }
            for (std::size_t i = 1; i + 2 <= length; ++i) feed.set_cell(cell_of_letter(byte(at + i)).value_or(0));
            feed.line_feed();
            at += length + 1;
        }
        if (lines > 0) feed.note(at, phrase("a page that has fewer lines than it says"));
        if (at < bytes.size() && byte(at) == '\f') ++at;  // goes with the page before it
        feed.form_feed(at);
    }
    if (at < bytes.size())
        feed.note(at, in_job ? phrase("a page begins with 02h 01h and its lines, a job ends with 03h")
                             : phrase("a job begins with 01h 00h 00h"));
    else if (in_job)
        feed.note(at, phrase("the job is not ended with 03h"));
    return feed.finish(bytes.size());
}

}  // namespace tactics
