// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/own_layers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tactics/layout/own_marks.h"

namespace tactics {

namespace {

const Medium* medium_named(std::string_view name) {
    const auto all = media();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Medium& medium) { return medium.name == name; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace

std::string_view layer_of(const PageStroke& stroke, const Page& page) {
    switch (stroke.role) {
        case Role::pattern:
        case Role::grid: return marks::kGround;
        case Role::lead:
        case Role::scale:
        case Role::mark: return marks::kWordsLayer;
        case Role::tick: return marks::kInner;
        case Role::line:
        case Role::dash:
        case Role::dots:
        case Role::arrow:
        case Role::symbol:
        case Role::axis: break;
    }
    if (stroke.inner) return marks::kInner;
    const Medium* medium = medium_named(page.medium);
    const bool thin = medium != nullptr && stroke.width < medium->line - kPageStep / 2;
    return thin ? marks::kInner : marks::kMain;
}

std::string_view layer_of(const Area& area) { return area.role == Role::line ? marks::kGround : marks::kMain; }

std::string mark_of(const std::vector<Area>& areas) {
    std::uint64_t mark = 14695981039346656037u;  // FNV-1a of 64 bits
    const auto add = [&](long number) {
        for (int i = 0; i < 4; ++i) {
            mark ^= static_cast<std::uint64_t>(number >> (8 * i) & 0xff);
            mark *= 1099511628211u;
        }
    };
    for (const Area& area : areas) {
        add(area.texture);
        for (const auto& ring : area.rings) {
            add(static_cast<long>(ring.size()));
            for (const Point& p : ring) {
                add(std::lround(p.x / kPageStep));
                add(std::lround(p.y / kPageStep));
            }
        }
    }
    return std::to_string(mark);
}

double width_in_layer(std::string_view layer, std::string_view medium) {
    const Medium* known = medium_named(medium);
    if (known == nullptr) return 0;
    return width_of(layer == marks::kMain ? LineClass::normal : LineClass::thin, *known);
}

Role role_in_layer(std::string_view layer) { return layer == marks::kWordsLayer ? Role::lead : Role::line; }

}  // namespace tactics
