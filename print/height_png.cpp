// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "print/height_files.h"
#include "print/height_samples.h"
#include "print/png_file.h"
#include "tactics/relief/height_words.h"

namespace tactics {

namespace {

// Samples of 16 bits as PNG wants them.
class PngRows {
public:
    explicit PngRows(std::size_t width) : above_(2 * width), line_(2 * width + 1) {}

    const std::vector<std::uint8_t>& next(const std::vector<std::uint16_t>& samples) {
        line_[0] = 2;  // filter "up": most rows repeat the one above
        for (std::size_t i = 0; i < above_.size(); ++i) {
            const auto byte = static_cast<std::uint8_t>(i % 2 == 0 ? samples[i / 2] >> 8 : samples[i / 2] & 0xFF);
            line_[i + 1] = static_cast<std::uint8_t>(byte - above_[i]);
            above_[i] = byte;
        }
        return line_;
    }

private:
    std::vector<std::uint8_t> above_;
    std::vector<std::uint8_t> line_;
};

}  // namespace

// pHYs holds pixels per metre as a whole number; the exact pitch is among the words.
std::string height_png(const HeightSheet& sheet, const HeightRows& rows) {
    PngFile png(static_cast<std::uint32_t>(sheet.columns), static_cast<std::uint32_t>(sheet.rows), 16);
    png.scale(1000 / sheet.pitch, 1000 / sheet.pitch);
    for (const auto& [key, value] : words_of(sheet.pitch, sheet.low, sheet.high, sheet.profile)) png.text(key, value);
    std::vector<float> heights(static_cast<std::size_t>(sheet.columns));
    std::vector<std::uint16_t> samples(heights.size());
    PngRows lines(samples.size());
    for (int y = 0; y < sheet.rows; ++y) {
        rows(y, heights);
        to_samples(sheet, heights, samples);
        png.add_row(lines.next(samples));
    }
    return png.finish();
}

}  // namespace tactics
