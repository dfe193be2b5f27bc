// SPDX-License-Identifier: Apache-2.0
// Print on a slope, turned upright for the readers, and put back where it was.
#pragma once

#include <vector>

#include "tactics/lettering/lettering.h"
#include "tactics/lettering/sloped_print.h"

namespace tactics {

/// A picture whose print on a slope stands upright below it, so that it is found and read as all other print is.
class TurnedPrint {
public:
    explicit TurnedPrint(Image grey);

    const Image& picture() const { return sloped_.empty() ? grey_ : turned_; }
    bool any() const { return !sloped_.empty(); }
    const Image& given() const { return grey_; }
    /// Of words in `picture()`: those that stand below it come back to where they are in the picture that was given, each piece
    /// of sloped print as one. What of that is not sure as a whole is told, and out of the lines. False, and nothing done, if
    /// it was read as no words, and so may be marks of a plot.
    bool put_back(Lettering& lettering) const;

private:
    struct Patch {
        PixelBox box;          ///< in the turned picture
        double along, across;  ///< of its corner, as seen along the slope
    };
    void erase_from(Image& picture, const SlopedWords& words) const;
    void set_upright(const SlopedWords& words, const Patch& patch);
    Point end_of(const SlopedWords& words) const;
    PrintedWords told(std::size_t which, const std::vector<const PrintedWords*>& read) const;

    Image grey_, turned_;
    std::vector<SlopedWords> sloped_;
    std::vector<Patch> patches_;
};

}  // namespace tactics
