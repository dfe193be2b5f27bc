// SPDX-License-Identifier: Apache-2.0
// Borders between parts of a picture, taken out one after the other.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "filters/outline_choice.h"
#include "tactics/region_tree.h"

namespace tactics {

/// All that two parts have between them is one border.
class PartBorders {
public:
    /// Gain and length of each arc, if it is drawn.
    PartBorders(const RegionTree& tree, const Parts& parts, std::span<const double> gain, std::span<const double> length);

    /// The border that gains least, again and again, as long as it loses more than `least`.
    void take_out_losing(double least);
    /// The border that gains least for its length, again and again, until no more than `most` is drawn.
    void take_out_until(double most);

    double drawn() const { return drawn_; }
    /// Numbered by parts that were there.
    Parts parts() const;

private:
    struct Border {
        double gain = 0, length = 0;
    };

    template <typename Key, typename Ends>
    void take_out(Key key, Ends ends);
    void merge(std::uint32_t into, std::uint32_t from);
    std::uint32_t root_of(std::uint32_t part) const;

    std::vector<std::uint32_t> part_;                      // of each face
    mutable std::vector<std::uint32_t> root_;              // of each part
    std::vector<std::map<std::uint32_t, Border>> beside_;  // of each part that is left: its neighbours
    double drawn_ = 0;
};

}  // namespace tactics
