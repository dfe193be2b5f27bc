// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/holds.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "tactics/readers/model.h"

namespace tactics {

namespace {

bool is_markup(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    // UTF-16 begins with a mark, and a letter below 80h has a byte 0.
    if (text.starts_with("\xff\xfe<") || text.substr(0, 4) == std::string_view("\xfe\xff\0<", 4)) return true;
    const auto begin = text.find_first_not_of(" \t\r\n");
    return begin != std::string_view::npos && text[begin] == '<';
}

// A line of names with something between them, and numbers below it.
bool is_table(std::string_view text) {
    const auto begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos || text[begin] == '{' || text[begin] == '[') return false;
    const auto control = [](unsigned char c) { return (c < ' ' && c != '\t' && c != '\r' && c != '\n') || c == 0x7f; };
    if (std::any_of(text.begin(), text.end(), control)) return false;
    const auto end = text.find('\n');
    if (end == std::string_view::npos) return false;
    const std::string_view first = text.substr(0, end), rest = text.substr(end + 1), second = rest.substr(0, rest.find('\n'));
    const auto parts = [&](char separator) {
        return first.find(separator) != std::string_view::npos && second.find(separator) != std::string_view::npos;
    };
    return (parts(',') || parts(';') || parts('\t')) && rest.find_first_of("0123456789") != std::string_view::npos;
}

}  // namespace

Holds look_at(Source& source) {
    if (source.file == nullptr) return Holds::picture;  // of no bytes, as its reader will say
    std::array<char, 1024> head{};
    std::rewind(source.file.get());
    const std::string_view text(head.data(), std::fread(head.data(), 1, head.size(), source.file.get()));
    std::rewind(source.file.get());
    if (text.starts_with("%PDF-")) return Holds::pdf;
    if (is_markup(text)) return Holds::svg;
    const bool model = !model_format(source).empty();
    std::rewind(source.file.get());
    if (model) return Holds::model;
    const auto known = [&](const Reader* reader) {
        constexpr std::size_t kHead = 64;
        return reader->recognises({reinterpret_cast<const unsigned char*>(text.data()), std::min(text.size(), kHead)});
    };
    if (std::any_of(readers().begin(), readers().end(), known)) return Holds::picture;
    return is_table(text) ? Holds::table : Holds::picture;
}

}  // namespace tactics
