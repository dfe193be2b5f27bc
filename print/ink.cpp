// SPDX-License-Identifier: Apache-2.0
#include "print/ink.h"

#include <array>
#include <charconv>

#include "tactics/units.h"

namespace tactics {

void append_whole(std::string& text, long value) {
    std::array<char, 24> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    text.append(buffer.data(), end);
}

void append_number(std::string& text, double value, int places) {
    std::array<char, 64> buffer;
    char* end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, places).ptr;
    if (places > 0) {
        while (end[-1] == '0') --end;
        if (end[-1] == '.') --end;
    }
    text.append(buffer.data(), end);
}

std::string page_matrix(const Page& page) {
    constexpr double kPoints = 1 / (kStepsPerMm * kMmPerPoint);
    // Eight places: over the longest page that PDF allows the error stays below 0.01 point.
    std::string text;
    append_number(text, kPoints, 8);
    text += " 0 0 ";
    append_number(text, -kPoints, 8);
    text += " 0 ";
    append_number(text, page.height / kMmPerPoint, 4);
    return text;
}

namespace {

void append_point(std::string& text, long x, long y, const char* op) {
    append_whole(text, x);
    text += ' ';
    append_whole(text, y);
    text += op;
}

// Points that fall together on the grid are written once. A path of one point still becomes a line, since only a line
// (of no length) is drawn as a dot by round ends.
void append_path(std::string& text, const std::vector<Point>& points) {
    long x = 0, y = 0;
    std::size_t written = 0;
    for (const Point& p : points) {
        const long px = to_steps(p.x), py = to_steps(p.y);
        if (written > 0 && px == x && py == y) continue;
        append_point(text, x = px, y = py, written == 0 ? " m\n" : " l\n");
        ++written;
    }
    if (written == 1) append_point(text, x, y, " l\n");
}

void append_dot(std::string& text, const Point& centre, double diameter) {
    // Four cubic arcs; with this length of the controls no point is more than 0.03 % of the radius off the circle.
    constexpr double kArc = 0.5522847498;
    const long x = to_steps(centre.x), y = to_steps(centre.y), r = to_steps(diameter / 2);
    const long k = std::lround(static_cast<double>(r) * kArc);
    append_point(text, x + r, y, " m\n");
    const auto arc = [&](long ax, long ay, long bx, long by, long cx, long cy) {
        append_point(text, x + ax, y + ay, " ");
        append_point(text, x + bx, y + by, " ");
        append_point(text, x + cx, y + cy, " c\n");
    };
    arc(r, k, k, r, 0, r);
    arc(-k, r, -r, k, -r, 0);
    arc(-r, -k, -k, -r, 0, -r);
    arc(k, -r, r, -k, r, 0);
    text += "f\n";
}

}  // namespace

std::string ink_of(const Page& page) {
    std::size_t points = 0;
    for (const PageStroke& stroke : page.strokes) points += stroke.points.size();
    for (const Area& area : page.areas)
        for (const auto& ring : area.rings) points += ring.size();
    std::string text;
    text.reserve(points * 13 + 1024);
    for (const Area& area : page.areas) {
        bool any = false;
        for (const auto& ring : area.rings) {
            if (ring.size() < 3) continue;
            append_path(text, ring);
            text += "h\n";
            any = true;
        }
        if (any) text += "f*\n";
    }
    text += "1 J 1 j\n";
    long width = -1;
    for (const PageStroke& stroke : page.strokes) {
        if (stroke.points.empty()) continue;
        if (const long own = to_steps(stroke.width); own != width) {
            append_whole(text, width = own);
            text += " w\n";
        }
        append_path(text, stroke.points);
        text += stroke.closed ? "h S\n" : "S\n";
    }
    return text;
}

std::string ink_of(const BrailleLine& line, const Page& page) {
    std::string text;
    for (const Point& dot : dots_of(line, page.cell)) append_dot(text, dot, page.braille_dot);
    return text;
}

std::string outline_of(const Letter& letter) {
    std::string text;
    bool open = false;
    for (const OutlineStep& step : letter.outline) {
        const LetterCorner* c = step.corners;
        switch (step.kind) {
            case OutlineStep::Kind::move:
                if (open) text += "h\n";
                append_point(text, c[0].x, c[0].y, " m\n");
                open = true;
                break;
            case OutlineStep::Kind::line: append_point(text, c[0].x, c[0].y, " l\n"); break;
            case OutlineStep::Kind::curve:
                append_point(text, c[0].x, c[0].y, " ");
                append_point(text, c[1].x, c[1].y, " ");
                append_point(text, c[2].x, c[2].y, " c\n");
                break;
        }
    }
    if (open) text += "h\n";
    return text;
}

}  // namespace tactics
