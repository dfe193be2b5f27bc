// SPDX-License-Identifier: Apache-2.0
// draw_samples FOLDER [SIZE [NAME...]]: draws all samples, or those named, with a longer side of SIZE pixels.
// draw_samples --list: one line each, FILE tab TITLE.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "samples/draw/files.h"
#include "samples/draw/scenes.h"
#include "tactics/units.h"

int main(int count, char** words) {
    using namespace tactics::samples;
    const auto file_name = [](const Scene& scene) { return std::string(scene.name) + (scene.photograph ? ".jpg" : ".png"); };
    if (count == 2 && std::string_view(words[1]) == "--list") {
        for (const Scene& scene : scenes()) std::printf("%s\t%s\n", file_name(scene).c_str(), std::string(scene.title).c_str());
        return 0;
    }
    constexpr int kSize = 900, kLargest = 20'000;
    const std::vector<std::string_view> names(words + (count < 3 ? count : 3), words + count);
    const auto size = count > 2 ? tactics::parse_number(words[2]) : kSize;
    if (count < 2 || !size || *size < 16 || *size > kLargest) {
        std::fprintf(stderr, "usage: draw_samples FOLDER [SIZE [NAME...]], or draw_samples --list; SIZE is 16 to %d pixels\n",
                     kLargest);
        return 1;
    }
    for (const auto name : names) {
        bool known = false;
        for (const Scene& scene : scenes()) known = known || scene.name == name;
        if (!known) {
            std::fprintf(stderr, "draw_samples: there is no sample \"%s\"\n", std::string(name).c_str());
            return 1;
        }
    }
    try {
        const std::filesystem::path folder(words[1]);
        std::filesystem::create_directories(folder);
        for (const Scene& scene : scenes()) {
            if (!names.empty() && std::find(names.begin(), names.end(), scene.name) == names.end()) continue;
            const tactics::Image image = draw_scene(scene.name, static_cast<int>(*size));
            const std::string path = (folder / file_name(scene)).string();
            if (scene.photograph)
                write_jpeg(image, path);
            else
                write_png(image, path);
            std::printf("%s\n", path.c_str());
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "draw_samples: %s\n", error.what());
        return 2;
    }
    return 0;
}
