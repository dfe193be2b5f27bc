// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "tests/tactics/readers/pictures.h"

namespace tactics::openimageio_test {
namespace {

Image read_by_openimageio(const Bytes& bytes, const ReadRequest& request = {.longest = 0, .colour = true}) {
    Source source = memory_source(bytes, "test");
    return openimageio().read(source, request);
}

// For a trusted file.
std::string complaint_of_allowed(const Bytes& bytes) {
    try {
        Source source = memory_source(bytes, "test");
        source.allowed = {"psd", "ico"};
        read_picture(source, {});
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

Bytes bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

Bytes joined(const std::string& header, const Bytes& rest) {
    Bytes bytes = bytes_of(header);
    bytes.insert(bytes.end(), rest.begin(), rest.end());
    return bytes;
}

TEST(OpenImageIo, AgreesWithTheOwnReaders) {
    const Image grey = noise_picture(50, 38, 1), colour = noise_picture(50, 38, 3);
    for (const auto& bytes : {png_of(grey), png_of(colour), png_of(colour, true), tiff_of(grey), tiff_of(colour, {.tile = 16}),
                              tiff_of(colour, {.separate = true, .orientation = 6})}) {
        EXPECT_EQ(largest_difference(read_bytes(bytes), read_by_openimageio(bytes)), 0);
        EXPECT_EQ(largest_difference(read_bytes(bytes, {.longest = 20}), read_by_openimageio(bytes, {.longest = 20})), 0);
    }
    Bytes alpha(50 * 38 * 4);
    for (std::size_t i = 0; i < alpha.size(); ++i) alpha[i] = static_cast<unsigned char>(i * 37 % 256);
    const Bytes transparent = png_of(50, 38, 8, PNG_COLOR_TYPE_RGB_ALPHA, alpha);
    EXPECT_EQ(largest_difference(read_bytes(transparent), read_by_openimageio(transparent)), 0);
    const Bytes deep = png_of(25, 38, 16, PNG_COLOR_TYPE_RGB_ALPHA, Bytes(alpha.begin(), alpha.end()));
    EXPECT_LE(largest_difference(read_bytes(deep), read_by_openimageio(deep)), 2);
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const Bytes jpeg = jpeg_of(test_picture(50, 38, 3), {.orientation = orientation});
        EXPECT_LE(largest_difference(read_bytes(jpeg), read_by_openimageio(jpeg)), 2) << orientation;
    }
    const Bytes ink = jpeg_of(test_picture(50, 38, 4), {.adobe = true});
    EXPECT_LE(largest_difference(read_bytes(ink), read_by_openimageio(ink)), 2);
}

TEST(OpenImageIo, ReadsPnm) {
    const Image grey = noise_picture(21, 13, 1), colour = noise_picture(21, 13, 3);
    EXPECT_EQ(largest_difference(read_bytes(joined("P5\n21 13\n255\n", grey.pixels)), grey), 0);
    EXPECT_EQ(largest_difference(read_bytes(joined("P6\n# a remark\n21 13\n255\n", colour.pixels)), colour), 0);
    EXPECT_EQ(read_bytes(bytes_of("P1\n3 1\n0 1 0\n")).pixels, (std::vector<std::uint8_t>{255, 0, 255}));
    EXPECT_EQ(read_bytes(bytes_of("P2\n3 1\n100\n0 50 100\n")).pixels.at(2), 255);
    EXPECT_EQ(read_bytes(joined("P4\n8 1\n", {0xA0})).pixels, (std::vector<std::uint8_t>{0, 255, 0, 255, 255, 255, 255, 255}));
    const Bytes cut = joined("P5\n210 130\n255\n", grey.pixels);
    EXPECT_TRUE(has(complaint(cut), "is damaged at line")) << complaint(cut);
}

TEST(OpenImageIo, ReadsBmpFromBelowAndWithAlpha) {
    const auto number = [](unsigned value) {
        return Bytes{static_cast<unsigned char>(value), static_cast<unsigned char>(value >> 8), 0, 0};
    };
    Bytes bytes = {'B', 'M'};
    for (const unsigned value : {54u + 16, 0u, 54u, 40u, 2u, 2u}) {
        const Bytes four = number(value);
        bytes.insert(bytes.end(), four.begin(), four.end());
    }
    bytes.insert(bytes.end(), {1, 0, 24, 0});
    bytes.resize(54);
    bytes.insert(bytes.end(), {0, 0, 255, 0, 255, 0, 0, 0, 255, 0, 0, 9, 9, 9, 0, 0});  // blue, green, red; from the bottom
    EXPECT_EQ(read_bytes(bytes).pixels, (std::vector<std::uint8_t>{0, 0, 255, 9, 9, 9, 255, 0, 0, 0, 255, 0}));
}

// What a broken download leaves. Where nothing tells, it is at least an error.
TEST(OpenImageIo, SaysThatAFileIsCutShort) {
    const auto bmp = [] {
        Bytes bytes = {'B', 'M', 54 + 4 * 40, 0,  0, 0, 0, 0, 0, 0, 54, 0, 0, 0,  40,
                       0,   0,   0,           13, 0, 0, 0, 4, 0, 0, 0,  1, 0, 24, 0};
        bytes.resize(54 + 4 * 40, 0);
        return bytes;
    }();
    const Bytes gif = joined("GIF89a", {2, 0,    1, 0, 0x91, 0, 0, 0, 0, 0, 10, 20, 30, 255,  0,    0, 0,   0,
                                        0, 0x2C, 0, 0, 0,    0, 2, 0, 1, 0, 0,  2,  2,  0x8C, 0x0A, 0, 0x3B});
    for (const Bytes& whole : {bmp, gif}) {
        ASSERT_EQ(complaint(whole), "");
        // A GIF may end after its last byte of pixels.
        for (std::size_t size = 16; size + (whole == gif ? 4 : 1) <= whole.size(); ++size) {
            const std::string said = complaint({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)});
            EXPECT_TRUE(has(said, "test: is cut short") && has(said, "; get a complete copy of it")) << size << ": " << said;
        }
    }
    const Bytes webp = joined("RIFF\xFF\1", {0, 0, 'W', 'E', 'B', 'P', 'V', 'P', '8', ' ', 0});
    EXPECT_EQ(complaint(webp), "test: is cut short; get a complete copy of it");
    // A wrong length alone does not cause a refusal.
    Bytes liar = bmp;
    liar[3] = 0xFF;
    EXPECT_EQ(complaint(liar), "");
}

TEST(OpenImageIo, ReadsTheFirstFrameOfAGif) {
    // 2 x 1, colours black, white, red; index 1 and the transparent index 2; then a second frame that must not be seen.
    const Bytes frame = {0x2C, 0, 0, 0, 0, 2, 0, 1, 0, 0, 2, 2, 0x8C, 0x0A, 0};  // 4 (clear), 1, 2, 5 (end), 3 bits each
    Bytes bytes = joined("GIF89a", {2, 0, 1, 0, 0x91, 0, 0, 0, 0, 0, 10, 20, 30, 255, 0, 0, 0, 0, 0});
    bytes.insert(bytes.end(), {0x21, 0xF9, 4, 1, 0, 0, 2, 0});
    bytes.insert(bytes.end(), frame.begin(), frame.end());
    bytes.push_back(0x3B);
    const Image read = read_bytes(bytes);
    EXPECT_EQ(read.width, 2);
    EXPECT_EQ(read.pixels, (std::vector<std::uint8_t>{10, 20, 30, 255, 255, 255}));
}

// A Radiance picture without run lengths: red, green, blue with a common exponent.
Bytes radiance(const Bytes& pixels, int width) {
    return joined("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X " + std::to_string(width) + "\n", pixels);
}

TEST(OpenImageIo, TakesRadianceAsLight) {
    // 128/256 * 2^(e - 128): e = 129 is 1, e = 128 is 1/2.
    const Bytes pixels = {128, 128, 128, 129, 128, 128, 128, 128, 0, 0, 0, 0, 128, 0, 0, 129};
    EXPECT_EQ(read_bytes(radiance(pixels, 4)).pixels,
              (std::vector<std::uint8_t>{255, 255, 255, 188, 188, 188, 0, 0, 0, 255, 0, 0}));
    const Bytes dark = {128, 128, 128, 120, 128, 128, 128, 119};  // 1/512 and 1/1024: shown as 1 and 1/2 would be
    const Image read = read_bytes(radiance(dark, 2), {});
    EXPECT_EQ(read.pixels.at(0), 255);
}

// An EXR of float channels without compression (OpenEXR file layout, openexr.com).
Bytes exr(int width, int height, const std::vector<std::string>& names, const std::vector<float>& planes) {
    Bytes bytes;
    const auto put = [&](const void* data, std::size_t size) {
        const auto* from = static_cast<const unsigned char*>(data);
        bytes.insert(bytes.end(), from, from + size);
    };
    const auto number = [&](std::int32_t value) { put(&value, 4); };
    const auto text = [&](const std::string& value) { put(value.c_str(), value.size() + 1); };
    const auto head = [&](const char* name, const char* type, std::int32_t size) {
        text(name);
        text(type);
        number(size);
    };
    number(20000630);
    number(2);
    std::int32_t list = 1;
    for (const auto& name : names) list += static_cast<std::int32_t>(name.size()) + 1 + 16;
    head("channels", "chlist", list);
    for (const auto& name : names) {
        text(name);
        number(2);  // float
        number(0);
        number(1);
        number(1);
    }
    bytes.push_back(0);
    head("compression", "compression", 1);
    bytes.push_back(0);
    for (const char* window : {"dataWindow", "displayWindow"}) {
        head(window, "box2i", 16);
        for (const int value : {0, 0, width - 1, height - 1}) number(value);
    }
    head("lineOrder", "lineOrder", 1);
    bytes.push_back(0);
    const float one = 1, zero = 0;
    head("pixelAspectRatio", "float", 4);
    put(&one, 4);
    head("screenWindowCenter", "v2f", 8);
    put(&zero, 4);
    put(&zero, 4);
    head("screenWindowWidth", "float", 4);
    put(&one, 4);
    bytes.push_back(0);
    const auto line = static_cast<std::size_t>(width) * names.size() * 4;
    std::uint64_t offset = bytes.size() + static_cast<std::size_t>(height) * 8;
    for (int y = 0; y < height; ++y, offset += 8 + line) put(&offset, 8);
    for (int y = 0; y < height; ++y) {
        number(y);
        number(static_cast<std::int32_t>(line));
        put(planes.data() + static_cast<std::size_t>(y) * line / 4, line);
    }
    return bytes;
}

TEST(OpenImageIo, TakesExrAsLight) {
    const Bytes grey = exr(4, 1, {"Y"}, {0, 0.5f, 1, std::nanf("")});
    EXPECT_EQ(read_bytes(grey).pixels, (std::vector<std::uint8_t>{0, 188, 255, 0}));
    // Channels are stored in alphabetical order; alpha is premultiplied: nothing, half covered black, white.
    const Bytes colour = exr(3, 1, {"A", "B", "G", "R"}, {0, 0.5f, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    EXPECT_EQ(read_bytes(colour).pixels, (std::vector<std::uint8_t>{255, 255, 255, 188, 188, 188, 255, 255, 255}));
    const Bytes cut(grey.begin(), grey.end() - 8);
    EXPECT_FALSE(complaint(cut).empty());
}

TEST(OpenImageIo, RefusesClaimsWithoutData) {
    EXPECT_TRUE(has(complaint(joined("GIF89a", {0xFF, 0xFF, 0xFF, 0xFF, 0, 0, 0})), "claims 65535 x 65535 pixels"));
    EXPECT_TRUE(has(complaint(joined("GIF89a", {0x20, 0x4E, 0x20, 0x4E, 0, 0, 0})), "can only be decoded whole"));
    EXPECT_TRUE(has(complaint(bytes_of("P5\n65500 65500\n255\n")), "claims 65500 x 65500 pixels"));
    EXPECT_TRUE(has(complaint(bytes_of("P5\n30000 30000\n255\n")), "is damaged at line 1 of 30000"));
    const Bytes webp = joined("RIFF....WEBPVP8X", {10, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF, 0, 0xFF, 0xFF, 0});
    EXPECT_TRUE(has(complaint(webp), "claims 65536 x 65536 pixels")) << complaint(webp);
    EXPECT_TRUE(
        has(complaint_of_allowed(joined("8BPS", {0, 1, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0xFF, 0xFF, 0, 0, 0xFF, 0xFF, 0, 8, 0, 3})),
            "claims"));
    // Small, with 4 GB of colours.
    EXPECT_TRUE(has(complaint_of_allowed(joined(
                        "8BPS", {0, 1, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 9, 0, 0, 0, 9, 0, 8, 0, 3, 0xFF, 0xFF, 0xFF, 0xB2})),
                    "is cut short"));
}

// An AVIF of 24 x 18 whose file says something else of itself than its compressed picture does.
TEST(OpenImageIo, ReadsNoMoreOfAnAvifThanThereIs) {
    std::ifstream file(TACTICS_SOURCE_DIR "/tests/fuzz/corpus/read/avif", std::ios::binary);
    const std::string avif{std::istreambuf_iterator<char>(file), {}};
    if (has(complaint(bytes_of(avif)), "built without libheif")) GTEST_SKIP() << complaint(bytes_of(avif));
    const Image whole = read_bytes(bytes_of(avif));
    ASSERT_EQ(whole.width, 24);
    ASSERT_EQ(whole.height, 18);
    const auto claiming = [&](int width, int height) {
        std::string text = avif;
        const std::size_t at = text.find("ispe") + 8;
        for (std::size_t i = 0; i < 4; ++i) {
            text[at + i] = static_cast<char>(width >> (24 - 8 * i));
            text[at + 4 + i] = static_cast<char>(height >> (24 - 8 * i));
        }
        return bytes_of(text);
    };
    // Also what would fit into the memory of the picture, whose rows and columns are padded to 64.
    const std::vector<std::pair<int, int>> claims = {{25, 18}, {24, 19}, {64, 64}, {24, 65}, {11288, 18}, {24, 5000}};
    for (const auto& [width, height] : claims) {
        const std::string said = complaint(claiming(width, height));
        EXPECT_TRUE(has(said, "its picture is smaller than it claims")) << width << " x " << height << ": " << said;
    }
    EXPECT_TRUE(has(complaint(claiming(32000, 32000)), "claims 32000 x 32000 pixels"));
    const Image part = read_bytes(claiming(20, 10));
    ASSERT_EQ(part.width, 20);
    ASSERT_EQ(part.height, 10);
    for (int y = 0; y < 10; ++y) EXPECT_TRUE(std::equal(part.row(y), part.row(y) + 20 * part.channels, whole.row(y))) << y;
    // A quarter turn to the left, in the place of the bits of the samples.
    std::string turned = avif;
    turned.replace(turned.find("pixi"), 5, "irot\1");
    const Image left = read_bytes(bytes_of(turned));
    ASSERT_EQ(left.width, 18);
    ASSERT_EQ(left.height, 24);
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 18; ++x) {
            EXPECT_EQ(left.row(y)[x * left.channels], whole.row(x)[(23 - y) * whole.channels]) << x << ", " << y;
        }
}

TEST(OpenImageIo, ServesManyThreadsAtOnce) {
    const Image image = noise_picture(64, 48, 3);
    const Bytes pnm = joined("P6\n64 48\n255\n", image.pixels), cut(pnm.begin(), pnm.end() - 2000);
    std::vector<std::thread> threads;
    std::array<int, 4> wrong{};
    for (std::size_t t = 0; t < wrong.size(); ++t)
        threads.emplace_back([&, t] {
            for (int i = 0; i < 5; ++i) {
                wrong[t] += largest_difference(read_bytes(pnm), image) != 0;
                wrong[t] += !has(complaint(cut), "is damaged at line");
            }
        });
    for (auto& thread : threads) thread.join();
    for (const int count : wrong) EXPECT_EQ(count, 0);
}

// A double free (which comes after the answer), a division by zero and a claim of 22 GB, all of them in OpenImageIO 2.4.
TEST(OpenImageIo, HostileFilesCostThemselvesOnly) {
    const Bytes good = joined("P5\n1 1\n255\n", {7});
    for (const char* name : {"ico-double-free", "ico-sigfpe", "psd-22GB"}) {
        std::ifstream file(std::string(TACTICS_SOURCE_DIR "/tests/fuzz/corpus/read/") + name, std::ios::binary);
        const Bytes hostile{std::istreambuf_iterator<char>(file), {}};
        ASSERT_FALSE(hostile.empty()) << name;
        const std::string said = complaint_of_allowed(hostile);
        EXPECT_TRUE(said.empty() || has(said, "get a fresh copy or convert it to PNG first")) << name << ": " << said;
        EXPECT_EQ(said.empty(), name == std::string_view("ico-double-free")) << said;
        EXPECT_EQ(read_bytes(good).pixels, (std::vector<std::uint8_t>{7})) << name;
    }
}

// What breaks libraries most is read for who asks for it by name, and for each name alone.
TEST(OpenImageIo, ReadsSomeFormatsOnlyWhereTheyAreAskedFor) {
    for (const std::string name : {"psd", "ico"}) {
        std::ifstream file(TACTICS_SOURCE_DIR "/tests/fuzz/corpus/read/" + name, std::ios::binary);
        const Bytes bytes{std::istreambuf_iterator<char>(file), {}};
        const std::string said = complaint(bytes);
        EXPECT_TRUE(has(said, "convert it to PNG first or, if you trust it, add --allow " + name)) << said;
        Source source = memory_source(bytes, "test");
        source.allowed = {name == "psd" ? "ico" : "psd"};
        EXPECT_THROW(inspect_picture(source), Error) << name;
        source.allowed = {name};
        EXPECT_GT(inspect_picture(source).width, 0) << name;
        EXPECT_GT(read_picture(source, {}).height, 0) << name;
    }
}

// The program that reads them is started once and again where it has gone.
TEST(OpenImageIo, SurvivesTheEndOfItsProgram) {
    const Bytes good = joined("P5\n1 1\n255\n", {7});
    ASSERT_EQ(complaint(good), "");
    const auto children = [] {
        std::vector<pid_t> found;
        for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task")) {
            std::ifstream list(entry.path() / "children");
            for (pid_t child = 0; list >> child;) {
                std::ifstream name("/proc/" + std::to_string(child) + "/comm");
                std::string said;
                name >> said;
                if (said.starts_with("tactics-openima")) found.push_back(child);
            }
        }
        return found;
    };
    const auto before = children();
    if (before.empty()) GTEST_SKIP() << "this kernel does not list children";
    ASSERT_EQ(before.size(), 1u);
    kill(before[0], SIGKILL);
    siginfo_t gone{};
    ASSERT_EQ(waitid(P_PID, static_cast<id_t>(before[0]), &gone, WEXITED | WNOWAIT), 0);
    EXPECT_EQ(complaint(good), "");
    EXPECT_EQ(complaint(good), "");
    const auto after = children();
    ASSERT_EQ(after.size(), 1u);
    EXPECT_NE(after[0], before[0]);
}

}  // namespace
}  // namespace tactics::openimageio_test
