// SPDX-License-Identifier: Apache-2.0
// The options that convert and describe share: which drawing, on which page.
#pragma once

#include "cli/command.h"

namespace tactics {

inline constexpr Flag kRecipeFlag{
    "--recipe", "-r",           "NAME|FILE", "how the picture becomes a drawing: a recipe's name or a recipe file; default: auto",
    false,      "recipes files"};
inline constexpr Flag kFilterFlag{"--filter",
                                  "-f",
                                  "\"NAME SETTING=VALUE...\"",
                                  "a step of your own. May be given several times: without --recipe the steps are the whole "
                                  "recipe, with it they follow its steps",
                                  true,
                                  "filters"};
inline constexpr Flag kDetailFlag{"--detail",
                                  "",
                                  "touch|best|contours|NUMBER",
                                  "how much line the recipe keeps: touch (the default) keeps the recipe's own amount; a number "
                                  "multiplies it; best takes the amount with which the page of each medium tells most of what "
                                  "people would draw; contours keeps every line, however fine and close (and implies --as-drawn)",
                                  false,
                                  "touch best contours"};
inline constexpr Flag kAsDrawnFlag{
    "--as-drawn",
    "",
    "",
    "keep the drawing as the recipe makes it. Otherwise lines too close for a finger are moved, joined, broken or left out, and "
    "the changes reported",
    false,
    ""};
inline constexpr Flag kMarginFlag{"--margin", "", "LENGTH", "margin on every side; default: the medium's own", false, ""};
inline constexpr Flag kBindingFlag{
    "--binding", "", "left|top|right=LENGTH", "extra room at one edge besides the margin, for holes or a comb: left=15mm",
    false,       ""};
inline constexpr Flag kDuplexFlag{
    "--duplex",
    "",
    "",
    "print on both sides of a sheet, as an interpoint embosser does: the back of a drawing stays blank; a key of one page lies "
    "to the left of its drawing, a longer key to the right; on backs, left and right change places for --binding",
    false,
    ""};
inline constexpr Flag kTilesFlag{
    "--tiles",
    "",
    "COLUMNSxROWS",
    "make one large page of several sheets, such as 2x2, that overlap by 1 cm; marks beside the drawing show where they meet, "
    "and each sheet is named by its row and column: a1, a2, b1",
    false,
    ""};
inline constexpr Flag kOrientationFlag{"--orientation",
                                       "",
                                       "auto|portrait|landscape",
                                       "orientation of the paper; auto: whichever shows the picture larger",
                                       false,
                                       "auto portrait landscape"};
inline constexpr Flag kWidthFlag{"--width", "", "LENGTH", "width of the drawing on the page; default: as large as fits",
                                 false,     ""};
inline constexpr Flag kRealWidthFlag{
    "--real-width",
    "",
    "LENGTH",
    "real width of what the drawing shows, from its left edge to its right: 12m, 3km. The page then has a scale bar",
    false,
    ""};
inline constexpr Flag kScaleFlag{
    "--scale",
    "",
    "1:NUMBER|LENGTH=LENGTH",
    "scale of the drawing, which with --real-width sets its size: 1:100, or 1cm=1m; default: as large as fits. An SVG that "
    "gives its size needs no --real-width",
    false,
    ""};
inline constexpr Flag kPdfPageFlag{"--page", "", "NUMBER", "which page of a PDF; default: the first", false, ""};
inline constexpr Flag kPdfPagesFlag{
    "--page", "",
    "LIST",   "which page of a PDF, or pages such as 1-3,7, each of which goes to its own files in a folder; default: the first",
    false,    ""};
inline constexpr Flag kTextFlag{
    "--text",
    "",
    "",
    "lay out the text of a PDF or a text file as braille pages, with paragraphs, headings and page numbers as in braille books; "
    "all pages of a PDF unless --page names some",
    false,
    ""};
inline constexpr Flag kAllowFlag{
    "--allow",
    "",
    "psd|ico",
    "also read files of this format. Hostile files can break its library, so use it only for files that you trust. May be given "
    "several times",
    true,
    "psd ico"};
inline constexpr Flag kTitleFlag{"--title", "", "TEXT", "title, in print and in braille", false, ""};
inline constexpr Flag kTitleFromNameFlag{
    "--title-from-name",
    "",
    "",
    "use the name of the picture's file as the title of each page, with spaces for underscores",
    false,
    ""};
inline constexpr Flag kCaptionFlag{"--caption", "", "TEXT", "caption below the title, in print and in braille from cell 7",
                                   false,       ""};
inline constexpr Flag kNoPrintTitleFlag{"--no-print-title", "", "", "write the title and the caption in braille only", false, ""};
inline constexpr Flag kBrailleFlag{
    "--braille",   "", "TABLE|none", "table for title and labels, from tactics list braille; default: that of --language", false,
    "braille none"};
inline constexpr Flag kCellFlag{
    "--cell", "", "NAME", "size of the braille, named after its standard; default: marburg-medium", false, "cells"};
inline constexpr Flag kLabelFlag{"--label",
                                 "",
                                 "X,Y=WORDS",
                                 "label for the thing at this place, measured from the left and top, in percent of the whole "
                                 "picture or as lengths in the drawing (white margins then stay): \"30%,40%=City Park\". The "
                                 "braille stands beside the thing, clear of the lines. May be given several times",
                                 true,
                                 ""};
inline constexpr Flag kLabelsFlag{"--labels",
                                  "",
                                  "FILE|FOLDER",
                                  "a file with one label per line, \"30%,40% City Park\", and with subjects, \"subject "
                                  "20%,30%-70%,90%\"; or a folder with such a file for each picture, map.labels for map.png",
                                  false,
                                  "files"};
inline constexpr Flag kSubjectFlag{
    "--subject",
    "",
    "BOX|POINT",
    "what matters in a photograph: two corners of a box around it, \"20%,30%-70%,90%\", or a point in it, \"40%,50%\", from the "
    "left and the top of the picture. Its outline is drawn whole and thick, everything else thin and only as the amount of line "
    "permits. The default recipe is then photo. May be given several times, for several things",
    true,
    ""};
inline constexpr Flag kSubjectOnlyFlag{"--subject-only", "", "", "draw only the subject", false, ""};
inline constexpr Flag kLeaveFlag{
    "--leave",
    "",
    "BOX",
    "in this box draw only the subject: \"0%,0%-30%,20%\". The default recipe is then photo. May be given several times",
    true,
    ""};
inline constexpr Flag kWordsFlag{"--words",
                                 "",
                                 "auto|read|leave|remove",
                                 "what to do with print in the picture: read replaces it by braille in the same place (with "
                                 "Tesseract), leave draws its letters as lines, remove takes it out; auto reads it if the "
                                 "recipe is diagram, map, borders, regions or line-art and Tesseract is installed",
                                 false,
                                 "auto read leave remove"};
inline constexpr Flag kLanguageFlag{
    "--language",
    "",
    "TAG",
    "language of title, labels and print that is read, such as en-GB or de. The file states it, and it chooses the least "
    "contracted braille table of the language, unless --braille names a table. Default: en",
    false,
    ""};
inline constexpr Flag kBareFlag{
    "--bare", "", "", "write the drawing alone, without page and title; a png then has the size of the picture in pixels",
    false,    ""};
inline constexpr Flag kJobsFlag{"--jobs", "-j", "NUMBER", "how many pictures to work on at a time; default: the number of cores",
                                false,    ""};

}  // namespace tactics
