// SPDX-License-Identifier: Apache-2.0
// The share of a drawing's line that people would have drawn, and the share of their agreed lines that is drawn.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tactics/measure/matching.h"

namespace tactics {

/// So many people make an agreement.
inline constexpr int kAgree = 3;

/// Scores of the pixels of a page's lines, thinned to one pixel, at the picture's size. "Near" is within 0.75 % of the picture's
/// diagonal; pixels are not matched one to one.
struct PageShares {
    double p3 = 0;             ///< share near lines of at least kAgree annotators
    double p1 = 0;             ///< share near a line of any annotator
    std::optional<double> r3;  ///< share of the lines of at least kAgree annotators that is drawn near; nothing: there are none
    std::optional<double> main_object;  ///< share of the main object's outline that is drawn near; nothing: no person drew one
    double diagonals = 0;               ///< pixels of line, in diagonals of the picture
};

/// Whether a page is not fit to be handed out, judged by people's contours: less than two thirds of its line is agreed on, or it
/// has less than 45 % of the agreed lines and less than 60 % of the main object; and the page of one person, `person` (against
/// the others), is better by 0.1, so that disagreement among people is not the cause. Chosen by inspecting 50 pages (every second
/// of BSDS500's 100 photographs for validation): most of the 11 that are poor have lost their animal or person.
bool is_poor(const PageShares& page, const PageShares& person);

/// The drawings of some annotators, prepared for comparison.
class Consensus {
public:
    /// Their maps have one size. At least one.
    explicit Consensus(std::span<const PixelSet> annotators);

    /// Zero for a page without lines.
    PageShares shares_of(const PixelSet& lines) const;

private:
    std::vector<std::uint8_t> near_;                   // of each pixel: how many annotators' lines
    std::vector<std::uint32_t> agreed_;                // the lines of at least kAgree annotators, of each of them
    std::vector<std::vector<std::uint32_t>> objects_;  // of each annotator who drew one: the outline of the main object
    double reach_ = 0;                                 // squared
    double diagonal_ = 0;
};

/// The pixels of the outline of the main object in an annotator's map: of the largest part between the lines that is over 1 % and
/// under 60 % of the picture and does not touch the frame, the line pixels two steps from it at most. Empty if there is none.
std::vector<std::uint32_t> main_outline(const PixelSet& annotator);

/// The annotator whose map has the fewest regions, the first of several; `annotators` is not empty.
std::size_t simplest_of(std::span<const PixelSet> annotators);

/// All but that one.
std::vector<PixelSet> others_than(std::span<const PixelSet> annotators, std::size_t one);

}  // namespace tactics
