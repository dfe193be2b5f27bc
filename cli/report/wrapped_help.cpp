// SPDX-License-Identifier: Apache-2.0
#include "cli/report/wrapped_help.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "cli/report/say.h"
#include "cli/report/user_language.h"
#include "tactics/text/utf8.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr std::size_t kNarrowest = 20;  // a word and what it is set in by; a terminal that says less knows nothing
constexpr std::size_t kGoesOn = 4;

std::size_t letters_in(std::string_view text) {
    std::size_t letters = 0;
    for (; !text.empty(); ++letters) take_letter(text);
    return letters;
}

// A paragraph continues at the left; an entry, "name: what it is" or an indented line, continues indented.
std::size_t goes_on_at(std::string_view line, std::size_t indent) {
    return indent > 0 || line.substr(0, line.find(' ')).ends_with(':') ? indent + kGoesOn : 0;
}

void wrap_line(std::string& out, std::string_view line, std::size_t width) {
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    const std::string more(goes_on_at(line, indent), ' ');
    std::size_t at = indent;
    bool begins = true;  // nothing but blanks is in the line
    out += line.substr(0, indent);
    for (std::string_view rest = line.substr(indent); !rest.empty();) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        const std::string_view word = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        const std::size_t letters = letters_in(word);
        if (!begins && at + 1 + letters > width) {
            out.append("\n").append(more);
            at = more.size();
        } else if (!begins) {
            out += ' ';
            ++at;
        }
        out += word;
        at += letters;
        begins = false;
    }
    out += '\n';
}

// 0: it is none, or does not know.
std::size_t terminal_width() {
    if (isatty(STDOUT_FILENO) != 1) return 0;
    const char* columns = std::getenv("COLUMNS");
    const auto said = parse_number(columns == nullptr ? "" : columns);
    if (said && *said >= 1 && *said <= 10'000) return static_cast<std::size_t>(*said);
    winsize size{};
    return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

}  // namespace

std::string wrapped_help(std::string_view text, std::size_t width) {
    std::string out;
    // Lines of examples, whose heading is in the language of the page.
    const auto heads_examples = [](std::string_view line) {
        return line == "Examples:" || line == "Example:" || line == phrase("Examples:").in(user_language()) ||
               line == phrase("Example:").in(user_language());
    };
    bool typed = false;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        typed = heads_examples(line) || (typed && line.starts_with(' '));
        if (typed || line.starts_with("Example: "))
            out.append(line).append("\n");
        else
            wrap_line(out, line, width);
    }
    return out;
}

void print_help(std::string_view text) {
    const std::size_t width = terminal_width();
    print_out(width < kNarrowest ? std::string(text) : wrapped_help(text, width));
}

}  // namespace tactics
