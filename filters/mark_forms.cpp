// SPDX-License-Identifier: Apache-2.0
#include "filters/mark_forms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "filters/opencv.h"
#include "tactics/drawing.h"

namespace tactics {

namespace {

constexpr double kMostOff = 0.21;       // of its ink is elsewhere. Setting
constexpr double kWidestStroke = 0.22;  // of the width, a line of an open form. Setting
constexpr int kFine = 4;                // times as fine as pixels

// From -1 to 1, across and down.
using Form = std::vector<Point>;

struct FormLook {
    MarkForm shape;
    std::vector<Form> forms;
    bool filled;
};

Form on_circle_of(int corners, double turned) {
    Form form;
    for (int i = 0; i < corners; ++i) {
        const double angle = turned + 2 * std::numbers::pi * i / corners;
        form.push_back({std::sin(angle), -std::cos(angle)});
    }
    return form;
}

// As wide and as high as all the others. `inner`: how far its inner corners are from the middle; in the five-pointed star
// 1 / (1 + golden ratio) = 0.382 of the outer ones, more with an outline of its own.
Form star(double inner) {
    Form form = on_circle_of(10, 0);
    double wide = 0, low = 0;
    for (std::size_t i = 1; i < form.size(); i += 2) form[i] = {inner * form[i].x, inner * form[i].y};
    for (const Point& p : form) wide = std::max(wide, p.x), low = std::max(low, p.y);
    for (Point& p : form) p = {p.x / wide, 2 * (p.y + 1) / (low + 1) - 1};
    return form;
}

std::vector<FormLook> all_drawn() {
    const Form disc = on_circle_of(48, 0), square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, diamond{{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    const std::vector<Form> triangles{
        {{0, -1}, {1, 1}, {-1, 1}}, {{0, 1}, {1, -1}, {-1, -1}}, {{-1, 0}, {1, -1}, {1, 1}}, {{1, 0}, {-1, -1}, {-1, 1}}};
    const Form level{{-1, 0}, {1, 0}}, upright{{0, -1}, {0, 1}}, falling{{-1, -1}, {1, 1}}, rising{{-1, 1}, {1, -1}};
    std::vector<FormLook> all{{MarkForm::disc, {disc}, true},
                              {MarkForm::square, {square}, true},
                              {MarkForm::diamond, {diamond}, true},
                              {MarkForm::star, {star(0.382)}, true},
                              {MarkForm::star, {star(0.5)}, true},
                              {MarkForm::ring, {disc}, false},
                              {MarkForm::open_square, {square}, false},
                              {MarkForm::open_diamond, {diamond}, false},
                              {MarkForm::plus, {level, upright}, false},
                              {MarkForm::cross, {falling, rising}, false},
                              {MarkForm::asterisk, {level, upright, falling, rising}, false}};
    for (const Form& triangle : triangles) {
        all.push_back({MarkForm::triangle, {triangle}, true});
        all.push_back({MarkForm::open_triangle, {triangle}, false});
    }
    return all;
}

// A form lies anywhere between pixels.
cv::Mat softened(const cv::Mat& share) {
    cv::Mat soft;
    cv::blur(share, soft, cv::Size(3, 3));
    return soft;
}

// Where a form lies, in pixels, with its stroke.
struct FormPlace {
    double left = 0, top = 0, right = 0, bottom = 0, stroke = 0;
};

cv::Mat painted(const FormLook& drawn, const FormPlace& at, cv::Size size) {
    cv::Mat fine = cv::Mat::zeros(size * kFine, CV_8U), coarse;
    const double inner = drawn.filled ? 0 : at.stroke, wide = at.right - at.left - inner, high = at.bottom - at.top - inner;
    for (const Form& form : drawn.forms) {
        std::vector<cv::Point> corners;
        for (const Point& p : form)
            corners.emplace_back(static_cast<int>(std::lround(kFine * (at.left + at.right + p.x * wide) / 2)),
                                 static_cast<int>(std::lround(kFine * (at.top + at.bottom + p.y * high) / 2)));
        if (drawn.filled)
            cv::fillPoly(fine, corners, cv::Scalar(255));
        else
            cv::polylines(fine, corners, form.size() > 2, cv::Scalar(255), static_cast<int>(std::lround(kFine * at.stroke)));
    }
    cv::resize(fine, coarse, size, 0, 0, cv::INTER_AREA);
    return softened(coarse);
}

// The least share of ink that is elsewhere, from a place on: its sides move by half a pixel, as bits of lines may stick out of
// it.
double least_off(const FormLook& drawn, FormPlace at, const cv::Mat& own, double widest) {
    constexpr double kStep = 0.5;
    constexpr int kMostSteps = 12;
    const double ink = cv::sum(own)[0];
    const auto off_at = [&](const FormPlace& place) {
        if (place.right - place.left < 3 || place.bottom - place.top < 3 || place.stroke < 1 || place.stroke > widest) return 1e9;
        return cv::norm(own, painted(drawn, place, own.size()), cv::NORM_L1) / ink;
    };
    double least = off_at(at);
    for (int step = 0; step < kMostSteps; ++step) {
        const double before = least;
        for (double FormPlace::*side :
             {&FormPlace::left, &FormPlace::top, &FormPlace::right, &FormPlace::bottom, &FormPlace::stroke})
            for (const double by : {-kStep, kStep}) {
                if (drawn.filled && side == &FormPlace::stroke) continue;
                FormPlace moved = at;
                moved.*side += by;
                if (const double off = off_at(moved); off < least) least = off, at = moved;
            }
        if (least == before) break;
    }
    return least;
}

bool is_filled(const cv::Mat& share) {
    const cv::Mat body = share > 127;
    cv::Mat deep;
    cv::distanceTransform(body, deep, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    double deepest = 0;
    cv::minMaxLoc(deep, nullptr, &deepest);
    const cv::Rect box = cv::boundingRect(body);
    return deepest > kWidestStroke * std::max(box.width, box.height);
}

}  // namespace

std::optional<MarkForm> mark_form_of(const Image& share) {
    static const std::vector<FormLook> kAll = all_drawn();
    constexpr double kUsual = 1.5;        // pixels of a stroke, or what is nearest to it
    constexpr double kRatherDisc = 0.02;  // points are discs where bits of lines spoil their form
    const cv::Mat sharp = view_of(share), own = softened(sharp);
    const cv::Rect box = cv::boundingRect(sharp > 127);
    if (box.empty()) return std::nullopt;
    const bool filled = is_filled(sharp);
    const double widest = std::max(1.0, kWidestStroke * std::max(box.width, box.height));
    const FormPlace place{1.0 * box.x, 1.0 * box.y, 1.0 * box.br().x, 1.0 * box.br().y, std::min(kUsual, widest)};
    double least = kMostOff;
    std::optional<MarkForm> best;
    for (const FormLook& drawn : kAll) {
        if (drawn.filled != filled) continue;
        const double off = least_off(drawn, place, own, widest) - (drawn.shape == MarkForm::disc ? kRatherDisc : 0);
        if (off < least) least = off, best = drawn.shape;
    }
    return best;
}

std::vector<PlotSymbol> symbols_for(const std::vector<MarkForm>& kinds) {
    using enum PlotSymbol;
    // The nearest first; filled or not is felt before corners.
    const auto liked = [](MarkForm shape) -> std::array<PlotSymbol, kSymbols> {
        switch (shape) {
            case MarkForm::disc: return {disc, ring, triangle, square, cross};
            case MarkForm::square: return {square, triangle, disc, ring, cross};
            case MarkForm::diamond: return {square, triangle, disc, cross, ring};
            case MarkForm::triangle: return {triangle, disc, square, cross, ring};
            case MarkForm::star: return {cross, triangle, square, disc, ring};
            case MarkForm::ring: return {ring, disc, square, cross, triangle};
            case MarkForm::open_square:
            case MarkForm::open_diamond: return {square, ring, triangle, cross, disc};
            case MarkForm::open_triangle: return {triangle, square, ring, cross, disc};
            case MarkForm::plus:
            case MarkForm::cross:
            case MarkForm::asterisk: break;
        }
        return {cross, triangle, square, ring, disc};
    };
    std::vector<PlotSymbol> best;
    for (const MarkForm shape : kinds) best.push_back(liked(shape)[0]);
    if (kinds.size() > kSymbols) return best;
    std::array<PlotSymbol, kSymbols> order{disc, ring, square, triangle, cross};
    std::size_t least = ~std::size_t{0};
    do {
        std::size_t cost = 0;
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            const auto row = liked(kinds[i]);
            cost += static_cast<std::size_t>(std::find(row.begin(), row.end(), order[i]) - row.begin());
        }
        if (cost >= least) continue;
        least = cost;
        best.assign(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kinds.size()));
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

}  // namespace tactics
