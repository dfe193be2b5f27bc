// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/kernel_lists.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "tactics/text/utf8.h"

namespace tactics {

namespace fs = std::filesystem;

std::string line_of(const fs::path& path) {
    std::ifstream file(path);
    std::string text(1024, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, file.gcount())));
    return to_line(text);
}

std::vector<fs::path> entries_of(const fs::path& folder) {
    std::vector<fs::path> entries;
    std::error_code fault;
    for (fs::directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault)) entries.push_back(at->path());
    std::sort(entries.begin(), entries.end());
    return entries;
}

std::string product_of(const fs::path& place) {
    std::error_code fault;
    fs::path folder = fs::canonical(place, fault);
    for (int up = 0; !fault && up < 4 && folder.has_relative_path(); ++up, folder = folder.parent_path()) {
        const std::string product = line_of(folder / "product"), maker = line_of(folder / "manufacturer");
        if (!product.empty()) return maker.empty() ? product : maker + " " + product;
    }
    return "";
}

Phrase note_if_missing(const std::string& root, const std::string& path) {
    return access((root + path).c_str(), F_OK) == 0 ? Phrase() : phrase("the kernel names it, but there is no {0}", path);
}

Phrase note_for(const std::string& root, const std::string& path, std::string_view group) {
    if (Phrase missing = note_if_missing(root, path); !missing.empty()) return missing;
    if (access((root + path).c_str(), W_OK) != 0)
        return phrase("you are not permitted to use it: become a member of the group {0} (sudo adduser $USER {0})", group);
    return {};
}

}  // namespace tactics
