// SPDX-License-Identifier: Apache-2.0
#include "samples/draw/ink.h"

#include <algorithm>
#include <cmath>

namespace tactics::samples {

namespace {

float distance_to(Spot p, Spot a, Spot b) {
    const float dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
    const float t = length2 <= 0 ? 0 : std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0f, 1.0f);
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

// Each letter as strokes on a grid of 5 columns and 7 rows: two figures a point (column, row), spaces between strokes.
std::string_view strokes_of(char c) {
    switch (c) {
        case 'A': return "062046 1434";
        case 'B': return "0600304132230323344536 3606";
        case 'C': return "4130100105163645";
        case 'D': return "06002042444526 2606";
        case 'E': return "40000646 0333";
        case 'F': return "400006 0333";
        case 'G': return "41301001051636454323";
        case 'H': return "0006 4046 0343";
        case 'I': return "2026 1030 1636";
        case 'J': return "40453616 1605";
        case 'K': return "0006 400346";
        case 'L': return "000646";
        case 'M': return "0600234046";
        case 'N': return "06004640";
        case 'O': return "1030414536160501 0110";
        case 'P': return "060030414233 3303";
        case 'Q': return "1030414536160501 0110 2446";
        case 'R': return "060030414233 3303 2346";
        case 'S': return "413010010213334445361605";
        case 'T': return "0040 2026";
        case 'U': return "000516364540";
        case 'V': return "002640";
        case 'W': return "0016233640";
        case 'X': return "0046 4006";
        case 'Y': return "002340 2326";
        case 'Z': return "00400646";
        case '0': return "1030414536160501 0110 1531";
        case '1': return "112026 1636";
        case '2': return "0110304142060646";
        case '3': return "004022334445361605";
        case '4': return "36300444";
        case '5': return "40000233444536 361605";
        case '6': return "40200205163645443403";
        case '7': return "004016";
        case '8': return "1030413313020110 1304051636443313";
        case '9': return "064441301001021343";
        case '.': return "2526";
        case ',': return "2516";
        case '-': return "1333";
        case '%': return "4006 0001 4546";
        default: return "";
    }
}

}  // namespace

Ink::Ink(int width, int height, Colour ground)
    : image_(make_image(width, height, 3, 0, 255)), scale_(static_cast<float>(std::max(width, height)) / 1000.0f) {
    for (std::size_t i = 0; i < image_.pixels.size(); i += 3) {
        image_.pixels[i] = static_cast<std::uint8_t>(ground.red);
        image_.pixels[i + 1] = static_cast<std::uint8_t>(ground.green);
        image_.pixels[i + 2] = static_cast<std::uint8_t>(ground.blue);
    }
}

void Ink::blend(int x, int y, float cover, Colour colour) {
    if (cover <= 0 || x < 0 || y < 0 || x >= image_.width || y >= image_.height) return;
    std::uint8_t* pixel = image_.row(y) + 3 * x;
    const int values[3] = {colour.red, colour.green, colour.blue};
    for (int i = 0; i < 3; ++i)
        pixel[i] = static_cast<std::uint8_t>(
            std::lround(static_cast<float>(pixel[i]) + (static_cast<float>(values[i]) - pixel[i]) * std::min(cover, 1.0f)));
}

void Ink::line(std::span<const Spot> points, float width, Colour colour, bool closed) {
    if (points.empty()) return;
    const float half = std::max(width * scale_, 1.0f) / 2;
    float left = 1e9f, right = -1e9f, top = 1e9f, bottom = -1e9f;
    std::vector<Spot> path;
    for (const Spot p : points) path.push_back({p.x * scale_, p.y * scale_});
    if (closed) path.push_back(path.front());
    for (const Spot p : path) {
        left = std::min(left, p.x), right = std::max(right, p.x);
        top = std::min(top, p.y), bottom = std::max(bottom, p.y);
    }
    // The nearest piece decides, so that a translucent edge is not painted twice where two pieces meet. Rows keep the
    // pieces that can reach them.
    std::vector<std::size_t> near;
    for (int y = static_cast<int>(std::floor(top - half)) - 1; y <= static_cast<int>(bottom + half) + 1; ++y) {
        if (y < 0 || y >= image_.height) continue;
        const float middle = static_cast<float>(y) + 0.5f;
        near.clear();
        for (std::size_t i = 1; i < path.size(); ++i)
            if (std::min(path[i - 1].y, path[i].y) - half - 1 <= middle &&
                middle <= std::max(path[i - 1].y, path[i].y) + half + 1)
                near.push_back(i);
        const int first = std::max(static_cast<int>(std::floor(left - half)) - 1, 0);
        for (int x = first; x <= std::min(static_cast<int>(right + half) + 1, image_.width - 1); ++x) {
            const Spot p{static_cast<float>(x) + 0.5f, middle};
            float d = 1e9f;
            for (const std::size_t i : near) d = std::min(d, distance_to(p, path[i - 1], path[i]));
            blend(x, y, half + 0.5f - d, colour);
        }
    }
}

void Ink::fill(std::span<const Spot> points, Colour colour) {
    // Even-odd, four lines of samples a row, exact in x.
    constexpr int kLines = 4;
    float top = 1e9f, bottom = -1e9f;
    for (const Spot p : points) top = std::min(top, p.y * scale_), bottom = std::max(bottom, p.y * scale_);
    std::vector<float> cover, crossings;
    for (int y = std::max(static_cast<int>(std::floor(top)), 0); y <= std::min(static_cast<int>(bottom), image_.height - 1);
         ++y) {
        cover.assign(static_cast<std::size_t>(image_.width), 0.0f);
        for (int k = 0; k < kLines; ++k) {
            const float at = static_cast<float>(y) + (static_cast<float>(k) + 0.5f) / kLines;
            crossings.clear();
            for (std::size_t i = 0; i < points.size(); ++i) {
                const Spot a = points[i], b = points[(i + 1) % points.size()];
                const float ay = a.y * scale_, by = b.y * scale_;
                if ((ay <= at) != (by <= at)) crossings.push_back((a.x + (b.x - a.x) * (at - ay) / (by - ay)) * scale_);
            }
            std::sort(crossings.begin(), crossings.end());
            for (std::size_t i = 1; i < crossings.size(); i += 2) {
                const float from = std::max(crossings[i - 1], 0.0f),
                            to = std::min(crossings[i], static_cast<float>(image_.width));
                for (int x = static_cast<int>(from); static_cast<float>(x) < to; ++x)
                    cover[static_cast<std::size_t>(x)] +=
                        (std::min(to, static_cast<float>(x + 1)) - std::max(from, static_cast<float>(x))) / kLines;
            }
        }
        for (int x = 0; x < image_.width; ++x) blend(x, y, cover[static_cast<std::size_t>(x)], colour);
    }
}

void Ink::disc(Spot centre, float radius, Colour colour) { fill(oval(centre, radius, radius), colour); }

void Ink::box(float left, float top, float width, float height, Colour colour) {
    const Spot corners[] = {{left, top}, {left + width, top}, {left + width, top + height}, {left, top + height}};
    fill(corners, colour);
}

void Ink::text(Spot left_base, float size, std::string_view words, Colour colour, float weight) {
    const float cell = size / 6;
    std::vector<Spot> stroke;
    for (char c : words) {
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
        const auto flush = [&] {
            if (stroke.size() > 1) line(stroke, weight * size, colour);
            stroke.clear();
        };
        const std::string_view marks = strokes_of(c);
        for (std::size_t i = 0; i + 1 < marks.size();) {
            if (marks[i] == ' ' || marks[i + 1] == ' ') {
                flush();
                ++i;
                continue;
            }
            stroke.push_back({left_base.x + cell * static_cast<float>(marks[i] - '0'),
                              left_base.y - size + cell * static_cast<float>(marks[i + 1] - '0')});
            i += 2;
        }
        flush();
        left_base.x += c == 'I' || c == '.' || c == ',' ? 5 * cell : 6 * cell;
    }
}

std::vector<Spot> curve(std::span<const Spot> through, bool closed) {
    std::vector<Spot> path;
    const int count = static_cast<int>(through.size());
    const auto at = [&](int i) {
        return through[static_cast<std::size_t>(closed ? (i + count) % count : std::clamp(i, 0, count - 1))];
    };
    for (int i = 0; i < (closed ? count : count - 1); ++i) {
        const Spot a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
        for (int k = 0; k < 12; ++k) {
            const float t = static_cast<float>(k) / 12, t2 = t * t, t3 = t2 * t;
            const auto blend = [&](float p, float q, float r, float s) {
                return 0.5f * (2 * q + (r - p) * t + (2 * p - 5 * q + 4 * r - s) * t2 + (3 * q - p - 3 * r + s) * t3);
            };
            path.push_back({blend(a.x, b.x, c.x, d.x), blend(a.y, b.y, c.y, d.y)});
        }
    }
    if (!closed) path.push_back(through.back());
    return path;
}

std::vector<Spot> oval(Spot centre, float rx, float ry, float from_degrees, float to_degrees) {
    std::vector<Spot> path;
    constexpr int kSteps = 72;
    constexpr float kRadians = 3.14159265f / 180;
    const bool whole = to_degrees - from_degrees >= 360;
    for (int i = 0; i < (whole ? kSteps : kSteps + 1); ++i) {
        const float angle = (from_degrees + (to_degrees - from_degrees) * static_cast<float>(i) / kSteps) * kRadians;
        path.push_back({centre.x + rx * std::cos(angle), centre.y + ry * std::sin(angle)});
    }
    return path;
}

}  // namespace tactics::samples
