// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/exr.h"

#include <array>
#include <exception>

#include "tactics/error.h"
#include "tactics/readers/module_door.h"

namespace tactics {

namespace {

// What is behind the module's `user`. Nothing may be thrown through the module, so it is kept till it has returned.
struct Writing {
    const std::function<void(int row, std::span<float> samples)>& rows;
    std::vector<float> row;
    std::string file = {};
    std::exception_ptr thrown = nullptr;

    static const float* next(void* user, int y) {
        Writing& writing = *static_cast<Writing*>(user);
        try {
            if (writing.thrown == nullptr) writing.rows(y, writing.row);
        } catch (...) {
            writing.thrown = std::current_exception();
        }
        return writing.row.data();
    }
    static void take(void* user, const void* bytes, std::size_t size) {
        Writing& writing = *static_cast<Writing*>(user);
        try {
            writing.file.assign(static_cast<const char*>(bytes), size);
        } catch (...) {
            writing.thrown = std::current_exception();
        }
    }
};

}  // namespace

std::string write_exr(int width, int height, const std::vector<std::pair<std::string_view, std::string>>& words,
                      const std::function<void(int row, std::span<float> samples)>& rows) {
    const TacticsOiio& module = openimageio_module("EXR");
    Writing writing{rows, std::vector<float>(static_cast<std::size_t>(width))};
    std::vector<std::string> names;
    for (const auto& [name, text] : words) names.emplace_back(name);
    std::vector<TacticsOiioWord> pairs;
    for (std::size_t i = 0; i < words.size(); ++i) pairs.push_back({names[i].c_str(), words[i].second.c_str()});
    const TacticsOiioPlan plan{width,    height,        pairs.data(), static_cast<int>(pairs.size()),
                               &writing, Writing::next, Writing::take};
    std::array<char, 256> why{};
    const bool good = module.write("openexr", &plan, why.data(), why.size()) != 0;
    if (writing.thrown != nullptr) std::rethrow_exception(writing.thrown);
    if (!good) throw Error(Fault::failed, "EXR", "could not be written: " + std::string(why.data()) + "; write .tif instead");
    return std::move(writing.file);
}

}  // namespace tactics
