// SPDX-License-Identifier: Apache-2.0
// A folder of three pictures with contour maps, whose charts and dials are known.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "samples/draw/files.h"
#include "tests/cli/tool.h"

namespace tactics::tests {

// A dark disc on a ground, whose edge people drew, and a faint one that they left out.
class EvaluateDiscs : public testing::Test {
protected:
    EvaluateDiscs() {
        constexpr int kSide = 240;
        std::filesystem::create_directories(folder / "set/images");
        std::filesystem::create_directories(folder / "set/gt");
        for (const int radius : {40, 60, 80}) {
            Image picture = make_image(kSide, kSide, 1, 0, 0), map = make_image(kSide, kSide, 1, 0, 0);
            for (int y = 0; y < kSide; ++y)
                for (int x = 0; x < kSide; ++x) {
                    const double away = std::hypot(x - 120, y - 120) - radius;
                    const bool faint = std::hypot(x - 210, y - 30) < 22;
                    picture.row(y)[x] = static_cast<std::uint8_t>(away < 0 ? 40 : faint ? 160 : 200);
                    map.row(y)[x] = std::abs(away) < 0.5 ? 255 : 0;
                }
            const std::string name = "disc" + std::to_string(radius);
            samples::write_png(picture, (folder / ("set/images/" + name + ".png")).string());
            samples::write_png(map, (folder / ("set/gt/" + name + "_gt1.png")).string());
        }
    }

    Ending evaluate(Words words) {
        words.insert(words.begin(), {"evaluate", "set"});
        return run_tactics(folder, words);
    }

    Folder folder;
};

}  // namespace tactics::tests
