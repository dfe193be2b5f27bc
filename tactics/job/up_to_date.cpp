// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/up_to_date.h"

#include <algorithm>
#include <filesystem>

#include "tactics/job/page_files.h"

namespace tactics {

namespace {

bool is_there(const std::string& path) {
    std::error_code fault;
    return std::filesystem::is_regular_file(path, fault);
}

// Empty: it is as it would be made.
std::vector<std::string> reasons_of(const MadeWith& settings, const Item& item, const Output& output) {
    if (!is_there(output.path)) return {output.path + " is not there"};
    const auto now = made_with(settings, item, output);
    if (!now) return {"the picture cannot be looked at"};  // converting it will say why
    const auto record = record_of(output);
    if (!record) return {"how " + output.path + " was made is not known"};
    for (std::size_t file = 2; file <= record->files; ++file)
        if (const std::string path = path_of_page(output, file); !is_there(path)) return {path + " is not there"};
    return differences(record->with, *now);
}

}  // namespace

std::optional<std::vector<std::string>> reasons_to_make(const MadeWith& settings, const Item& item) {
    std::vector<std::string> all;
    bool any = false;
    for (const Output& output : item.outputs) {
        any = any || is_there(output.path);
        for (std::string& reason : reasons_of(settings, item, output))
            if (std::find(all.begin(), all.end(), reason) == all.end()) all.push_back(std::move(reason));
    }
    if (all.empty()) return std::nullopt;
    return any ? all : std::vector<std::string>{};
}

}  // namespace tactics
