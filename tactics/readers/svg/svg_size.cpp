// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/svg_size.h"

#include <algorithm>
#include <cmath>

#include "tactics/error.h"
#include "tactics/readers/svg/svg_numbers.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kMmPerPx = kMmPerInch / 96;  // CSS
constexpr double kLargestPage = 14'400 * kMmPerPoint, kSmallestPage = 1;

[[noreturn]] void refuse_size(const Element& root, const std::string& file, const Phrase& why) {
    throw Error(Fault::failed, file + ":" + std::to_string(root.line), why);
}

bool is_in_range(double side) { return side >= kSmallestPage && side <= kLargestPage; }

}  // namespace

bool view_box(const Element& element, double view[4]) {
    std::string_view text = element.attribute("viewBox");
    for (int i = 0; i < 4; ++i) {
        const auto number = take_svg_number(text);
        if (!number) return false;
        view[i] = *number;
    }
    return view[2] > 0 && view[3] > 0;
}

SvgSize size_of_svg(const Element& root, const std::string& file, const std::optional<Paper>& paper) {
    SvgSize size;
    double view[4];
    const bool has_view = view_box(root, view);
    const auto side = [&](std::string_view name) {
        const auto text = root.attribute(name);
        return text.empty() || text.ends_with('%') ? std::nullopt : parse_svg_length(text, 0);
    };
    auto width = side("width"), height = side("height");
    if (!width && !height && has_view && paper) {
        const bool lies = view[2] > view[3];
        size.told = false;
        size.width = lies ? paper->height : paper->width;
        size.height = lies ? paper->width : paper->height;
    } else {
        if (has_view && width && !height) height = *width * view[3] / view[2];
        if (has_view && height && !width) width = *height * view[2] / view[3];
        if (!width || !height)
            refuse_size(
                root, file,
                phrase("how large this drawing is on paper is not told; give its svg element a width and a height in mm, or "
                       "name the paper with {0}",
                       spelled("paper")));
        size.width = *width * kMmPerPx;
        size.height = *height * kMmPerPx;
        const auto last = root.attribute("width").empty() ? '0' : root.attribute("width").back();
        size.told = !((last >= '0' && last <= '9') || root.attribute("width").ends_with("px"));
        if (!size.told)
            size.note = phrase("its size is told in pixels, taken as 96 to the inch: {0} x {1} mm",
                               numeral(std::round(size.width * 10) / 10), numeral(std::round(size.height * 10) / 10));
    }
    if (!is_in_range(size.width) || !is_in_range(size.height))
        refuse_size(root, file,
                    phrase("a page of {0} x {1} mm is out of range; each side is {2} to {3} mm", numeral(size.width),
                           numeral(size.height), numeral(kSmallestPage), numeral(kLargestPage)));
    size.view_width = has_view ? view[2] : size.width / kMmPerPx;
    size.view_height = has_view ? view[3] : size.height / kMmPerPx;
    size.to_mm = has_view ? fit_view(view, size.width, size.height, root.attribute("preserveAspectRatio"))
                          : Transform{kMmPerPx, 0, 0, kMmPerPx, 0, 0};
    return size;
}

void scale_to_figure(SvgSize& size) {
    constexpr double kFigure = 200;  // mm
    const double scale = kFigure / std::max(size.width, size.height);
    size.width *= scale;
    size.height *= scale;
    size.to_mm = Transform{scale, 0, 0, scale, 0, 0} * size.to_mm;
}

}  // namespace tactics
