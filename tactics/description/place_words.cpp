// SPDX-License-Identifier: Apache-2.0
#include "tactics/description/place_words.h"

#include <algorithm>
#include <array>

namespace tactics {

namespace {

// Row by row. They are named in four ways, as languages decline them.
constexpr std::array<SourceWords, 9> kIn{"in the upper left",  "in the upper middle", "in the upper right",
                                         "in the middle left", "in the middle",       "in the middle right",
                                         "in the lower left",  "in the lower middle", "in the lower right"};
constexpr std::array<SourceWords, 9> kNames{"the upper left",  "the upper middle", "the upper right",
                                            "the middle left", "the middle",       "the middle right",
                                            "the lower left",  "the lower middle", "the lower right"};
constexpr std::array<SourceWords, 9> kFrom{"from the upper left",  "from the upper middle", "from the upper right",
                                           "from the middle left", "from the middle",       "from the middle right",
                                           "from the lower left",  "from the lower middle", "from the lower right"};
constexpr std::array<SourceWords, 9> kTo{"to the upper left",  "to the upper middle", "to the upper right",
                                         "to the middle left", "to the middle",       "to the middle right",
                                         "to the lower left",  "to the lower middle", "to the lower right"};
constexpr std::array<SourceWords, 3> kAcross{"across the upper part", "across the middle", "across the lower part"};
constexpr std::array<SourceWords, 3> kDown{"down the left side", "down the middle", "down the right side"};

constexpr double kLong = 0.55;  // more than one third and half of another

std::size_t third(double at, double length) {
    return length > 0 ? static_cast<std::size_t>(std::clamp(at / length * 3, 0.0, 2.0)) : 1;
}

}  // namespace

std::size_t Ninths::of(Point p) const {
    return third(p.y - frame_.top, frame_.height) * 3 + third(p.x - frame_.left, frame_.width);
}

bool Ninths::wide(const Rect& box) const { return frame_.width > 0 && box.width >= kLong * frame_.width; }
bool Ninths::high(const Rect& box) const { return frame_.height > 0 && box.height >= kLong * frame_.height; }
bool Ninths::spans(const Rect& box) const { return wide(box) != high(box); }

Phrase Ninths::place(const Rect& box) const {
    const std::size_t cell = of(box);
    if (wide(box) && high(box))
        return of_what_ == Frame::page ? phrase("over most of the page") : phrase("over most of the drawing");
    if (wide(box)) return phrase(kAcross[cell / 3]);
    if (high(box)) return phrase(kDown[cell % 3]);
    return phrase(kIn[cell]);
}

Phrase Ninths::place(Point p) const { return phrase(kIn[of(p)]); }

Phrase Ninths::place_on_page(const Rect& box) const {
    return wide(box) && high(box) ? place(box) : phrase("{0} of the page", place(box));
}

Phrase Ninths::course(Point a, Point b) const {
    std::size_t from = of(a), to = of(b);
    if (from % 3 == to % 3 ? from > to : from % 3 > to % 3) std::swap(from, to);
    return phrase("{0} {1}", phrase(kFrom[from]), phrase(kTo[to]));
}

Phrase name_of_ninth(std::size_t ninth) { return phrase(kNames[ninth]); }

}  // namespace tactics
