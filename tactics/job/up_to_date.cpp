// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/up_to_date.h"

#include <algorithm>
#include <filesystem>

#include "tactics/job/page_files.h"

namespace tactics {

bool is_up_to_date(const Wishes& wishes, const Item& item) {
    namespace fs = std::filesystem;
    std::error_code fault;
    const auto changed = [&](const std::string& path) { return fs::last_write_time(path, fault); };
    if (item.input == "-") return false;
    auto newest = changed(item.input);
    if (fault) return false;  // converting it will say what is wrong
    if (!wishes.chain.file.empty()) {
        newest = std::max(newest, changed(wishes.chain.file));
        if (fault) return false;
    }
    if (!item.label_file.empty()) {
        newest = std::max(newest, changed(item.label_file));
        if (fault) return false;
    }
    // What is known of how many pages there are without reading the picture.
    const std::size_t tiles = static_cast<std::size_t>(wishes.sheet.tiles.columns * wishes.sheet.tiles.rows);
    const std::size_t pages = std::max<std::size_t>(tiles, item.labels.empty() ? 1 : 2);
    return std::all_of(item.outputs.begin(), item.outputs.end(), [&](const Output& output) {
        const std::size_t files = output.format->encode_pages != nullptr ? 1 : pages;
        for (std::size_t page = 1; page <= files; ++page) {
            const auto written = changed(path_of_page(output, page));
            if (fault || written < newest) return false;
        }
        return true;
    });
}

}  // namespace tactics
