// SPDX-License-Identifier: Apache-2.0
// Pages as other programs see them: rendered by poppler, Ghostscript and librsvg, or decoded by libpng and libtiff.
#pragma once

#include <gtest/gtest.h>
#include <png.h>
#include <tiffio.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "print/format.h"

namespace tactics::rendered {

/// Black and white pixels; outside is white.
struct Pixels {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> black;  ///< one byte a pixel, 0 or 1

    bool at(int x, int y) const {
        return x >= 0 && y >= 0 && x < width && y < height &&
               black[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] != 0;
    }
    bool near(int x, int y, int reach) const {
        for (int dy = -reach; dy <= reach; ++dy)
            for (int dx = -reach; dx <= reach; ++dx)
                if (at(x + dx, y + dy)) return true;
        return false;
    }
    /// Black pixels within columns [left, right) and rows [top, bottom).
    long count(int left, int top, int right, int bottom) const {
        long sum = 0;
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) sum += at(x, y) ? 1 : 0;
        return sum;
    }
    long count() const { return count(0, 0, width, height); }
};

/// Black pixels of one that have no black pixel of the other within `reach`, both ways.
inline long disagreements(const Pixels& a, const Pixels& b, int reach) {
    long sum = 0;
    for (const auto& [one, other] : {std::pair{&a, &b}, std::pair{&b, &a}})
        for (int y = 0; y < one->height; ++y)
            for (int x = 0; x < one->width; ++x)
                if (one->at(x, y) && !other->near(x, y, reach)) ++sum;
    return sum;
}

inline std::string read_file(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// PBM (P4) or PGM (P5, black below 128).
inline Pixels parse_pnm(const std::string& bytes) {
    Pixels pixels;
    char kind = 0;
    int used = 0, most = 1;
    if (std::sscanf(bytes.c_str(), "P%c", &kind) != 1) return pixels;
    std::size_t at = 2;
    const auto number = [&] {
        while (at < bytes.size() && (bytes[at] == '#' || std::isspace(static_cast<unsigned char>(bytes[at])))) {
            if (bytes[at] == '#') at = bytes.find('\n', at);
            ++at;
        }
        int value = 0;
        if (std::sscanf(bytes.c_str() + at, "%d%n", &value, &used) == 1) at += static_cast<std::size_t>(used);
        return value;
    };
    pixels.width = number();
    pixels.height = number();
    if (kind == '5') most = number();
    ++at;
    const auto width = static_cast<std::size_t>(pixels.width), height = static_cast<std::size_t>(pixels.height);
    const std::size_t row = kind == '4' ? (width + 7) / 8 : width;
    if ((kind != '4' && kind != '5') || bytes.size() < at + row * height) return {};
    pixels.black.resize(width * height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            const auto byte = static_cast<unsigned char>(bytes[at + y * row + (kind == '4' ? x / 8 : x)]);
            const bool black = kind == '4' ? ((byte >> (7 - x % 8)) & 1) != 0 : byte * 2 <= most;
            pixels.black[y * width + x] = black ? 1 : 0;
        }
    return pixels;
}

inline Pixels parse_png(const std::string& bytes) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    Pixels pixels;
    if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) return pixels;
    image.format = PNG_FORMAT_GRAY;
    pixels.black.resize(PNG_IMAGE_SIZE(image));
    if (png_image_finish_read(&image, nullptr, pixels.black.data(), 0, nullptr) == 0) return {};
    for (auto& pixel : pixels.black) pixel = pixel < 128;
    pixels.width = static_cast<int>(image.width);
    pixels.height = static_cast<int>(image.height);
    return pixels;
}

/// A folder that is gone with its files at the end of the test.
class FileFolder {
public:
    FileFolder() {
        const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
        path_ = std::filesystem::temp_directory_path() /
                (std::string("tactics-") + test->test_suite_name() + "-" + test->name() + "-" + std::to_string(getpid()));
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    ~FileFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    FileFolder(const FileFolder&) = delete;
    FileFolder& operator=(const FileFolder&) = delete;
    std::string file(const std::string& name) const { return (path_ / name).string(); }
    std::string save(const std::string& name, const std::string& bytes) const {
        std::ofstream(file(name), std::ios::binary) << bytes;
        return file(name);
    }

private:
    std::filesystem::path path_;
};

inline bool have_tool(const std::string& name) { return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0; }

#define NEED_TOOL(name) \
    if (!tactics::rendered::have_tool(name)) GTEST_SKIP() << name << " is not installed"

/// What a command prints, both streams; its exit code goes into `code`.
inline std::string output_of(const FileFolder& folder, const std::string& command, int* code = nullptr) {
    const int result = std::system((command + " >" + folder.file("output") + " 2>&1").c_str());
    if (code != nullptr) *code = result;
    return read_file(folder.file("output"));
}

using Values = std::vector<std::pair<std::string, std::string>>;
inline std::string encode(const Page& page, const std::string& format, const Values& values = {}) {
    const Format* found = find_format(format);
    if (found == nullptr) throw std::logic_error("no format " + format);
    Settings settings(found->options);
    for (const auto& [name, value] : values) settings.set(name, value, "test", format);
    return found->encode(page, settings);
}

// Both renderers blacken every pixel that is touched when they draw in black and white (PLRM 7.5, scan conversion): a line
// comes out a device pixel wider. So they draw in grey, four by four samples a pixel, and a pixel counts from half on.

inline Pixels by_poppler(const FileFolder& folder, const std::string& pdf, int dpi) {
    const std::string in = folder.save("poppler.pdf", pdf);
    const std::string said =
        output_of(folder, "pdftoppm -gray -singlefile -r " + std::to_string(dpi) + " " + in + " " + folder.file("poppler"));
    EXPECT_EQ(said, "");
    return parse_pnm(read_file(folder.file("poppler.pgm")));
}

/// PDF or PostScript.
inline Pixels by_ghostscript(const FileFolder& folder, const std::string& bytes, int dpi) {
    const std::string in = folder.save("ghostscript.in", bytes);
    const std::string grey = "-sDEVICE=pgmraw -dGraphicsAlphaBits=4 -dTextAlphaBits=4 ";
    const std::string said = output_of(folder, "gs -q -dBATCH -dNOPAUSE " + grey + "-r" + std::to_string(dpi) +
                                                   " -sOutputFile=" + folder.file("ghostscript.pgm") + " " + in);
    EXPECT_EQ(said, "");
    return parse_pnm(read_file(folder.file("ghostscript.pgm")));
}

/// SVG.
inline Pixels by_librsvg(const FileFolder& folder, const std::string& svg, int dpi) {
    const std::string resolution = std::to_string(dpi), in = folder.save("librsvg.svg", svg);
    const std::string said = output_of(folder, "rsvg-convert --background-color white -d " + resolution + " -p " + resolution +
                                                   " -o " + folder.file("librsvg.png") + " " + in);
    EXPECT_EQ(said, "");
    return parse_png(read_file(folder.file("librsvg.png")));
}

inline Pixels by_libtiff(const FileFolder& folder, const std::string& bytes) {
    Pixels pixels;
    TIFF* tiff = TIFFOpen(folder.save("page.tiff", bytes).c_str(), "r");
    if (tiff == nullptr) return pixels;
    std::uint16_t photometric = 0;
    std::uint32_t width = 0, height = 0;
    TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &width);
    TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &height);
    TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &photometric);
    const unsigned black = photometric == PHOTOMETRIC_MINISWHITE ? 1 : 0;
    std::vector<std::uint8_t> row(static_cast<std::size_t>(TIFFScanlineSize(tiff)));
    for (std::uint32_t y = 0; y < height; ++y) {
        EXPECT_EQ(TIFFReadScanline(tiff, row.data(), y, 0), 1);
        for (std::uint32_t x = 0; x < width; ++x) pixels.black.push_back(((row[x / 8] >> (7 - x % 8)) & 1u) == black);
    }
    TIFFClose(tiff);
    pixels.width = static_cast<int>(width);
    pixels.height = static_cast<int>(height);
    return pixels;
}

}  // namespace tactics::rendered
