// SPDX-License-Identifier: Apache-2.0
// How a page is spelled in an SVG of our own, for who writes it and who reads it back. Drawing programs keep attributes that they
// do not know, so that what they have changed tells itself apart from what they have not.
#pragma once

#include <array>
#include <string_view>

namespace tactics::marks {

/// On the root: which spelling this is. A file with another one is read as one of another maker.
inline constexpr std::string_view kVersion = "data-tactics-page", kThisVersion = "1";
/// On the root, too: lengths in mm, exact, as the shortest decimal numbers that are read as the page's own.
inline constexpr std::string_view kSize = "data-tactics-size",           // width height
    kLive = "data-tactics-live", kDrawing = "data-tactics-drawing",      // left top width height
    kMedium = "data-tactics-medium",                                     // its name
    kCell = "data-tactics-cell",                                         // dot, cell and line pitch, dot
    kDot = "data-tactics-dot",                                           // of the page's braille
    kBed = "data-tactics-bed",                                           // first x y, raster, dots down
    kTable = "data-tactics-table", kLanguage = "data-tactics-language",  // as Page has them
    kTitle = "data-tactics-title", kCaption = "data-tactics-caption", kDescription = "data-tactics-description",
                                  kIsKey = "data-tactics-is-key",
                                  kTextured = "data-tactics-textured",  // mark_of its areas with a texture
    kScale = "data-tactics-scale";  // length, real length, left top width height; its text in kText

/// On a group: that it is a layer, and which (kLayers).
inline constexpr std::string_view kLayer = "data-tactics-layer";

/// On a line, an area, a line of braille or of print: its number among those of the page, from 0.
inline constexpr std::string_view kNumber = "data-tactics-n";
/// On a line that is drawn as curves: its path as it was written, and the points that it stands for, in hundredths of a
/// millimetre, each from the one before it.
inline constexpr std::string_view kPath = "data-tactics-d", kPoints = "data-tactics-line";
/// On a line of braille the middle of its first dot; on a line of print its left end and its size; on the picture its place; of a
/// region the place within.
inline constexpr std::string_view kAt = "data-tactics-at";
/// On whatever sets words: their number. On a text what it said when it was written.
inline constexpr std::string_view kWords = "data-tactics-words", kText = "data-tactics-text";

/// In the group that is not shown, each in an element of its own: what is not drawn. Words: kWords, kText and these.
inline constexpr std::string_view kKind = "data-tactics-kind", kKey = "data-tactics-key",
                                  kAnchor = "data-tactics-anchor",  // x y across down
    kWithin = "data-tactics-within",                                // mm
    kOptional = "data-tactics-optional";                            // "1"
/// A name of a thing: kName with its number, kText, kKey, kWords, and where the thing is and the words are: x y left top width
/// height in kAt. A name that was left out: kLeftOut with its number, kText, kAt with x y, kWithin, kOptional, kOrigin.
inline constexpr std::string_view kName = "data-tactics-name", kLeftOut = "data-tactics-left-out",
                                  kOrigin = "data-tactics-origin";
/// A remark on the drawing; a region that is not drawn: kRegion with its number, kText its name, kPath its path.
inline constexpr std::string_view kRemark = "data-tactics-remark", kRegion = "data-tactics-region";
/// Of a region: "folded=3 shared=1".
inline constexpr std::string_view kCounts = "data-tactics-counts";

/// From the lowest up: what they are called in the file, and to a person.
struct PageLayer {
    std::string_view name, label;
};
inline constexpr std::string_view kGround = "ground", kInner = "inner-lines", kMain = "main-outlines", kWordsLayer = "words",
                                  kBraille = "braille", kTitleLayer = "title";
/// What `check` draws on a page for who mends it: no part of it.
inline constexpr std::string_view kCheckLayer = "marks";
inline constexpr std::array<PageLayer, 6> kLayers{{{kGround, "ground"},
                                                   {kInner, "inner lines"},
                                                   {kMain, "main outlines"},
                                                   {kWordsLayer, "words"},
                                                   {kBraille, "braille"},
                                                   {kTitleLayer, "title"}}};

}  // namespace tactics::marks
