// SPDX-License-Identifier: Apache-2.0
// A page said in words: how large it is, how much is on it, what its main things are and where they lie. For who cannot
// see it and wants to know what the hands will meet; the same words are the alternative text of the files. In the language of the
// page, if there is a catalogue for it (tactics/text/catalogue.h), else in English.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tactics/page.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// One of the main things: a line or a filled area.
struct Thing {
    bool area = false;
    std::size_t index = 0;  ///< of Page::strokes; or of Page::areas and then, counted on, of Page::textured
    Rect box;
    double length = 0;  ///< mm, of the line or of the longest outline of the area
    Phrase what;        ///< "A circle, 5 cm across"
    Phrase place;       ///< "in the upper left"
    Phrase relations;   ///< "It lies inside number 2." or empty
    int texture = 0;    ///< of an area: 0 is black
};

struct Description {
    std::string language;         ///< the page's, in which lines_of gives the words
    std::string title;            ///< as on the page; empty = none
    Phrase sheet;                 ///< "A4 portrait, 21 cm wide and 29.7 cm high"
    std::vector<Phrase> amounts;  ///< sentences: how much there is, which words stand on it
    std::vector<Phrase> objects;  ///< sentences: each named thing and where it lies; then which are not drawn, and why
    std::vector<Thing> things;    ///< at most seven, from top to bottom, then from left to right
    Phrase rest;                  ///< a sentence on what is not among them; empty if nothing is
};

/// Depends on the page alone. Takes time in proportion to the points of the page.
Description describe(const Page& page);

/// Lines to be read one by one. No line end at the end.
std::vector<std::string> lines_of(const Description& description);

/// What stands in place of the drawing for who cannot see it: a person's words if the page has them, else our own on one
/// line. The title is not among them: files say it elsewhere.
std::string alternative_text(const Page& page, Description description);
/// The language of that text: the page's, or English where our own words have no catalogue for it.
std::string alternative_language(const Page& page);

}  // namespace tactics
