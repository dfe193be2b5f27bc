// SPDX-License-Identifier: Apache-2.0
// Black for white: for white drawings on dark ground, chalk boards, negatives.
#include "tactics/filter.h"

namespace tactics {

namespace {

Artwork apply_invert(Artwork artwork, const Settings&) {
    for (auto& sample : std::get<Image>(artwork).pixels) sample = static_cast<std::uint8_t>(255 - sample);
    return artwork;
}

}  // namespace

extern const Filter invert_filter;
const Filter invert_filter{
    .name = "invert",
    .summary = "swaps black and white",
    .takes = static_cast<Kinds>(Kind::picture),
    .gives = static_cast<Kinds>(Kind::picture),
    .apply = apply_invert,
};

}  // namespace tactics
