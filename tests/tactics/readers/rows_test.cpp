// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tactics/readers/upright.h"
#include "tests/tactics/readers/pictures.h"

namespace tactics::rows_test {
namespace {

template <class Sample>
Image receive(const RowShape& shape, const std::vector<Sample>& samples, bool colour) {
    RowReceiver<Sample> rows(shape, {.longest = 0, .colour = colour});
    const auto row = static_cast<std::size_t>(shape.size.width * shape.channels());
    for (int y = 0; y < shape.size.height; ++y) rows.add(samples.data() + static_cast<std::size_t>(y) * row);
    return rows.finish();
}

TEST(Upright, AgreesWithTheTwinForAllOrientations) {
    for (const int channels : {1, 3}) {
        const Image upright = noise_picture(7, 4, channels);
        for (int orientation = 1; orientation <= 8; ++orientation)
            EXPECT_EQ(largest_difference(turn_upright(stored_as(upright, orientation), orientation), upright), 0) << orientation;
    }
}

TEST(Upright, ReadsTheOrientationAndNothingElse) {
    for (int orientation = 1; orientation <= 8; ++orientation)
        for (const bool big : {false, true}) {
            Bytes block = exif_block(orientation, big);
            block.erase(block.begin(), block.begin() + 6);
            EXPECT_EQ(exif_orientation(block), orientation);
            for (std::size_t size = 0; size < block.size() - 6; ++size)  // the value is 6 bytes before the end, or behind
                EXPECT_EQ(exif_orientation(std::span(block).first(std::min(size, std::size_t{18}))), 1);
        }
    Bytes nine = exif_block(9, false);
    EXPECT_EQ(exif_orientation(std::span(nine).subspan(6)), 1);
    Bytes far = exif_block(6, false);
    far[10] = far[11] = far[12] = far[13] = 0xFF;  // the directory is said to be at 4 GB
    EXPECT_EQ(exif_orientation(std::span(far).subspan(6)), 1);
}

TEST(RowReceiver, LaysAlphaOverWhite) {
    RowShape shape{{5, 1}, 1, Alpha::straight, 1};
    const std::vector<std::uint8_t> grey = {0, 0, 0, 255, 100, 128, 255, 7, 200, 255};
    EXPECT_EQ(receive(shape, grey, false).pixels, (std::vector<std::uint8_t>{255, 0, 177, 255, 200}));
    shape.alpha = Alpha::premultiplied;
    const std::vector<std::uint8_t> premultiplied = {0, 0, 0, 255, 50, 128, 7, 7, 200, 255};
    EXPECT_EQ(receive(shape, premultiplied, false).pixels, (std::vector<std::uint8_t>{255, 0, 177, 255, 200}));
}

TEST(RowReceiver, MakesTheSameGreyAsTheImage) {
    const Image colour = noise_picture(31, 17, 3);
    const RowShape shape{{31, 17}, 3, Alpha::none, 1};
    EXPECT_EQ(receive(shape, colour.pixels, true).pixels, colour.pixels);
    EXPECT_EQ(receive(shape, colour.pixels, false).pixels, to_grey(colour).pixels);
}

TEST(RowReceiver, SurvivesWhatIsNotANumber) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    const RowShape shape{{6, 1}, 1, Alpha::none, 1};
    EXPECT_EQ(receive<float>(shape, {nan, infinity, -infinity, -3, 0.5f, 1}, false).pixels,
              (std::vector<std::uint8_t>{0, 0, 0, 0, 188, 255}));
    const RowShape clear{{2, 1}, 1, Alpha::straight, 1};
    EXPECT_EQ(receive<float>(clear, {1, nan, nan, 1}, false).pixels, (std::vector<std::uint8_t>{255, 0}));
    const RowShape hot{{3, 1}, 3, Alpha::none, 1};
    const float huge = std::numeric_limits<float>::max();
    EXPECT_EQ(receive<float>(hot, std::vector<float>(9, huge), false).pixels.size(), 3u);
}

TEST(RowReceiver, AveragesLight) {
    const RowShape shape{{2, 1}, 1, Alpha::none, 1};
    RowReceiver<float> rows(shape, {.longest = 1, .colour = false});
    const float row[] = {0, 1};
    rows.add(row);
    EXPECT_EQ(rows.finish().pixels, std::vector<std::uint8_t>{188});  // half the light is 188, not 128
}

TEST(Srgb, InvertsTheStandardCurve) {
    for (int value = 0; value <= 255; ++value) {
        const double coded = value / 255.0;
        const double linear = coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
        EXPECT_EQ(srgb_coded(static_cast<float>(linear)), value);
    }
    EXPECT_EQ(srgb_coded(-1), 0);
    EXPECT_EQ(srgb_coded(1e30f), 255);
}

TEST(Exposure, LeavesOrdinaryPicturesAlone) {
    std::vector<float> ramp(1000);
    for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = static_cast<float>(i) / 999.0f;
    EXPECT_EQ(white_of(ramp, 1, 1), 1.0f);
    ramp[999] = 5000;  // the sun
    EXPECT_EQ(white_of(ramp, 1, 1), 1.0f);
    for (auto& value : ramp) value *= 0.01f;
    EXPECT_NEAR(white_of(ramp, 1, 1), 0.0099f, 1e-4);
    for (auto& value : ramp) value *= 10000;
    EXPECT_NEAR(white_of(ramp, 1, 1), 99, 1);
    EXPECT_EQ(white_of(std::vector<float>(30, 0.0f), 3, 3), 1.0f);
}

}  // namespace
}  // namespace tactics::rows_test
