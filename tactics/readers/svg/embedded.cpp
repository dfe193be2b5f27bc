// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/embedded.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "tactics/error.h"
#include "tactics/readers/read.h"
#include "tactics/readers/svg/clip.h"
#include "tactics/readers/svg/data_uri.h"

namespace tactics {

namespace {

constexpr int kMostPixels = 4000;

bool is_of_the_web(std::span<const unsigned char> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return text.starts_with("\x89PNG\r\n\x1A\n") || text.starts_with("\xFF\xD8\xFF") ||
           (text.starts_with("RIFF") && text.substr(std::min<std::size_t>(8, text.size())).starts_with("WEBP"));
}

// The file in a data URI.
std::optional<std::vector<unsigned char>> file_in(std::string_view address) {
    auto bytes = address.starts_with("data:image/") ? bytes_of_data_uri(address) : std::nullopt;
    return bytes && is_of_the_web(*bytes) ? std::move(bytes) : std::nullopt;
}

}  // namespace

std::optional<Bitmap> embedded_picture(std::string_view address, const Rect& place) {
    const auto bytes = file_in(address);
    if (!bytes) return std::nullopt;
    try {
        Source source = memory_source(*bytes, "picture");
        const Image image = read_picture(source, {kMostPixels, false});
        return to_bitmap(image, place);
    } catch (const Error&) {
        return std::nullopt;
    }
}

bool take_page_picture(FoundPage& page, std::string_view address, const Rect& place) {
    if (page.page.picture || !(place.width > 0) || !(place.height > 0)) return false;
    page.page.picture = embedded_picture(address, place);
    if (!page.page.picture) return false;
    page.notes.push_back(phrase("a picture of pixels is looked at for its ink and beside braille only"));
    return true;
}

bool take_figure_picture(FoundPage& figure, std::string_view address, const Rect& place, const Rect& clip) {
    constexpr std::size_t kMost = 20;  // more are tiles of one, or marks
    constexpr double kLeast = 8;       // mm of a page of 200: a logo, a marker
    const bool mirrored = place.width < 0, upside_down = place.height < 0;
    const Rect upright{place.left + std::min(place.width, 0.0), place.top + std::min(place.height, 0.0), std::abs(place.width),
                       std::abs(place.height)};
    const Rect shown = common_of(clip, {upright.left, upright.top}, {upright.left + upright.width, upright.top + upright.height});
    if (figure.pictures.size() == kMost || !(shown.width >= kLeast) || !(shown.height >= kLeast)) return false;
    const auto bytes = file_in(address);
    if (!bytes) return false;
    try {
        Source source = memory_source(*bytes, "picture");
        inspect_picture(source);
    } catch (const Error&) {
        return false;
    }
    figure.pictures.push_back({std::string(bytes->begin(), bytes->end()), upright, shown, mirrored, upside_down});
    return true;
}

}  // namespace tactics
