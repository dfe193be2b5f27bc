// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/form_font.h"

#include <algorithm>

namespace tactics {

namespace {

constexpr char32_t kFirstJoined = 0x110000;  // beyond Unicode

}  // namespace

const FontShapes& FormFont::shapes() {
    if (more_) shapes_.merge(std::exchange(more_, {})());
    return shapes_;
}

const FontShape* FormFont::shape_of(char32_t code) {
    if (!shapes_.contains(code)) shapes();
    const auto found = shapes_.find(code);
    return found == shapes_.end() ? nullptr : &found->second;
}

const LetterForm& FormFont::form(char32_t code) {
    const auto found = forms_.find(code);
    if (found != forms_.end()) return found->second;
    const FontShape* shape = shape_of(code);
    return forms_[code] = shape ? LetterForm(*shape) : LetterForm();
}

const LetterForm& FormFont::drawn(char32_t code) {
    form(code);
    LetterForm& form = forms_[code];
    if (form.empty() || form.drawn()) return form;
    form.draw(code >= kFirstJoined ? joined_[code - kFirstJoined].shape : shapes_.at(code));
    return form;
}

char32_t FormFont::join(std::u32string_view letters) {
    const auto known = std::find_if(joined_.begin(), joined_.end(), [&](const Joined& one) { return one.letters == letters; });
    const char32_t code = kFirstJoined + static_cast<char32_t>(known - joined_.begin());
    if (known != joined_.end()) return code;
    FontShape shape;
    for (const char32_t letter : letters) {
        const FontShape* own = shape_of(letter);
        if (!own) return 0;
        for (std::vector<Point> ring : own->rings) {
            for (Point& p : ring) p.x += shape.advance;
            shape.rings.push_back(std::move(ring));
        }
        shape.advance += own->advance;
    }
    forms_[code] = LetterForm(shape);
    joined_.push_back({std::u32string(letters), std::move(shape)});
    return code;
}

std::u32string_view FormFont::joined(char32_t code) const {
    const bool is = code >= kFirstJoined && code - kFirstJoined < joined_.size();
    return is ? std::u32string_view(joined_[code - kFirstJoined].letters) : std::u32string_view();
}

const std::vector<char32_t>& letters_of_figures() {
    static const std::vector<char32_t> letters = [] {
        std::vector<char32_t> codes;
        for (char32_t code = 0x21; code <= 0x7E; ++code)
            if (code != '`' && code != '~') codes.push_back(code);
        for (char32_t code = 0xC0; code <= 0xFF; ++code) codes.push_back(code);
        for (const char32_t code :
             U"\u00b0\u00b1\u00b2\u00b3\u00b9\u00bd\u00bc\u00be\u20ac\u00a3\u00a7\u2212\u2032\u2033\u2026"
             U"\u2264\u2265\u2248\u2260\u221e\u221a\u2211\u2202\u2220\u2030\u2190\u2192\u2080\u2081\u2082\u2083\u2084"
             U"\u03b1\u03b2\u03b3\u03b4\u03b5\u03b6\u03b7\u03b8\u03bb\u03bc\u03be\u03c0\u03c1\u03c3\u03c4"
             U"\u03c6\u03c8\u03c9\u0393\u0394\u0398\u039b\u039e\u03a0\u03a3\u03a6\u03a8\u03a9")
            if (code != 0) codes.push_back(code);
        return codes;
    }();
    return letters;
}

}  // namespace tactics
