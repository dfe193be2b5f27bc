// SPDX-License-Identifier: Apache-2.0
// How much the lines of a page tell a reader of what people would draw of the scene.
//
// Bits of a page alone grow with every line, whether or not anybody would draw it, so they choose clutter. What counts is what
// they tell of another page, that which people would draw: the mutual information of "there is a line at this place" on the two
// (equation 7 of K. Moustakas, "Handling haptics as a stand-alone medium", WSCG 2013), over places that a finger tells apart. A
// line that nobody would draw tells nothing of it and hides what does; one that is left out is not told.
//
// The reader is a channel, too, and follows so much line and no more. Of a page with twice as much every line is met with half
// the chance, which is as if it were a gap.
#pragma once

namespace tactics {

/// Lengths of line, mm. Where people would draw is known by chances only: lengths are expected ones.
struct AgreedLines {
    double drawn = 0;     ///< on the page
    double agreed = 0;    ///< of these, what people would draw; at most `drawn`
    double wanted = 0;    ///< what people would draw in all, at least `agreed`
    double room = 0;      ///< as much line as the page has places for: its area over `least_apart` of the medium
    double followed = 0;  ///< what a reader follows at most
};

struct AgreedBits {
    double wanted = 0;   ///< H(W), bits a mm of room: of where people would draw a line, as far as anybody could tell it
    double carried = 0;  ///< I, of these, what a reader of the page is told
    double loss() const { return wanted > 0 ? 1 - carried / wanted : 1; }  ///< equation 5; 1 where there is nothing to tell
};
AgreedBits agreed_bits(const AgreedLines& lines);

}  // namespace tactics
