// SPDX-License-Identifier: Apache-2.0
// Hostile files of a contour net, and what those that are taken answer to a small picture: every kernel the same.
#include <cstdlib>
#include <string>

#include "filters/net/net.h"
#include "tactics/error.h"
#include "tests/filters/net_twin.h"

namespace {

void try_net(const std::string& bytes, const tactics::Image& image) {
    try {
        const tactics::ContourNet net = tactics::ContourNet::from_bytes(bytes, "fuzz.net");
        const auto first = tactics::logits_of(net, image);
        for (const tactics::NetKernel* kernel : tactics::net_kernels())
            if (tactics::logits_of(net, image, {.kernel = kernel}).values != first.values) std::abort();
        const tactics::EdgeMap map = tactics::contour_map(net, image);
        if (map.strength.size() != static_cast<std::size_t>(image.width * image.height)) std::abort();
        for (const float s : map.strength)
            if (!(s >= 0 && s <= 255)) std::abort();
    } catch (const tactics::Error&) {
    }
}

}  // namespace

// The picture's width and height, then a file. As it is, and with a checksum that is right: no search would find one.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    if (size < 6) return 0;
    const auto image = tactics::pictures::random_colour(1 + data[0] % 40, 1 + data[1] % 40, data[2]);
    const std::string bytes(data + 2, data + size);
    try_net(bytes, image);
    try_net(tactics::net_twin::sealed(bytes.substr(0, bytes.size() - 4)), image);
    return 0;
}
