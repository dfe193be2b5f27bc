// SPDX-License-Identifier: Apache-2.0
#include "tactics/information/agreed_lines.h"

#include <algorithm>
#include <cmath>

namespace tactics {

namespace {

double bits_of(double share) {
    return share > 0 && share < 1 ? -share * std::log2(share) - (1 - share) * std::log2(1 - share) : 0;
}

}  // namespace

AgreedBits agreed_bits(const AgreedLines& lines) {
    if (lines.room <= 0 || lines.wanted <= 0) return {};
    const double met = lines.drawn > lines.followed ? lines.followed / lines.drawn : 1;
    // A page may be fuller than it has places for: then there is a line at each.
    const double felt = std::min(1.0, met * lines.drawn / lines.room);
    const double wanted = std::min(1.0, lines.wanted / lines.room);
    // What is on both is at most either, and at least what the page has no other place for.
    const double both = std::max(std::min({met * lines.agreed / lines.room, felt, wanted}), felt + wanted - 1);
    AgreedBits bits{bits_of(wanted), 0};
    const double left = felt < 1 ? (wanted - both) / (1 - felt) : 0;  // of the places without a line, those that want one
    if (felt > 0)
        bits.carried = std::max(0.0, bits.wanted - felt * bits_of(both / felt) - (1 - felt) * bits_of(std::min(1.0, left)));
    return bits;
}

}  // namespace tactics
