// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/vrml/lexer.h"

#include <charconv>
#include <optional>
#include <utility>

#include "tactics/error.h"
#include "tactics/text/number.h"

namespace tactics {

namespace {

// Whole numbers may be in hexadecimal, as those of images are.
std::optional<double> number_of(std::string_view text) {
    if (text.size() > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X')) {
        std::uint32_t value = 0;
        const auto [end, fault] = std::from_chars(text.data() + 2, text.data() + text.size(), value, 16);
        if (fault == std::errc() && end == text.data() + text.size()) return value;
        return std::nullopt;
    }
    return parse_number(text);
}

bool may_begin_number(char c) { return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.'; }

}  // namespace

WorldLexer::WorldLexer(std::string_view bytes, bool masks, std::string file)
    : bytes_(bytes), masks_(masks), file_(std::move(file)) {}

void WorldLexer::fail(int line, const Phrase& why) const { throw Error(Fault::failed, file_ + ":" + std::to_string(line), why); }

const WorldToken& WorldLexer::peek() {
    if (!peeked_) ahead_ = read();
    peeked_ = true;
    return ahead_;
}

WorldToken WorldLexer::next() {
    const WorldToken token = peek();
    peeked_ = false;
    return token;
}

// Commas are blanks. A line ends with LF, CR or both.
void WorldLexer::skip_blanks() {
    bool comment = false;
    for (; at_ < bytes_.size(); ++at_) {
        const char c = bytes_[at_];
        const bool ends = c == '\n' || (c == '\r' && (at_ + 1 == bytes_.size() || bytes_[at_ + 1] != '\n'));
        if (ends) {
            ++line_;
            comment = false;
        } else if (c == '#') {
            comment = true;
        } else if (!comment && c != ',' && static_cast<unsigned char>(c) > ' ') {
            return;
        }
    }
}

bool WorldLexer::ends_word(char c) const {
    if (static_cast<unsigned char>(c) <= ' ') return true;
    constexpr std::string_view kEnds = "{}[]\",#", kMasks = "()|";
    return kEnds.find(c) != std::string_view::npos || (masks_ && kMasks.find(c) != std::string_view::npos);
}

WorldToken WorldLexer::read() {
    skip_blanks();
    WorldToken token;
    token.line = line_;
    if (at_ == bytes_.size()) return token;
    if (bytes_[at_] == '"') return read_text();
    const std::size_t first = at_++;
    if (ends_word(bytes_[first])) {
        token.kind = WorldToken::Kind::mark;
        token.text = bytes_.substr(first, 1);
        return token;
    }
    while (at_ < bytes_.size() && !ends_word(bytes_[at_])) ++at_;
    token.text = bytes_.substr(first, at_ - first);
    token.kind = WorldToken::Kind::word;
    if (!may_begin_number(token.text[0])) return token;
    if (const auto number = number_of(token.text)) {
        token.kind = WorldToken::Kind::number;
        token.number = *number;
    }
    return token;
}

WorldToken WorldLexer::read_text() {
    WorldToken token;
    token.kind = WorldToken::Kind::text;
    token.line = line_;
    const std::size_t first = ++at_;
    for (; at_ < bytes_.size() && bytes_[at_] != '"'; ++at_) {
        if (bytes_[at_] == '\n') ++line_;
        if (bytes_[at_] == '\\' && at_ + 1 < bytes_.size()) {
            ++at_;
            if (bytes_[at_] == '\n') ++line_;
        }
    }
    if (at_ == bytes_.size())
        fail(token.line, phrase("a text begins with \" here and never ends; get a complete copy of the file"));
    token.text = bytes_.substr(first, at_++ - first);
    return token;
}

std::string unquoted(std::string_view text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\' && i + 1 < text.size()) ++i;
        plain += text[i];
    }
    return plain;
}

}  // namespace tactics
