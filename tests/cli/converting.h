// SPDX-License-Identifier: Apache-2.0
// `tactics convert` as the user meets it: the real program, real files.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/cli/picture.h"
#include "tests/cli/tool.h"

namespace tactics::tests {

inline std::size_t lines_in(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// A folder with a picture in it, and `tactics convert` run there.
class Convert : public testing::Test {
protected:
    Convert() { write_bytes(folder / "disc.tif", disc_picture()); }

    Ending convert(Words words, const std::string& input = "") {
        words.insert(words.begin(), "convert");
        return run_tactics(folder, words, input);
    }

    // Names in the folder, sorted: nothing half written, nothing left behind. Records of --update are not among them.
    std::string names(const std::string& in = "") {
        std::vector<std::string> all;
        for (const auto& entry : std::filesystem::directory_iterator(folder / in))
            if (entry.path().filename() != ".tactics") all.push_back(entry.path().filename().string());
        std::sort(all.begin(), all.end());
        std::string text;
        for (const auto& name : all) text += (text.empty() ? "" : " ") + name;
        return text;
    }

    Folder folder;
};

}  // namespace tactics::tests
