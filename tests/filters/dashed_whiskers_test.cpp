// SPDX-License-Identifier: Apache-2.0
// Whiskers that are dashed: drawn whole, as dashes would be too few to be felt.
#include <gtest/gtest.h>

#include "filters/known_parts.h"
#include "tests/filters/pictures.h"

namespace tactics::dashed_whiskers_test {
namespace {

// Upright dashed lines from a cap at `top` to a bar, each so long, dashes of 8 pixels and gaps of 6.
Image plot(const std::vector<int>& lengths) {
    return pictures::drawn(100 * static_cast<int>(lengths.size()), 400, [&](int x, int y) {
        const int u = x % 100, foot = 380, top = foot - lengths[static_cast<std::size_t>(x / 100)];
        if (y >= foot && y < foot + 2) return 0;
        if (y >= top - 2 && y < top && u >= 30 && u < 72) return 0;
        return u >= 50 && u < 52 && y >= top && y < foot && (y - top + 5) % 14 < 8 ? 0 : 255;
    });
}

bool is_whole(const Image& picture, int x, int top) {
    for (int y = top; y < 380; ++y)
        if (picture.row(y)[x] > 128 && picture.row(y)[x + 1] > 128) return false;
    return true;
}

// The second has no dash of its own, only what hangs on its cap and what stands on the bar.
TEST(DashedWhiskers, AreWholeIfOneIsShort) {
    Image picture = plot({65, 12, 340});
    const KnownParts parts = take_known_parts(picture);
    EXPECT_TRUE(parts.strokes.empty());
    EXPECT_TRUE(is_whole(picture, 50, 315));
    EXPECT_TRUE(is_whole(picture, 150, 368));
    EXPECT_TRUE(is_whole(picture, 250, 40));
}

TEST(DashedWhiskers, LongOnesAloneAreDashed) {
    Image picture = plot({340, 300, 280});
    const KnownParts parts = take_known_parts(picture);
    ASSERT_EQ(parts.strokes.size(), 3u);
    for (const Stroke& stroke : parts.strokes) EXPECT_EQ(stroke.role, Role::dash);
}

}  // namespace
}  // namespace tactics::dashed_whiskers_test
