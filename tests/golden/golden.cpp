// SPDX-License-Identifier: Apache-2.0
#include "tests/golden/golden.h"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "samples/draw/files.h"

namespace tactics::golden {

namespace fs = std::filesystem;

namespace {

fs::path path_of(std::string_view name) {
    return fs::path(TACTICS_SOURCE_DIR) / "tests" / "golden" / (std::string(name) + ".png");
}

Image in_colour(const Image& image) {
    if (image.channels == 3) return image;
    Image colour = make_image(image.width, image.height, 3, image.mm_per_pixel, 0);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        std::fill_n(colour.pixels.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, image.pixels[i]);
    return colour;
}

// Expected, difference (white where they agree, red where they do not) and actual, with a grey bar between them.
void leave_evidence(std::string_view name, const Image& expected, const Image& actual, const fs::path& path) {
    constexpr int kBar = 4;
    const Image a = in_colour(expected), b = in_colour(actual);
    const int width = std::max(a.width, b.width), height = std::max(a.height, b.height);
    Image sheet = make_image(3 * width + 2 * kBar, height, 3, 0, 128);
    for (int y = 0; y < height; ++y) {
        std::uint8_t* row = sheet.row(y);
        if (y < a.height) std::copy_n(a.row(y), a.row_bytes(), row);
        if (y < b.height) std::copy_n(b.row(y), b.row_bytes(), row + 3 * (2 * width + 2 * kBar));
        for (int x = 0; x < std::min(a.width, b.width) && y < std::min(a.height, b.height); ++x) {
            int apart = 0;
            for (int c = 0; c < 3; ++c) apart = std::max(apart, std::abs(a.row(y)[3 * x + c] - b.row(y)[3 * x + c]));
            std::uint8_t* to = row + 3 * (width + kBar + x);
            to[0] = 255;
            to[1] = to[2] = static_cast<std::uint8_t>(apart > kLevels ? std::max(0, 160 - apart) : 255 - apart);
        }
    }
    fs::create_directories(path.parent_path());
    write_png(sheet, path.string());
    ADD_FAILURE() << name << " is not as it was; look at expected | difference | actual in " << path.string()
                  << "\nIf the new one is right, run the test once with TACTICS_REGENERATE=1";
}

double share_apart(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height || a.channels != b.channels) return 1;
    std::size_t apart = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) apart += std::abs(a.pixels[i] - b.pixels[i]) > kLevels ? 1 : 0;
    return static_cast<double>(apart) / static_cast<double>(std::max<std::size_t>(a.pixels.size(), 1));
}

double distance_to(Point p, Point a, Point b) {
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    const double t = square <= 0 ? 0 : std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0);
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

bool is_black(const Drawing& drawing, Point p) {
    for (const Stroke& stroke : drawing.strokes) {
        const double half = stroke.line == LineClass::thin ? 0.35 : stroke.line == LineClass::normal ? 0.5 : 1.5;
        const auto& points = stroke.points;
        for (std::size_t i = stroke.closed ? 0 : 1; i < points.size(); ++i)
            if (distance_to(p, points[i == 0 ? points.size() - 1 : i - 1], points[i]) <= half) return true;
    }
    for (const Area& area : drawing.areas) {
        bool inside = false;
        for (const auto& ring : area.rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point a = ring[i], b = ring[(i + 1) % ring.size()];
                if ((a.y <= p.y) != (b.y <= p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
            }
        if (inside) return area.texture == 0 || std::fmod(p.x + area.texture * p.y, 2) < 0.6;  // stripes, another slant each
    }
    if (!drawing.picture) return false;
    const Image& under = *drawing.picture;
    const int x = std::clamp(static_cast<int>(p.x / drawing.width * under.width), 0, under.width - 1);
    const int y = std::clamp(static_cast<int>(p.y / drawing.height * under.height), 0, under.height - 1);
    return under.row(y)[x * under.channels] < 128;
}

Image picture_of_drawing(const Drawing& drawing, double pixels_per_mm) {
    constexpr int kSamples = 2;  // each way in a pixel
    const int width = std::clamp(static_cast<int>(std::lround(drawing.width * pixels_per_mm)), 1, 512);
    const int height = std::clamp(static_cast<int>(std::lround(drawing.height * pixels_per_mm)), 1, 512);
    Image image = make_image(width, height, 1, 1 / pixels_per_mm, 255);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            int black = 0;
            for (int k = 0; k < kSamples * kSamples; ++k)
                black += is_black(drawing, {(x + (k % kSamples + 0.5) / kSamples) / pixels_per_mm,
                                            (y + (k / kSamples + 0.5) / kSamples) / pixels_per_mm})
                             ? 1
                             : 0;
            image.row(y)[x] = static_cast<std::uint8_t>(255 - 255 * black / (kSamples * kSamples));
        }
    return image;
}

}  // namespace

void write_png(const Image& image, const std::string& path) { samples::write_png(image, path); }

Image read_png(const std::string& path) {
    png_image info{};
    info.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(&info, path.c_str()) == 0) throw std::runtime_error(path + ": " + info.message);
    const int channels = (info.format & PNG_FORMAT_FLAG_COLOR) != 0 ? 3 : 1;
    info.format = channels == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
    if (info.width > 4096 || info.height > 4096) throw std::runtime_error(path + ": too large for a golden image");
    Image image = make_image(static_cast<int>(info.width), static_cast<int>(info.height), channels, 0, 0);
    if (png_image_finish_read(&info, nullptr, image.pixels.data(), 0, nullptr) == 0)
        throw std::runtime_error(path + ": " + info.message);
    return image;
}

bool has_golden(std::string_view name) { return fs::exists(path_of(name)); }
Image read_golden(std::string_view name) { return read_png(path_of(name).string()); }

Image picture_of(const Artwork& artwork, double pixels_per_mm) {
    if (const auto* image = std::get_if<Image>(&artwork)) return *image;
    if (const auto* edges = std::get_if<EdgeMap>(&artwork)) return to_picture(*edges);
    if (const auto* tree = std::get_if<RegionTree>(&artwork)) return to_picture(levels_of(*tree));
    return picture_of_drawing(std::get<Drawing>(artwork), pixels_per_mm);
}

void expect_golden(std::string_view name, const Image& actual, double share) {
    const fs::path path = path_of(name);
    ASSERT_LE(actual.width, 512) << "golden images are small";
    ASSERT_LE(actual.height, 512) << "golden images are small";
    if (const char* ask = std::getenv("TACTICS_REGENERATE"); ask != nullptr && std::string_view(ask) == "1") {
        fs::create_directories(path.parent_path());
        write_png(actual, path.string());
        ADD_FAILURE() << "wrote " << path.string() << "; look at it, then run the test again without TACTICS_REGENERATE";
        return;
    }
    if (!fs::exists(path)) {
        ADD_FAILURE() << "there is no golden image " << path.string() << "; write it with TACTICS_REGENERATE=1 and look at it";
        return;
    }
    const Image expected = read_golden(name);
    if (share_apart(expected, actual) > share)
        leave_evidence(name, expected, actual, fs::path(TACTICS_BINARY_DIR) / "golden-failures" / (std::string(name) + ".png"));
}

}  // namespace tactics::golden
