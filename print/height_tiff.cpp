// SPDX-License-Identifier: Apache-2.0
// TIFF 6.0, little-endian: grey in strips, compressed as ZIP (Adobe's number 8, Photoshop TIFF Technical Notes 2002). Written
// here, not by libtiff, which reads it in the tests.
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "print/deflate.h"
#include "print/height_files.h"
#include "print/height_samples.h"
#include "tactics/relief/height_words.h"

namespace tactics {

namespace {

constexpr int kTiffLevel = 4;                    // as PngFile
constexpr std::size_t kStripBytes = 256 * 1024;  // TIFF 6.0 asks for about 8 kB, of the time of small memories

void append(std::string& text, std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(static_cast<unsigned char>(value >> (8 * i)));
}

void set(std::string& text, std::size_t at, std::uint32_t value) {
    std::string bytes;
    append(bytes, value, 4);
    text.replace(at, 4, bytes);
}

// Its single directory, after the strips. Values of over four bytes precede it.
class Directory {
public:
    explicit Directory(std::string& file) : file_(file) {}

    void add(std::uint16_t tag, std::uint32_t value, bool wide = false) { entry(tag, wide ? 4 : 3, 1, value); }
    void add(std::uint16_t tag, const std::vector<std::uint32_t>& values) {
        if (values.size() == 1) return entry(tag, 4, 1, values[0]);
        const std::uint32_t at = here();
        for (const std::uint32_t value : values) append(file_, value, 4);
        entry(tag, 4, static_cast<std::uint32_t>(values.size()), at);
    }
    void add(std::uint16_t tag, const std::string& text) {
        const std::uint32_t at = here();
        file_ += text + '\0';
        entry(tag, 2, static_cast<std::uint32_t>(text.size() + 1), at);
    }
    void add_ratio(std::uint16_t tag, std::uint32_t over, std::uint32_t under) {
        const std::uint32_t at = here();
        append(file_, over, 4);
        append(file_, under, 4);
        entry(tag, 5, 1, at);
    }
    void finish() {
        const std::uint32_t at = here();
        append(file_, count_, 2);
        file_ += entries_;
        append(file_, 0, 4);  // no other directory
        set(file_, 4, at);
    }

private:
    // Values begin at even places.
    std::uint32_t here() {
        if (file_.size() % 2 != 0) file_ += '\0';
        return static_cast<std::uint32_t>(file_.size());
    }
    void entry(std::uint16_t tag, std::uint32_t type, std::uint32_t count, std::uint32_t value) {
        append(entries_, tag, 2);
        append(entries_, type, 2);
        append(entries_, count, 4);
        append(entries_, value, 4);
        ++count_;
    }

    std::string& file_;
    std::string entries_;
    std::uint32_t count_ = 0;
};

std::string description(const HeightSheet& sheet) {
    std::string text;
    for (const auto& [key, value] : words_of(sheet.pitch, sheet.low, sheet.high, sheet.profile))
        text += std::string(key) + ' ' + value + '\n';
    return text;
}

// `add_row` appends the bytes of a row.
template <typename AddRow>
std::string tiff_of(const HeightSheet& sheet, const HeightRows& rows, bool decimal, const AddRow& add_row) {
    std::string file("II*\0\0\0\0\0", 8);
    const std::size_t sample_bytes = decimal ? 4 : 2, row_bytes = sample_bytes * static_cast<std::size_t>(sheet.columns);
    const int strip_rows =
        static_cast<int>(std::clamp<std::size_t>(kStripBytes / row_bytes, 1, static_cast<std::size_t>(sheet.rows)));
    std::vector<std::uint32_t> offsets, sizes;
    std::vector<float> heights(static_cast<std::size_t>(sheet.columns));
    std::vector<std::uint8_t> bytes;
    for (int top = 0; top < sheet.rows; top += strip_rows) {
        Deflater strip(kTiffLevel);
        for (int y = top; y < std::min(top + strip_rows, sheet.rows); ++y) {
            rows(y, heights);
            bytes.clear();
            add_row(heights, bytes);
            strip.add(bytes);
        }
        if (file.size() % 2 != 0) file += '\0';
        const std::string data = strip.finish();
        offsets.push_back(static_cast<std::uint32_t>(file.size()));
        sizes.push_back(static_cast<std::uint32_t>(data.size()));
        file += data;
    }
    Directory tags(file);
    tags.add(256, static_cast<std::uint32_t>(sheet.columns), true);
    tags.add(257, static_cast<std::uint32_t>(sheet.rows), true);
    tags.add(258, static_cast<std::uint32_t>(8 * sample_bytes));
    tags.add(259, 8u);                  // Compression: ZIP
    tags.add(262, 1u);                  // PhotometricInterpretation: black is zero
    tags.add(270, description(sheet));  // ImageDescription
    tags.add(273, offsets);             // StripOffsets
    tags.add(277, 1u);                  // SamplesPerPixel
    tags.add(278, static_cast<std::uint32_t>(strip_rows), true);
    tags.add(279, sizes);  // StripByteCounts
    // Samples per cm: 10 / pitch, in millionths of a mm.
    const auto millionths = static_cast<std::uint32_t>(std::clamp(std::lround(sheet.pitch * 1e6), 1L, 4'000'000'000L));
    tags.add_ratio(282, 10'000'000, millionths);  // XResolution
    tags.add_ratio(283, 10'000'000, millionths);  // YResolution
    tags.add(296, 3u);                            // ResolutionUnit: cm
    tags.add(317, decimal ? 1u : 2u);             // Predictor: none, difference to the sample on the left
    tags.add(339, decimal ? 3u : 1u);             // SampleFormat: IEEE floating point, unsigned
    tags.finish();
    return file;
}

}  // namespace

std::string height_tiff(const HeightSheet& sheet, const HeightRows& rows) {
    std::vector<std::uint16_t> samples(static_cast<std::size_t>(sheet.columns));
    return tiff_of(sheet, rows, false, [&](std::span<const float> heights, std::vector<std::uint8_t>& bytes) {
        to_samples(sheet, heights, samples);
        std::uint16_t left = 0;
        for (const std::uint16_t sample : samples) {
            const auto difference = static_cast<std::uint16_t>(sample - left);
            left = sample;
            bytes.push_back(static_cast<std::uint8_t>(difference & 0xFF));
            bytes.push_back(static_cast<std::uint8_t>(difference >> 8));
        }
    });
}

std::string height_tiff_decimal(const HeightSheet& sheet, const HeightRows& rows) {
    return tiff_of(sheet, rows, true, [](std::span<const float> heights, std::vector<std::uint8_t>& bytes) {
        for (const float height : heights)
            for (int i = 0; i < 4; ++i)
                bytes.push_back(static_cast<std::uint8_t>(std::bit_cast<std::uint32_t>(height) >> (8 * i)));
    });
}

}  // namespace tactics
