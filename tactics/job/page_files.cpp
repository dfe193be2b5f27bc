// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/page_files.h"

#include "tactics/error.h"

namespace tactics {

namespace {

// The identity of a file behind different paths: it does not change when the file appears or is replaced.
std::string place_of(const std::string& path, const Disk& disk) {
    const auto slash = path.rfind('/');
    const std::string folder = slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
    return disk.identity(folder) + "/" + path.substr(slash == std::string::npos ? 0 : slash + 1);
}

bool is_taken(const std::set<std::string>& taken, const std::string& path, const Disk& disk) {
    return taken.contains(disk.identity(path)) || taken.contains(place_of(path, disk));
}

}  // namespace

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

std::set<std::string> taken_by(std::span<const Item> items, const Disk& disk) {
    std::set<std::string> taken;
    for (const Item& item : items) {
        if (item.input != "-") taken.insert(disk.identity(item.input));
        for (const Output& output : item.outputs)
            if (output.path != "-" && !output.path.empty()) taken.insert(place_of(output.path, disk));
    }
    return taken;
}

void check_page_files(const Output& output, std::size_t files, const std::set<std::string>& taken, const Disk& disk) {
    if (files == 1) return;
    if (output.path == "-" || output.path == "/dev/stdout")
        throw Error(Fault::usage, "standard output",
                    phrase("there are {0} pages, and {1} holds one; write to a file, which gets others beside it, or choose pdf",
                           std::to_string(files), output.format->name));
    for (std::size_t page = 2; page <= files; ++page)
        if (const std::string path = path_of_page(output, page); is_taken(taken, path, disk))
            throw Error(
                Fault::usage, path,
                phrase("page {0} of {1} would be written here, over a picture or another page; choose another name or folder",
                       std::to_string(page), output.path));
}

std::string left_over_behind(const Output& output, std::size_t files, const std::set<std::string>& taken, const Disk& disk) {
    if (output.format->encode_pages != nullptr || output.path == "-" || files == 0) return "";
    const std::string next = path_of_page(output, files + 1);
    return disk.exists(next) && !is_taken(taken, next, disk) ? next : "";
}

}  // namespace tactics
