// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/vrml/vrml.h"

#include <algorithm>
#include <iterator>

#include "tactics/error.h"
#include "tactics/readers/gzip.h"
#include "tactics/readers/vrml/classic.h"
#include "tactics/readers/vrml/scene_walk.h"
#include "tactics/readers/vrml/state_walk.h"
#include "tactics/readers/vrml/x3d_xml.h"

namespace tactics {

namespace {

constexpr std::size_t kHead = 4096;

std::string bytes_of(Source& source) {
    if (source.file == nullptr) throw Error(Fault::failed, source.name, phrase("is empty; get a complete copy of it"));
    std::string bytes;
    std::rewind(source.file.get());
    for (std::size_t step = 1u << 16; bytes.size() <= kMostWorldBytes; step = std::min<std::size_t>(2 * step, 16u << 20)) {
        const std::size_t before = bytes.size();
        bytes.resize(before + step);
        const std::size_t got = std::fread(bytes.data() + before, 1, step, source.file.get());
        bytes.resize(before + got);
        if (got < step) break;
    }
    if (is_gzip(bytes)) bytes = gunzip(bytes, kMostWorldBytes + 1, source.name);
    if (bytes.size() > kMostWorldBytes)
        throw Error(Fault::failed, source.name,
                    phrase("has over {0} MB of text; save a coarser model", std::to_string(kMostWorldBytes >> 20)));
    return bytes;
}

bool is_markup(std::string_view text) {
    const auto begin = text.find_first_not_of(" \t\r\n");
    return begin != std::string_view::npos && text[begin] == '<';
}

std::string_view plain_format(std::string_view head) {
    std::string plain;
    // UTF-16, in which a letter below 80h has a byte 0.
    if (head.starts_with("\xff\xfe") || head.starts_with("\xfe\xff")) {
        std::copy_if(head.begin() + 2, head.end(), std::back_inserter(plain), [](char c) { return c != '\0'; });
        head = plain;
    }
    if (head.starts_with("\xef\xbb\xbf")) head.remove_prefix(3);
    head.remove_prefix(std::min(head.find_first_not_of(" \t\r\n"), head.size()));  // which no standard has, and some files
    if (is_markup(head) && head.find("<X3D") != std::string_view::npos) return "X3D model";
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

Model read_vrml(Source& source, std::vector<Phrase>& notes) {
    const std::string bytes = bytes_of(source);
    const bool classic = bytes.find('#') < bytes.find('<');  // of which one is the first letter
    const World world = classic ? read_classic_world(bytes, source.name) : read_xml_world(bytes, source.name);
    ModelMaker maker(source.name);
    if (world.dialect == World::Dialect::vrml1)
        walk_states(world, maker);
    else
        walk_scene(world, maker);
    return maker.finish(notes);
}

}  // namespace tactics
