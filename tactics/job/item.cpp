// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/item.h"

#include "tactics/error.h"

namespace tactics {

Output output_to(const std::string& path) {
    const Format* format = format_of_path(path);
    if (format == nullptr) throw Error(Fault::usage, path, phrase("its ending names no format; end it in .pdf, for example"));
    return {format, path, ""};
}

std::string stem_of(std::string_view path) {
    if (path == "-") return "standard-input";
    while (path.size() > 1 && path.back() == '/') path.remove_suffix(1);
    const auto slash = path.rfind('/');
    if (slash != std::string_view::npos) path.remove_prefix(slash + 1);
    const auto dot = path.rfind('.');
    return std::string(dot == std::string_view::npos || dot == 0 ? path : path.substr(0, dot));
}

}  // namespace tactics
