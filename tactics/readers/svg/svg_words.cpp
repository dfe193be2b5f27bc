// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg_words.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "tactics/readers/svg/plain_words.h"
#include "tactics/readers/svg/svg_numbers.h"
#include "tactics/readers/svg/svg_path.h"
#include "tactics/text/utf8.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// Of fonts for screens and print, in em: what a letter takes on average, and where the middle of capitals is.
constexpr double kLetterWidth = 0.55, kMiddle = 0.36, kCapital = 0.72;

// A length, or the first of a list of them: "0 6.4 12.8", "1.2em".
std::optional<double> take_length(std::string_view& list, double em) {
    list = without_svg_blanks(list);
    if (list.empty()) return std::nullopt;
    const auto end = std::min(list.find_first_of(" ,\t\n"), list.size());
    const std::string_view one = list.substr(0, end);
    list.remove_prefix(end);
    while (!list.empty() && (list.front() == ',' || is_svg_blank(list.front()))) list.remove_prefix(1);
    if (one.ends_with("em"))
        if (const auto times = parse_number(one.substr(0, one.size() - 2))) return *times * em;
    return parse_svg_length(one, 0);
}

std::optional<double> first_of(const Element& element, std::string_view name, double em) {
    std::string_view list = element.attribute(name);
    return take_length(list, em);
}

// The last of a list that places letter after letter.
std::optional<double> last_of(const Element& element, std::string_view name, double em) {
    std::string_view list = element.attribute(name);
    std::optional<double> last;
    std::size_t count = 0;
    while (const auto one = take_length(list, em)) {
        last = one;
        ++count;
    }
    return count > 1 ? last : std::nullopt;
}

// A line of a text as it grows, in the text's own units.
struct Line {
    Point start;
    double size = 0;  // of its letters
    std::string anchor;
    std::string text;
    double width = 0;
    std::optional<Point> along = {};  // a path: what it begins with goes that way there
    bool exact = true;                // its width is known, from its fonts
};

class Texts {
public:
    explicit Texts(const TextNeeds& needs) : needs_(needs) {}

    void read(const Element& element, const Style& style) {
        const double em = style.font_size;
        const auto x = first_of(element, "x", em), y = first_of(element, "y", em), dx = first_of(element, "dx", em),
                   dy = first_of(element, "dy", em);
        const Point before = pen_;
        pen_ = {x.value_or(pen_.x) + dx.value_or(0), y.value_or(pen_.y) + dy.value_or(0)};
        if (lines_.empty() || lines_.back().text.empty()) {
            if (lines_.empty()) lines_.emplace_back();
            lines_.back() = {pen_, em, style.anchor, ""};
        }
        const Line& last = lines_.back();
        // Half a letter up or down is an exponent or an index, not another line.
        const double down = pen_.y - last.start.y - rise_of(element, last.size), high = std::max(last.size, em);
        const bool small = em < 0.95 * last.size, beside = std::abs(down) < 0.6 * high;
        const bool power = small && beside && down < -0.2 * last.size && !last.text.empty();
        if (!last.text.empty() && (!beside || (x && parts(last, *x - before.x, high, style)))) {
            lines_.push_back({pen_, em, style.anchor, ""});
        } else if (x && !last.text.empty() && !power && *x - before.x > (last.exact ? kSpaceOfFont : kBlank) * high &&
                   *x != last.start.x) {
            lines_.back().text += ' ';
        }
        if (element.name == "textPath") follow(element, style);
        std::size_t from = 0;
        for (const Element& child : element.children) {
            add(std::string_view(element.text).substr(from, child.after - from), style, power);
            from = child.after;
            if (child.name != "tspan" && child.name != "textPath" && child.name != "a" && child.name != "tref") continue;
            const Style own = needs_.style_of(child, style);
            if (own.shown) read(child, own);
        }
        add(std::string_view(element.text).substr(from), style, power);
        if (const auto end = last_of(element, "x", em)) {
            lines_.back().width = std::max(lines_.back().width, *end + kLetterWidth * em - lines_.back().start.x);
            lines_.back().exact = false;
            pen_.x = *end + kLetterWidth * em;
        }
    }

    std::vector<Line> lines_;

private:
    // In em: a gap of a space, and one that no line of words has. How wide words are is a guess, unless their font is known: then
    // kerning moves letters by a tenth, and spaces are a fifth at least.
    static constexpr double kBlank = 0.25, kApart = 1.5, kGuess = 0.35, kSpaceOfFont = 0.16;

    // Goes on at another place, as the names of a row do.
    static bool parts(const Line& last, double gap, double size, const Style& style) {
        if (last.exact) return std::abs(gap) > kApart * size;
        if (style.anchor != "start" && std::abs(gap) > kBlank * size + kGuess * last.width) return true;
        return gap > kApart * size + kGuess * last.width || gap < -kApart * size - kGuess * last.width;
    }

    // Up, as baseline-shift says it.
    static double rise_of(const Element& element, double size) {
        std::string_view shift = element.attribute("baseline-shift");
        const std::string_view css = element.attribute("style"), name = "baseline-shift:";
        if (const auto at = css.find(name); at != css.npos) {
            shift = css.substr(at + name.size());
            shift = without_svg_blanks(shift.substr(0, shift.find(';')));
        }
        if (shift == "super") return 0.4 * size;
        if (shift == "sub") return -0.2 * size;
        if (shift.ends_with('%')) return parse_number(shift.substr(0, shift.size() - 1)).value_or(0) / 100 * size;
        return shift.empty() ? 0 : parse_svg_length(shift, 0).value_or(0);
    }

    void add(std::string_view text, const Style& style, bool power) {
        Line& line = lines_.back();
        const std::string_view letters = without_svg_blanks(text);
        if (line.text.empty() && letters.empty()) return;
        const std::string digits = power ? raised(letters) : "";
        if (!digits.empty()) line.text = without_svg_blanks(line.text);  // line ends between elements
        line.text += digits.empty() ? std::string(text) : digits;
        const auto known = width_of(letters, style);
        line.exact = line.exact && known;
        const double width = known.value_or(static_cast<double>(letters_in(letters)) * kLetterWidth * style.font_size);
        pen_.x += width;
        line.width = line.exact ? pen_.x - line.start.x : line.width + width;
    }

    // By a font of the file, if that has all letters.
    std::optional<double> width_of(std::string_view text, const Style& style) const {
        const LetterWidths& widths = needs_.widths(style.font_family);
        if (!widths) return std::nullopt;
        double sum = 0;
        while (!text.empty()) {
            const auto own = widths(take_letter(text));
            if (!own) return std::nullopt;
            sum += *own * style.font_size;
        }
        return sum;
    }

    // Along a path the line is at the place where its middle comes to stand.
    void follow(const Element& element, const Style& style) {
        std::string_view name = element.attribute("href");
        const Element* path = name.starts_with('#') ? needs_.element(name.substr(1)) : nullptr;
        if (path == nullptr || path->name != "path") return;
        Transform own;
        if (const auto text = path->attribute("transform"); !text.empty() && !parse_transform(text, own)) return;
        Pen pen(own);
        if (draw_path(path->attribute("d"), pen)) return;
        std::vector<Point> points;
        for (const Subpath& part : pen.finish()) points.insert(points.end(), part.points.begin(), part.points.end());
        double length = 0;
        for (std::size_t i = 1; i < points.size(); ++i) length += distance(points[i - 1], points[i]);
        if (!(length > 0)) return;
        const double width =
            static_cast<double>(letters_in(without_svg_blanks(all_text(element)))) * kLetterWidth * style.font_size;
        const double share = style.anchor == "middle" ? 0 : style.anchor == "end" ? -0.5 : 0.5;
        const double at = parse_svg_length(element.attribute("startOffset"), length).value_or(0) + share * width;
        double left = std::clamp(at, 0.0, length);
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Point a = points[i - 1], b = points[i];
            const double step = distance(a, b);
            if (step == 0 || (left > step && i + 1 < points.size())) {
                left -= step;
                continue;
            }
            const double t = std::min(1.0, left / step);
            Line& line = lines_.back();
            line.start = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
            line.along = Point{(b.x - a.x) / step, (b.y - a.y) / step};
            return;
        }
    }

    static std::string all_text(const Element& element) {
        std::string text = element.text;
        for (const Element& child : element.children) text += all_text(child);
        return text;
    }

    const TextNeeds& needs_;
    Point pen_;
};

}  // namespace

std::vector<FoundWords> words_of_text(const Element& text, const Transform& transform, const Style& style,
                                      const TextNeeds& needs) {
    Texts texts(needs);
    texts.read(text, style);
    std::vector<FoundWords> words;
    for (const Line& line : texts.lines_) {
        const std::string said = to_line(line.text);
        if (said.empty()) continue;
        const double left = line.anchor == "middle" ? -0.5 : line.anchor == "end" ? -1 : 0;
        const Point way = line.along.value_or(Point{1, 0});
        const double before = line.along ? 0 : (left + 0.5) * line.width, up = kMiddle * line.size;
        const Point middle{line.start.x + before * way.x + up * way.y, line.start.y + before * way.y - up * way.x};
        const Point on_page{transform.a * way.x + transform.c * way.y, transform.b * way.x + transform.d * way.y};
        words.push_back({said, transform(middle), kCapital * line.size * transform.scale(),
                         std::abs(on_page.y) > std::abs(on_page.x), line.width * transform.scale()});
        words.back().centred = !line.along && line.anchor == "middle";
        if (line.exact && !line.along && line.anchor == "start")
            words.back().run = TextRun{transform(line.start), transform({line.start.x + line.width, line.start.y}),
                                       line.size * transform.scale()};
    }
    return words;
}

void add_words(std::vector<FoundWords>& all, std::vector<FoundWords> more) {
    constexpr std::size_t kLast = 16;  // words to look back
    constexpr double kThere = 0.3;     // heights
    for (FoundWords& words : more) {
        const std::size_t from = all.size() - std::min(all.size(), kLast);
        const bool twice = std::any_of(all.begin() + static_cast<std::ptrdiff_t>(from), all.end(), [&](const FoundWords& other) {
            return other.text == words.text && distance(other.middle, words.middle) < kThere * words.height;
        });
        if (!twice) all.push_back(std::move(words));
    }
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

FoundWords words_in_box(std::string words, const Rect& box, std::string_view comment) {
    const bool upwards = box.height > 1.5 * box.width && words.size() > 2;
    const auto lines = 1.0 + static_cast<double>(std::count(comment.begin(), comment.end(), '\n'));
    return {std::move(words), box.middle(), (upwards ? box.width : box.height) / lines, upwards,
            upwards ? box.height : box.width};
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
