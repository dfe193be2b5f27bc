// SPDX-License-Identifier: Apache-2.0
// Numbers of an axis bear each other out: they grow in even steps, or by even factors, with their places.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "tactics/lettering/read_line.h"
#include "tactics/text/number.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// Settings: what print lies off its place, pixels, or heights of its letters, as a minus sign has white before it; share of a
// step; how many numbers make a progression, and of those that were read.
constexpr double kOffPlace = 2, kOffOfHeight = 0.4, kOffStep = 0.12, kMostRead = 0.67;
constexpr std::size_t kLeastRead = 3;

// With which sign figures have their thousands set apart; the other one is the decimal sign.
struct Style {
    char thousands, decimal;
};
constexpr Style kStyles[] = {{',', '.'}, {'.', ','}};

// The text as a number; its thousands, if they are set apart, are groups of three. Nothing: it is none.
std::optional<double> value_of(std::string_view text, const Style& style) {
    std::string plain;
    std::size_t group = 0;
    bool grouped = false, whole = true;
    while (!text.empty()) {
        const char32_t code = take_letter(text);
        if (plain.empty() && is_dash(code)) {
            plain += '-';
        } else if (is_digit(code)) {
            plain += static_cast<char>(code);
            ++group;
        } else if (whole && code == static_cast<char32_t>(style.thousands)) {
            if (group == 0 || group > 3 || (grouped && group != 3)) return std::nullopt;
            grouped = true;
            group = 0;
        } else if (whole && code == static_cast<char32_t>(style.decimal)) {
            if (group == 0 || (grouped && group != 3)) return std::nullopt;
            plain += '.';
            whole = false;
        } else {
            return std::nullopt;
        }
    }
    if (group == 0 || (whole && grouped && group != 3)) return std::nullopt;
    const std::string_view figures = std::string_view(plain).substr(plain[0] == '-' ? 1 : 0);
    if (figures.size() > 1 && figures[0] == '0' && figures[1] != '.') return std::nullopt;
    return parse_number(plain);
}

// What looks the same in a figure: a ring is a 0, a stroke a 1, and a comma a point with a tail. It has no spaces.
std::string as_figure(std::string_view text, bool swap_signs) {
    std::string out;
    while (!text.empty()) {
        char32_t code = take_letter(text);
        if (code == ' ') continue;
        if (code == 'o' || code == 'O')
            code = '0';
        else if (code == 'l' || code == 'I' || code == '|')
            code = '1';
        else if (swap_signs && (code == '.' || code == ','))
            code = code == '.' ? ',' : '.';
        append_letter(out, out.empty() && is_dash(code) ? char32_t{0x2212} : code);
    }
    return out;
}

struct Member {
    std::size_t line = 0;
    double place = 0;             // pixels along the axis
    std::optional<double> value;  // if it counts
};

// Pixels, of the tallest letter. In print that is larger two readers do not both say a wrong number, and one that is off the
// steps of others names something else: years that were left out. A setting.
constexpr int kMostTinyHeight = 9;

// Whether it is among those that may make a progression.
bool counts(const ReadLine& line) { return line.words.sure || line.nearly; }

// Values that grow by `step` for each `pitch` pixels, as they are or as their logarithms.
struct Progression {
    bool by_factors = false;
    double first = 0, step = 0;   // value at `place`, and what is added
    double place = 0, pitch = 0;  // pixels
    double off_place = kOffPlace;

    static std::optional<double> measure(double value, bool by_factors) {
        if (by_factors && value <= 0) return std::nullopt;
        return by_factors ? std::log10(value) : value;
    }
    // Of which step a place is; nothing: it lies between two.
    std::optional<double> number_at(double at) const {
        const double steps = (at - place) / pitch, whole = std::round(steps);
        const double off = std::abs(steps - whole);
        if (off > kOffStep || off * std::abs(pitch) > off_place) return std::nullopt;
        return whole;
    }
    bool holds(double at, double value) const {
        const auto number = number_at(at);
        const auto own = measure(value, by_factors);
        return number && own && std::abs(*own - first - *number * step) <= 1e-6 * std::abs(step);
    }
};

class Axis {
public:
    Axis(std::vector<ReadLine>& lines, std::vector<Member> members, const Style& style)
        : lines_(lines), members_(std::move(members)), style_(style) {
        for (Member& one : members_)
            if (counts(lines_[one.line])) one.value = value_of(lines_[one.line].words.text, style_);
        std::vector<double> gaps;
        for (std::size_t i = 1; i < members_.size(); ++i)
            if (const double gap = members_[i].place - members_[i - 1].place; gap > 0) gaps.push_back(gap);
        if (!members_.empty()) least_ = lines_[members_.front().line].line.letter_height;
        if (gaps.empty()) return;
        std::nth_element(gaps.begin(), gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2), gaps.end());
        pitch_ = gaps[gaps.size() / 2];
    }

    std::size_t read() const {
        return static_cast<std::size_t>(
            std::count_if(members_.begin(), members_.end(), [](const Member& one) { return one.value.has_value(); }));
    }

    // The progression that most numbers that were read are in, told by the two that are farthest apart, as their places are whole
    // pixels; `held` receives how many.
    std::optional<Progression> find(std::size_t& held) const {
        std::optional<Progression> best;
        double farthest = 0;
        held = 0;
        for (const bool by_factors : {false, true})
            for (std::size_t i = 0; i < members_.size(); ++i)
                for (std::size_t k = i + 1; k < members_.size(); ++k) {
                    const auto one = of_two(members_[i], members_[k], by_factors);
                    if (!one) continue;
                    const auto count =
                        static_cast<std::size_t>(std::count_if(members_.begin(), members_.end(), [&](const Member& member) {
                            return member.value && one->holds(member.place, *member.value);
                        }));
                    const double apart = members_[k].place - members_[i].place;
                    const auto in_best = [&](const Member& member) { return best->holds(member.place, *member.value); };
                    const bool surer = count == held && best && apart > farthest && in_best(members_[i]) && in_best(members_[k]);
                    if (count <= held && !surer) continue;
                    held = count;
                    farthest = apart;
                    best = one;
                }
        if (held == 2 && read() == 2 && bear_out(*best)) return best;
        const bool most = held >= kLeastRead && static_cast<double>(held) >= kMostRead * static_cast<double>(read());
        return most ? best : std::nullopt;
    }

    void apply(const Progression& progression) {
        for (const Member& one : members_) {
            ReadLine& line = lines_[one.line];
            if (!progression.number_at(one.place)) continue;
            if (line.words.sure) {
                const bool off = one.value && !progression.holds(one.place, *one.value);
                if (off && line.line.letter_height <= kMostTinyHeight) line.words.sure = false, line.tell = true;
                continue;
            }
            if (auto text = confirmed(line, one.place, progression)) {
                line.words.text = std::move(*text);
                line.words.sure = line.tell = true;
            }
        }
    }

private:
    // Two numbers make any progression; but what readers have made of most others is by no accident just what it says of them.
    bool bear_out(const Progression& progression) const {
        constexpr std::size_t kNumbers = 2, kFigures = 3;
        std::size_t at_steps = 0, fit = 0, figures = 0;
        for (const Member& one : members_) {
            if (one.value || !progression.number_at(one.place)) continue;
            ++at_steps;
            const auto text = confirmed(lines_[one.line], one.place, progression);
            if (!text) continue;
            ++fit;
            figures += static_cast<std::size_t>(std::count_if(text->begin(), text->end(), [](char c) { return is_digit(c); }));
        }
        return fit >= kNumbers && figures >= kFigures && static_cast<double>(fit) >= kMostRead * static_cast<double>(at_steps);
    }

    // Steps are as far apart as numbers that stand next to each other, read or not.
    std::optional<Progression> of_two(const Member& a, const Member& b, bool by_factors) const {
        if (!a.value || !b.value) return std::nullopt;
        const auto first = Progression::measure(*a.value, by_factors), last = Progression::measure(*b.value, by_factors);
        if (!first || !last || *first == *last) return std::nullopt;
        const double pitch = std::min(pitch_, b.place - a.place);
        const double steps = std::round((b.place - a.place) / pitch);
        if (pitch < least_ || steps < 1) return std::nullopt;
        return Progression{by_factors,
                           *first,
                           (*last - *first) / steps,
                           a.place,
                           (b.place - a.place) / steps,
                           std::max(kOffPlace, kOffOfHeight * least_)};
    }

    std::optional<std::string> confirmed(const ReadLine& line, double place, const Progression& progression) const {
        for (const std::string& reading : line.readings)
            for (const bool swap_signs : {false, true}) {
                std::string text = as_figure(reading, swap_signs);
                const auto value = value_of(text, style_);
                if (value && progression.holds(place, *value)) return text;
            }
        return std::nullopt;
    }

    std::vector<ReadLine>& lines_;
    std::vector<Member> members_;
    const Style& style_;
    double least_ = 1, pitch_ = 0;  // pixels from one number to the next, at least and mostly
};

enum class Aligned { left, right, middle, row };

// Where the middle of its figures is along and across the axis.
double across_of(const LetteringLine& line, Aligned aligned) {
    const PixelBox& box = line.box;
    switch (aligned) {
        case Aligned::left: return box.left;
        case Aligned::right: return box.right;
        case Aligned::middle: return 0.5 * (box.left + box.right);
        case Aligned::row: break;
    }
    return line.upwards ? 0.5 * (box.top + box.bottom) : box.top + 0.5 * line.letter_height;
}
double along_of(const LetteringLine& line, Aligned aligned) {
    if (aligned == Aligned::row) return 0.5 * (line.box.left + line.box.right);
    return line.upwards ? 0.5 * (line.box.top + line.box.bottom) : line.box.top + 0.5 * line.letter_height;
}

// Lines of one height that are in line with that one, in the order of their places. A scan is not quite level.
std::vector<Member> in_line_with(const std::vector<ReadLine>& lines, const LetteringLine& first, Aligned aligned) {
    constexpr double kOneHeight = 0.2, kOneLine = 0.25, kLevel = 0.01;  // settings: of the height, and of the way between them
    std::vector<Member> members;
    const double height = first.letter_height;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const LetteringLine& line = lines[i].line;
        if (line.upwards != first.upwards || std::abs(line.letter_height - height) > std::max(1.0, kOneHeight * height)) continue;
        const double off = std::abs(across_of(line, aligned) - across_of(first, aligned)),
                     way = std::abs(along_of(line, aligned) - along_of(first, aligned));
        if (off > std::max(1.0, kOneLine * height) + kLevel * way) continue;
        members.push_back({i, along_of(line, aligned), std::nullopt});
    }
    std::stable_sort(members.begin(), members.end(), [](const Member& a, const Member& b) { return a.place < b.place; });
    return members;
}

}  // namespace

void hold_against_axes(std::vector<ReadLine>& lines) {
    constexpr std::size_t kMostNumbers = 80;  // of an axis
    std::vector<bool> held(lines.size(), false);
    for (const Aligned aligned : {Aligned::row, Aligned::right, Aligned::left, Aligned::middle}) {
        std::vector<bool> done = held;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const std::string& text = lines[i].words.text;
            if (done[i] || !counts(lines[i]) || !(value_of(text, kStyles[0]) || value_of(text, kStyles[1]))) continue;
            const std::vector<Member> members = in_line_with(lines, lines[i].line, aligned);
            for (const Member& one : members) done[one.line] = true;
            if (members.size() > kMostNumbers) continue;
            std::optional<Progression> best;
            std::size_t most = 0;
            const Style* style = nullptr;
            for (const Style& one : kStyles) {
                std::size_t count = 0;
                const auto found = Axis(lines, members, one).find(count);
                if (!found || count <= most) continue;
                most = count;
                best = found;
                style = &one;
            }
            if (!best) continue;
            for (const Member& one : members) held[one.line] = true;
            Axis(lines, members, *style).apply(*best);
        }
    }
}

}  // namespace tactics
