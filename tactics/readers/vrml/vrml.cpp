// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/vrml/vrml.h"

#include <optional>

#include "tactics/error.h"
#include "tactics/readers/gzip.h"
#include "tactics/readers/vrml/classic.h"
#include "tactics/readers/vrml/scene.h"

namespace tactics {

namespace {

constexpr std::size_t kHead = 4096;

std::string bytes_of(Source& source) {
    std::string bytes;
    std::rewind(source.file.get());
    while (bytes.size() <= kMostWorldBytes) {
        const std::size_t before = bytes.size();
        constexpr std::size_t kStep = 1u << 20;
        bytes.resize(before + kStep);
        const std::size_t got = std::fread(bytes.data() + before, 1, kStep, source.file.get());
        bytes.resize(before + got);
        if (got < kStep) break;
    }
    if (is_gzip(bytes)) bytes = gunzip(bytes, kMostWorldBytes + 1, source.name);
    if (bytes.size() > kMostWorldBytes)
        throw Error(Fault::failed, source.name,
                    "has over " + std::to_string(kMostWorldBytes >> 20) + " MB of text; save a coarser model");
    return bytes;
}

std::string_view plain_format(std::string_view head) {
    if (head.starts_with("\xef\xbb\xbf")) head.remove_prefix(3);
    if (head.starts_with("#VRML V2")) return "VRML97 model";
    if (head.starts_with("#VRML V1")) return "VRML 1.0 model";
    if (head.starts_with("#X3D V")) return "X3D model";
    if (head.starts_with("#Inventor V") && head.substr(0, head.find('\n')).find("ascii") != std::string_view::npos)
        return "Inventor model";
    return {};
}

}  // namespace

std::string_view vrml_format(std::string_view head) {
    return is_gzip(head) ? plain_format(gunzip_beginning(head, kHead)) : plain_format(head);
}

Model read_vrml(Source& source, std::vector<std::string>& notes) {
    const std::string bytes = bytes_of(source);
    const World world = read_classic_world(bytes, source.name);
    ModelMaker maker(source.name);
    walk_scene(world, maker);
    return maker.finish(notes);
}

}  // namespace tactics
