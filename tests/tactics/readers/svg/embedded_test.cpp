// SPDX-License-Identifier: Apache-2.0
// Pictures within an SVG: which are looked at goes by their bytes, whatever they are called.
#include "tactics/readers/svg/embedded.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include "print/base64.h"
#include "tactics/readers/svg/svg.h"

namespace tactics::embedded_test {
namespace {

std::string seed(const std::string& name) {
    std::ifstream file(TACTICS_SOURCE_DIR "/tests/fuzz/corpus/read/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string address_of(const std::string& name) { return "data:image/png;base64," + to_base64(seed(name)); }

TEST(Embedded, PicturesOfTheWebAreLookedAt) {
    for (const char* name : {"png", "jpeg", "webp"}) {
        const auto picture = embedded_picture(address_of(name), {10, 20, 30, 40});
        ASSERT_TRUE(picture) << name;
        EXPECT_GT(picture->width, 0) << name;
    }
}

// The double free and the division by zero of the ICO reader came in by this way, too.
TEST(Embedded, AllOthersAreRefusedUnderAnyName) {
    for (const char* name :
         {"ico", "ico-double-free", "ico-sigfpe", "psd", "psd-22GB", "bmp", "gif", "tga", "exr", "heic", "tiff"}) {
        const std::string address = address_of(name);
        EXPECT_FALSE(embedded_picture(address, {0, 0, 10, 10})) << name;
        const std::string svg =
            "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' width='100mm' height='100mm'>"
            "<image width='50' height='50' xlink:href='" +
            address + "'/></svg>";
        const FoundPage found = read_svg(svg, "page.svg", 10, std::nullopt);
        EXPECT_FALSE(found.page.picture) << name;
        const std::string told = "1 picture is not looked at; one upright PNG, JPEG or WebP within the file is";
        const std::vector<std::string> notes = in_language(found.notes, "en");
        EXPECT_NE(std::find(notes.begin(), notes.end(), told), notes.end()) << name;
    }
    for (const char* start : {"", "RIFF", "RIFF....WEBQ", "\x89PNG", "\xFF\xD8"})
        EXPECT_FALSE(embedded_picture("data:image/png;base64," + to_base64(start), {0, 0, 10, 10})) << start;
}

}  // namespace
}  // namespace tactics::embedded_test
