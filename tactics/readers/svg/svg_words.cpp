// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg_words.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "tactics/readers/svg/plain_words.h"
#include "tactics/readers/svg/svg_numbers.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Of fonts for screens and print, in em: what a letter takes on average, and where the middle of capitals is.
constexpr double kLetterWidth = 0.55, kMiddle = 0.36, kCapital = 0.72;

struct Font {
    double size = 0;
    std::string anchor;
};

// The value of a property: from the attribute of its name, or from the style, which wins.
std::string property(const Element& element, std::string_view name) {
    std::string found(element.attribute(name));
    std::string_view style = element.attribute("style");
    while (!style.empty()) {
        const auto end = style.find(';');
        const std::string_view one = style.substr(0, end);
        style.remove_prefix(end == std::string_view::npos ? style.size() : end + 1);
        const auto colon = one.find(':');
        if (colon != std::string_view::npos && without_svg_blanks(one.substr(0, colon)) == name)
            found = without_svg_blanks(one.substr(colon + 1));
    }
    return found;
}

// "font: 10px 'DejaVu Sans'" has the size before the family.
std::string size_in(std::string_view font) {
    while (!font.empty()) {
        const auto blank = std::min(font.find_first_of(" /"), font.size());
        const std::string_view word = font.substr(0, blank);
        if (!word.empty() && ((word[0] >= '0' && word[0] <= '9') || word[0] == '.') && word.find_first_of("px%m") != word.npos)
            return std::string(word);
        font.remove_prefix(std::min(blank + 1, font.size()));
    }
    return {};
}

Font font_of(const Element& element, Font font) {
    std::string size = property(element, "font-size");
    if (size.empty()) size = size_in(property(element, "font"));
    if (!size.empty()) font.size = parse_font_size(size, font.size);
    if (std::string anchor = property(element, "text-anchor"); !anchor.empty()) font.anchor = std::move(anchor);
    return font;
}

// The style has what the element says itself; but the short "font" is not known there.
Font own_font(const Element& text, const Style& style) {
    const Font known{style.font_size, style.anchor};
    return property(text, "font-size").empty() ? font_of(text, known) : known;
}

// The first of a list of lengths, "0 6.4 12.8".
std::optional<double> first_of(const Element& element, std::string_view name) {
    std::string_view list = element.attribute(name);
    if (list.empty()) return std::nullopt;
    list = without_svg_blanks(list);
    return parse_svg_length(list.substr(0, list.find_first_of(" ,\t\n")), 0);
}

double letters_in(std::string_view text) {
    return static_cast<double>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

// A line of a text as it grows, in the text's own units.
struct Line {
    Point start;
    Font font;
    std::string text;
    double width = 0;
};

class Texts {
public:
    void read(const Element& element, const Font& font, Point at) {
        const auto x = first_of(element, "x"), y = first_of(element, "y"), dx = first_of(element, "dx"),
                   dy = first_of(element, "dy");
        Point place{x.value_or(at.x) + dx.value_or(0), y.value_or(at.y) + dy.value_or(0)};
        if (lines_.empty()) lines_.push_back({place, font, "", 0});
        if (lines_.size() == 1 && lines_[0].text.empty()) lines_[0] = {place, font, "", 0};
        const Line last = lines_.back();
        // Half a letter up or down is an exponent or an index, not another line.
        const bool moved = y || dy;
        const double down = place.y - last.start.y;
        const bool small = font.size < 0.95 * last.font.size;
        const bool beside = std::abs(down) < 0.6 * std::max(last.font.size, font.size);
        const bool power = moved && small && beside && down < -0.2 * last.font.size && !last.text.empty();
        if (moved && !beside && !last.text.empty()) lines_.push_back({place, font, "", 0});
        std::size_t from = 0;
        for (const Element& child : element.children) {
            add(std::string_view(element.text).substr(from, child.after - from), font, power);
            from = child.after;
            if (child.name == "tspan" || child.name == "textPath" || child.name == "a")
                read(child, font_of(child, font), lines_.back().start);
        }
        add(std::string_view(element.text).substr(from), font, power);
    }

    std::vector<Line> lines_;

private:
    void add(std::string_view text, const Font& font, bool power) {
        Line& line = lines_.back();
        if (line.text.empty() && without_svg_blanks(text).empty()) return;
        const std::string digits = power ? raised(without_svg_blanks(text)) : "";
        if (!digits.empty()) line.text = without_svg_blanks(line.text);  // line ends between elements
        line.text += digits.empty() ? std::string(text) : digits;
        line.width += letters_in(without_svg_blanks(text)) * kLetterWidth * font.size;
    }
};

}  // namespace

std::vector<FoundWords> words_of_text(const Element& text, const Transform& transform, const Style& style) {
    Texts texts;
    texts.read(text, own_font(text, style), {0, 0});
    std::vector<FoundWords> words;
    for (const Line& line : texts.lines_) {
        const std::string said = to_line(line.text);
        if (said.empty()) continue;
        const double left = line.font.anchor == "middle" ? -0.5 : line.font.anchor == "end" ? -1 : 0;
        const Point middle{line.start.x + (left + 0.5) * line.width, line.start.y - kMiddle * line.font.size};
        const bool upwards = std::abs(transform.b) > std::abs(transform.a);
        words.push_back(
            {said, transform(middle), kCapital * line.font.size * transform.scale(), upwards, line.width * transform.scale()});
    }
    return words;
}

std::string words_beside(const Element& element) {
    if (element.name != "g" && element.name != "path") return {};
    if (element.attribute("id").starts_with("text_") && !element.comment.empty())
        return to_line(without_markup(without_svg_blanks(element.comment)));
    // Vega and others say with the same attribute what a whole part of the figure is; they give it a role.
    if (!element.attribute("role").empty() || !element.attribute("aria-roledescription").empty()) return {};
    return to_line(element.attribute("aria-label"));
}

void say_right(std::vector<FoundWords>& words, std::size_t from, const std::string& right) {
    if (words.size() <= from) return;
    const auto letters = [](std::string text) {
        std::erase(text, ' ');
        return text;
    };
    std::string said;
    double left = 0, edge = 0, down = 0;
    for (std::size_t i = from; i < words.size(); ++i) {
        const FoundWords& one = words[i];
        said += one.text;
        left = i == from ? one.middle.x - one.width / 2 : std::min(left, one.middle.x - one.width / 2);
        edge = i == from ? one.middle.x + one.width / 2 : std::max(edge, one.middle.x + one.width / 2);
        down += one.middle.y / static_cast<double>(words.size() - from);
    }
    if (letters(said) == letters(right)) return;  // in two lines, maybe
    FoundWords& whole = words[from];
    whole.text = right;
    if (!whole.upwards) {
        whole.middle = {(left + edge) / 2, down};
        whole.width = edge - left;
    }
    words.resize(from + 1);
}

std::string title_of(const Element& root) {
    std::string title, about;
    for (const Element& child : root.children) {
        if (child.name == "title" && title.empty()) title = to_line(child.text);
        if (child.name == "desc" && about.empty()) about = to_line(child.text);
    }
    // Gnuplot's own name is no title: its desc says "Produced by GNUPLOT 5.4".
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    const std::string maker = "Produced by " + title;
    const bool tool =
        !title.empty() && about.size() >= maker.size() && std::equal(maker.begin(), maker.end(), about.begin(), same);
    return tool ? "" : title;
}

}  // namespace tactics
