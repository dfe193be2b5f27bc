// SPDX-License-Identifier: Apache-2.0
#include "print/svg_lines.h"

#include "print/ink.h"
#include "tactics/geometry/curves.h"
#include "tactics/layout/own_marks.h"

namespace tactics {

namespace {

void append_steps(std::string& text, long steps) {
    if (steps < 0) {
        text += '-';
        steps = -steps;
    }
    const long rest = steps % 100;
    if (steps >= 100 || rest == 0) append_whole(text, steps / 100);
    if (rest == 0) return;
    text += '.';
    text += static_cast<char>('0' + rest / 10);
    if (rest % 10 != 0) text += static_cast<char>('0' + rest % 10);
}

// Numbers of one command; a minus parts them as a blank does.
class Numbers {
public:
    explicit Numbers(std::string& text) : text_(text) {}
    void add(long steps) {
        if (!first_ && steps >= 0) text_ += ' ';
        append_steps(text_, steps);
        first_ = false;
    }

private:
    std::string& text_;
    bool first_ = true;
};

// Half of what a fingertip feels of a step aside in a line.
constexpr double kTolerance = 0.1;  // mm
// Of fewer points a line keeps its own.
constexpr std::size_t kFewPoints = 8;

std::string curved(const std::vector<CurvePiece>& pieces, Point first, bool closed) {
    long x = to_steps(first.x), y = to_steps(first.y);
    std::string path = "M";
    Numbers start(path);
    start.add(x);
    start.add(y);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const CurvePiece& piece = pieces[i];
        if (closed && piece.straight && i + 1 == pieces.size()) break;  // z draws it
        path += piece.straight ? 'l' : 'c';
        Numbers numbers(path);
        const auto add = [&](Point p) {
            numbers.add(to_steps(p.x) - x);
            numbers.add(to_steps(p.y) - y);
        };
        if (!piece.straight) {
            add(piece.one);
            add(piece.other);
        }
        add(piece.end);
        x = to_steps(piece.end.x);
        y = to_steps(piece.end.y);
    }
    return closed ? path + 'z' : path;
}

std::string in_steps(const std::vector<Point>& points) {
    std::string text;
    long x = 0, y = 0;
    for (const Point& p : points) {
        if (!text.empty()) text += ' ';
        append_whole(text, to_steps(p.x) - x);
        text += ' ';
        append_whole(text, to_steps(p.y) - y);
        x = to_steps(p.x);
        y = to_steps(p.y);
    }
    return text;
}

}  // namespace

void append_mm(std::string& text, double mm) { append_steps(text, to_steps(mm)); }

void append_attribute(std::string& text, std::string_view name, double mm) {
    text += ' ';
    text += name;
    text += "=\"";
    append_mm(text, mm);
    text += '"';
}

void append_path(std::string& text, const std::vector<Point>& points, bool closed) {
    long x = 0, y = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const long px = to_steps(points[i].x), py = to_steps(points[i].y);
        if (i > 1 && px == x && py == y) continue;  // but a line of no length stays, it is a dot
        if (i < 2) text += i == 0 ? "M" : "l";
        const long dx = px - x, dy = py - y;
        if (i > 1 && dx >= 0) text += ' ';
        append_steps(text, dx);
        if (dy >= 0) text += ' ';
        append_steps(text, dy);
        x = px;
        y = py;
    }
    if (closed) text += 'z';
}

std::string course_attributes(const PageStroke& stroke) {
    const std::vector<CurvePiece> pieces =
        stroke.points.size() < kFewPoints ? std::vector<CurvePiece>() : curves_of(stroke.points, stroke.closed, kTolerance);
    if (pieces.empty() || 4 * pieces.size() > 3 * stroke.points.size()) {
        std::string path = " d=\"";
        append_path(path, stroke.points, stroke.closed);
        return path + '"';
    }
    const std::string path = curved(pieces, stroke.points.front(), stroke.closed);
    return " d=\"" + path + "\" " + std::string(marks::kPath) + "=\"" + path + "\" " + std::string(marks::kPoints) + "=\"" +
           in_steps(stroke.points) + '"';
}

}  // namespace tactics
