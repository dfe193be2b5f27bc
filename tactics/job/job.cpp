// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/job.h"

#include <filesystem>

#include "tactics/error.h"

namespace tactics {

// Stays the same while a file appears or is replaced.
std::string place_of(const std::string& path, const Disk& disk) {
    const auto slash = path.rfind('/');
    const std::string folder = slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
    return disk.identity(folder) + "/" + path.substr(slash == std::string::npos ? 0 : slash + 1);
}

Output output_to(const std::string& path) {
    const Format* format = format_of_path(path);
    if (format == nullptr) throw Error(Fault::usage, path, "its ending names no format; end it in .pdf, for example");
    return {format, path, ""};
}

std::string path_of_page(const Output& output, std::size_t number) {
    if (number == 1) return output.path;
    std::size_t ending = ending_size(*output.format, output.path);
    if (ending == 0) {  // png:page.img
        const auto dot = output.path.rfind('.'), slash = output.path.rfind('/');
        const std::size_t name = slash == std::string::npos ? 0 : slash + 1;
        if (dot != std::string::npos && dot > name) ending = output.path.size() - dot;
    }
    std::string path = output.path;
    return path.insert(path.size() - ending, "-" + std::to_string(number));
}

std::set<std::string> taken_by(const std::vector<Job>& jobs, const Disk& disk) {
    std::set<std::string> taken;
    for (const Job& job : jobs) {
        if (job.input != "-") taken.insert(disk.identity(job.input));
        for (const Output& output : job.outputs)
            if (output.path != "-" && !output.path.empty()) taken.insert(place_of(output.path, disk));
    }
    return taken;
}

bool is_taken(const std::set<std::string>& taken, const std::string& path, const Disk& disk) {
    return taken.contains(disk.identity(path)) || taken.contains(place_of(path, disk));
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
