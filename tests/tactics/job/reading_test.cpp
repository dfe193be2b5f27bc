// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/reading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "filters/list.h"
#include "tactics/readers/shrink.h"

namespace tactics::reading_test {
namespace {

// What would be averaged twice would be blurred for nothing.
TEST(Reading, GivesAsManyPixelsAsResampleLeaves) {
    for (const Size whole : {Size{4000, 3000}, Size{3000, 4000}, Size{5184, 3456}, Size{3456, 5184}}) {
        Reading reading([&](const ReadRequest& request) {
            const Size size = shrunk_size(whole, request.longest);
            return make_image(size.width, size.height, 1, 0, 128);
        });
        for (const std::string dpi : {"75", "100", "150"}) {
            const Recipe recipe = parse_recipe("resample dpi=" + dpi, "test", filters());
            for (double longer = 170; longer < 260; longer += 0.37) {
                const double scale = longer / std::max(whole.width, whole.height);
                const Image picture = read_for(recipe, {0, 0, whole.width * scale, whole.height * scale}, reading);
                const Image sampled = std::get<Image>(run(recipe, picture));
                EXPECT_EQ(sampled.width, picture.width) << longer << " mm at " << dpi;
                EXPECT_EQ(sampled.height, picture.height) << longer << " mm at " << dpi;
                EXPECT_NEAR(std::max(picture.width, picture.height) * 25.4 / longer, std::stod(dpi), 0.5 * 25.4 / longer + 1e-9);
            }
        }
    }
}

// Grey bars on lines are solid, however small a part of the page the chart is.
TEST(Reading, LooksCloserAtAFigureOnAnEmptyPage) {
    const auto page = [](int wide, int high) {
        Image image = make_image(wide, high, 1, 0, 255);
        const auto fill = [&](int left, int top, int right, int bottom, std::uint8_t grey) {
            for (int y = top; y < bottom; ++y) std::fill(image.row(y) + left, image.row(y) + right, grey);
        };
        for (int line = 0; line < 6; ++line) fill(20, 20 + 20 * line, 240, 21 + 20 * line, 0);
        for (int bar = 0; bar < 4; ++bar) fill(40 + 50 * bar, 60, 64 + 50 * bar, 120, 100);
        return image;
    };
    for (const auto& image : {page(260, 140), page(500, 700)}) {
        Reading reading([&](const ReadRequest&) { return image; });
        EXPECT_EQ(choose(reading).recipe, "diagram") << image.width;
    }
}

// A small figure is not decoded once for its words, once for each page and once to look at it; a large one is, as it is smaller
// each time.
TEST(Reading, ReadsAllPixelsOnce) {
    for (const auto& [side, times] : {std::pair{900, 1}, std::pair{3000, 4}}) {
        int reads = 0;
        Reading reading([&, side = side](const ReadRequest& request) {
            ++reads;
            const Size size = shrunk_size({side, side / 2}, request.longest);
            return make_image(size.width, size.height, request.colour ? 3 : 1, 0, 128);
        });
        const int words = 2400, page = 1200;
        EXPECT_EQ(reading.get({words, true}).width, std::min(side, words));
        EXPECT_EQ(reading.take({page, true}).width, std::min(side, page));
        EXPECT_EQ(reading.take({page, true}).width, std::min(side, page));
        EXPECT_EQ(reading.get({words, true}).width, std::min(side, words));
        EXPECT_EQ(reads, times) << side;
        EXPECT_EQ(reading.get({words, false}).channels, 1);
        EXPECT_EQ(reading.get({500, false}).width, 500) << "fewer pixels than there are are read anew";
    }
}

}  // namespace
}  // namespace tactics::reading_test
