// SPDX-License-Identifier: Apache-2.0
#include "cli/files_from.h"

#include <algorithm>
#include <cstdio>

#include "tactics/error.h"
#include "tactics/readers/read.h"

namespace tactics {

namespace {

constexpr std::size_t kMostBytes = 64u << 20;  // a million names of 64 bytes

std::string bytes_of_list(const std::string& path) {
    const Source source = open_source(path);
    std::string text;
    char part[1 << 16];
    for (std::size_t size = 0; (size = std::fread(part, 1, sizeof part, source.file.get())) > 0;) {
        text.append(part, size);
        if (text.size() > kMostBytes)
            throw Error(Fault::failed, source.name, phrase("this list of files has over 64 MB; cut it into parts"));
    }
    if (std::ferror(source.file.get()) != 0) throw Error(Fault::failed, source.name, phrase("it cannot be read"));
    return text;
}

}  // namespace

std::vector<std::string> names_in(std::string_view list, bool null) {
    std::vector<std::string> names;
    while (!list.empty()) {
        const auto end = std::min(list.find(null ? '\0' : '\n'), list.size());
        std::string_view name = list.substr(0, end);
        list.remove_prefix(std::min(end + 1, list.size()));
        if (!null && name.ends_with('\r')) name.remove_suffix(1);
        if (!name.empty()) names.emplace_back(name);
    }
    return names;
}

std::vector<std::string> named_files(const Given& given) {
    std::vector<std::string> names = given.words;
    if (!given.has("--files-from")) {
        if (given.has("--null"))
            throw Error(Fault::usage, "--null", phrase("it is about the list of --files-from, and none is named; leave it out"));
        return names;
    }
    const std::string path = given.value("--files-from");
    const std::string list = bytes_of_list(path);
    if (!given.has("--null") && list.find('\0') != std::string::npos)
        throw Error(Fault::usage, "--files-from", phrase("there are zero bytes in this list; add --null if they part its names"));
    for (std::string& name : names_in(list, given.has("--null"))) names.push_back(std::move(name));
    if (names.empty()) throw Error(Fault::usage, "--files-from", phrase("this list names no picture"));
    if (path == "-" && std::find(names.begin(), names.end(), "-") != names.end())
        throw Error(Fault::usage, "--files-from", phrase("standard input (-) is the list, so it cannot be a picture, too"));
    return names;
}

}  // namespace tactics
