// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/holds.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "tactics/readers/cell.h"
#include "tactics/readers/model.h"
#include "tactics/text/words.h"

namespace tactics {

namespace {

bool is_markup(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    // UTF-16 begins with a mark, and a letter below 80h has a byte 0.
    if (text.starts_with("\xff\xfe<") || text.substr(0, 4) == std::string_view("\xfe\xff\0<", 4)) return true;
    const auto begin = text.find_first_not_of(" \t\r\n");
    return begin != std::string_view::npos && text[begin] == '<';
}

bool has_control(std::string_view text) {
    return std::any_of(text.begin(), text.end(),
                       [](unsigned char c) { return (c < ' ' && c != '\t' && c != '\r' && c != '\n') || c == 0x7f; });
}

// An array of numbers, arrays or objects, or an object of arrays. glTF and its like are objects of arrays of objects.
bool is_json_table(std::string_view text) {
    constexpr std::string_view kBetween = " \t\r\n";
    const auto next = [&] {
        const auto at = std::min(text.find_first_not_of(kBetween), text.size());
        text.remove_prefix(at);
        return text.empty() ? '\0' : text.front();
    };
    const auto is_value = [](char c) { return (c >= '0' && c <= '9') || c == '-' || c == 'n' || c == 'N'; };
    for (const std::string_view model : {"\"asset\"", "\"extensionsUsed\"", "\"extensionsRequired\""})
        if (text.find(model) != std::string_view::npos) return false;
    const char first = next();
    text.remove_prefix(std::min<std::size_t>(1, text.size()));
    if (first == '[') return next() == '[' || text.starts_with('{') || is_value(next());
    if (first != '{' || next() != '"') return false;
    // What is said of the whole may stand before the first column.
    for (auto array = text.find('['); array != std::string_view::npos; array = text.find('[', array + 1)) {
        if (text.substr(0, array).find_last_not_of(kBetween) == std::string_view::npos) return false;
        if (text[text.substr(0, array).find_last_not_of(kBetween)] != ':') continue;
        text.remove_prefix(array + 1);
        return is_value(next()) || text.starts_with('[') || text.starts_with('"');
    }
    return false;
}

// Lines of numbers between blanks, below a line of names and comments perhaps, as gnuplot and R write them.
bool is_blank_table(std::string_view text) {
    std::size_t columns = 0, rows = 0, lines = 0;
    while (true) {
        const auto end = text.find('\n');
        if (end == std::string_view::npos) break;  // it may be cut
        auto cells = words_of(text.substr(0, end));
        text.remove_prefix(end + 1);
        if (cells.empty() || cells.front().starts_with('#')) continue;
        for (auto& cell : cells)  // R has its row names in quotes
            if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
        const bool numbers = std::all_of(cells.begin(), cells.end(), [](auto cell) { return is_number(cell) || is_gap(cell); });
        if (++lines > 1 && (!numbers || (columns != 0 && cells.size() != columns))) return false;
        if (!numbers) continue;
        columns = cells.size();
        ++rows;
    }
    return rows >= 2 && columns >= 2;
}

bool is_named_table(std::string_view file) { return file.ends_with(".csv") || file.ends_with(".tsv"); }

// A line of names and nothing below it: the file's own name says that it is one, or a mark between names, without a blank or
// what stands in an address.
bool is_line_of_names(std::string_view text, std::string_view file) {
    const auto begin = text.find_first_not_of(" \t\r\n"), last = text.find_last_not_of(" \t\r\n");
    const std::string_view line = text.substr(begin, last + 1 - begin);
    if (line.find('\n') != std::string_view::npos) return false;
    if (is_named_table(file)) return true;
    const auto is_mark = [](char c) { return c == ',' || c == ';' || c == '\t'; };
    return std::any_of(line.begin(), line.end(), is_mark) && !is_mark(line.back()) &&
           line.find_first_of(" :/") == std::string_view::npos;
}

// A line of names with something between them, and numbers below it, which the file's name may promise, too; or the line alone.
// Of what it lacks the reader of tables says so.
bool is_table(std::string_view text, std::string_view file) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    const auto begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos || has_control(text)) return false;
    if (text[begin] == '{' || text[begin] == '[') return is_json_table(text);
    if (is_line_of_names(text, file)) return true;
    const auto end = text.find('\n');
    if (end == std::string_view::npos) return false;
    const std::string_view first = text.substr(0, end), rest = text.substr(end + 1), second = rest.substr(0, rest.find('\n'));
    const auto parts = [&](char separator) {
        return first.find(separator) != std::string_view::npos && second.find(separator) != std::string_view::npos;
    };
    const bool promises = is_named_table(file) || rest.find_first_of("0123456789") != std::string_view::npos;
    if ((parts(',') || parts(';') || parts('\t')) && promises) return true;
    return is_blank_table(text);
}

}  // namespace

Holds look_at(Source& source) {
    if (source.file == nullptr) return Holds::picture;  // of no bytes, as its reader will say
    std::array<char, 1024> head{};
    std::rewind(source.file.get());
    const std::string_view text(head.data(), std::fread(head.data(), 1, head.size(), source.file.get()));
    std::rewind(source.file.get());
    if (text.starts_with("%PDF-")) return Holds::pdf;
    const std::string_view model = model_format(source);
    if (is_markup(text)) return model == "X3D model" || model == "COLLADA model" ? Holds::model : Holds::svg;
    if (!model.empty()) return Holds::model;
    const auto known = [&](const Reader* reader) {
        constexpr std::size_t kHead = 64;
        return reader->recognises({reinterpret_cast<const unsigned char*>(text.data()), std::min(text.size(), kHead)});
    };
    if (std::any_of(readers().begin(), readers().end(), known)) return Holds::picture;
    return is_table(text, source.name) ? Holds::table : Holds::picture;
}

}  // namespace tactics
