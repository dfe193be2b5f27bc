// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/check_mark.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kRing = 4;     // mm, radius
constexpr double kLetters = 5;  // mm
constexpr int kCorners = 36;

struct Mark {
    Point at;
    std::string number;
    std::string text;
};

// Numbered as text_report numbers; what is about the whole page has its number, but no place.
std::vector<Mark> marks_of(const Checked& checked, std::size_t most) {
    std::vector<Mark> marks;
    std::size_t number = 0;
    for (const Verdict& verdict : checked.verdicts)
        for (std::size_t i = 0; i < std::min(most, verdict.findings.places.size()); ++i) {
            const Finding& finding = verdict.findings.places[i];
            ++number;
            if (finding.whole_page) continue;
            Point at = finding.at;
            // Between the two sides of a gap; of braille, where the other thing is.
            if (finding.other && distance(at, *finding.other) < 2 * kRing)
                at = {(at.x + finding.other->x) / 2, (at.y + finding.other->y) / 2};
            at = {std::clamp(at.x, 0.0, checked.found.page.width), std::clamp(at.y, 0.0, checked.found.page.height)};
            marks.push_back({at, std::to_string(number), what_is_wrong(verdict, finding).in(checked.found.page.language)});
        }
    return marks;
}

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
    return out;
}

std::string svg_marks(const std::vector<Mark>& marks) {
    const auto number = [](double value) { return to_text(std::round(value * 100) / 100); };
    std::string text = "<g id=\"marks\" data-tactics-layer=\"marks\" font-family=\"DejaVu Sans, sans-serif\" font-size=\"" +
                       number(kLetters) + "\">\n";
    for (const Mark& mark : marks)
        text += "<g><title>" + mark.number + ": " + escaped(mark.text) + "</title><circle cx=\"" + number(mark.at.x) +
                "\" cy=\"" + number(mark.at.y) + "\" r=\"" + number(kRing) +
                "\" fill=\"none\" stroke=\"#d00\" stroke-width=\".6\"/><text x=\"" + number(mark.at.x + kRing) + "\" y=\"" +
                number(mark.at.y - kRing / 2) + "\" fill=\"#d00\">" + mark.number + "</text></g>\n";
    return text + "</g>\n";
}

}  // namespace

std::string mark_page(const Checked& checked, std::size_t most, const Format& format) {
    const std::vector<Mark> marks = marks_of(checked, most);
    Page page = checked.found.page;
    // A page of others may reach beyond its paper; formats draw what lies on it and a little more.
    const auto near_paper = [&](Point& p) {
        p = {std::clamp(p.x, -page.width, 2 * page.width), std::clamp(p.y, -page.height, 2 * page.height)};
    };
    for (PageStroke& stroke : page.strokes) std::for_each(stroke.points.begin(), stroke.points.end(), near_paper);
    for (Area& area : page.areas)
        for (auto& ring : area.rings) std::for_each(ring.begin(), ring.end(), near_paper);
    if (format.name == "svg") {
        std::string text = format.encode(page, Settings(format.options));
        return text.insert(text.rfind("</svg>"), svg_marks(marks));
    }
    for (const Mark& mark : marks) {
        PageStroke ring{{}, true, 0.4};
        for (int i = 0; i < kCorners; ++i) {
            const double angle = 2 * std::numbers::pi * i / kCorners;
            ring.points.push_back({mark.at.x + kRing * std::cos(angle), mark.at.y + kRing * std::sin(angle)});
        }
        page.strokes.push_back(std::move(ring));
        page.print.push_back({{mark.at.x + kRing, mark.at.y - kRing / 2}, kLetters, mark.number});
    }
    return format.encode(page, Settings(format.options));
}

}  // namespace tactics
