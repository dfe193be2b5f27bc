// SPDX-License-Identifier: Apache-2.0
// Words of the classic syntax that VRML97 (ISO/IEC 14772-1, annex A), VRML 1.0, Open Inventor's text and X3D (ISO/IEC 19776-2)
// share.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "tactics/text/phrase.h"

namespace tactics {

struct WorldToken {
    enum class Kind : std::uint8_t { end, word, number, text, mark };
    Kind kind = Kind::end;
    std::string_view text;  ///< view into the bytes; for a string, the raw text between its quotes
    double number = 0;
    int line = 1;

    bool is(char mark) const { return kind == Kind::mark && text[0] == mark; }
    bool is_word(std::string_view word) const { return kind == Kind::word && text == word; }
};

/// More lenient than the standards: a name may begin with a digit and have points in it, as many writers have it.
class WorldLexer {
public:
    /// `bytes` must outlive it. `masks`: "(", "|" and ")" stand for themselves, as in VRML 1.0. `file`: for messages.
    WorldLexer(std::string_view bytes, bool masks, std::string file);

    const WorldToken& peek();
    WorldToken next();  ///< at the end it keeps returning the end token

    [[noreturn]] void fail(int line, const Phrase& why) const;

private:
    WorldToken read();
    WorldToken read_text();
    void skip_blanks();
    bool ends_word(char c) const;

    std::string_view bytes_;
    bool masks_;
    std::string file_;
    std::size_t at_ = 0;
    int line_ = 1;
    WorldToken ahead_;
    bool peeked_ = false;
};

/// With its escapes resolved.
std::string unquoted(std::string_view text);

}  // namespace tactics
