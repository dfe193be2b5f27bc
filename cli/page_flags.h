// SPDX-License-Identifier: Apache-2.0
// What convert and describe ask alike: which drawing, on which page.
#pragma once

#include "cli/command.h"

namespace tactics {

inline constexpr Flag kRecipeFlag{
    "--recipe",  "-r",
    "NAME|FILE", "how the picture becomes a drawing: a recipe's name or a recipe file; auto if none is named",
    false,       "recipes files"};
inline constexpr Flag kFilterFlag{"--filter",
                                  "-f",
                                  "\"NAME SETTING=VALUE...\"",
                                  "a step of your own. May be given several times: alone they are the whole recipe, with "
                                  "--recipe they come after its steps",
                                  true,
                                  "filters"};
inline constexpr Flag kDetailFlag{"--detail",
                                  "",
                                  "touch|best|contours|NUMBER",
                                  "how much line the recipe keeps: touch (the default) keeps the recipe's own amount, a number "
                                  "that many times as much, best the amount with which the page of each medium tells most of "
                                  "what people would draw, and contours "
                                  "every line, however fine and close (as --as-drawn)",
                                  false,
                                  "touch best contours"};
inline constexpr Flag kAsDrawnFlag{
    "--as-drawn",
    "",
    "",
    "leave the drawing as the recipe makes it; else lines that are too close for a finger are moved, joined, broken or left out, "
    "and what was done is told",
    false,
    ""};
inline constexpr Flag kMarginFlag{"--margin", "", "LENGTH", "margin on every side; the medium's own if none is named", false, ""};
inline constexpr Flag kBindingFlag{
    "--binding", "", "left|top|right=LENGTH", "room at that edge besides the margin, for holes or a comb: left=15mm", false, ""};
inline constexpr Flag kDuplexFlag{
    "--duplex",
    "",
    "",
    "the pages are printed on both sides of a sheet, as by an interpoint embosser: the back of a drawing stays blank, a key of "
    "one page "
    "lies to the left of its drawing, a longer one to the right; on backs left and right change places for --binding",
    false,
    ""};
inline constexpr Flag kTilesFlag{
    "--tiles",
    "",
    "COLUMNSxROWS",
    "one large page of several sheets, such as 2x2, that share 1 cm with each other; marks beside it show where they meet, and "
    "each is named by its row and column: a1, a2, b1",
    false,
    ""};
inline constexpr Flag kOrientationFlag{"--orientation",
                                       "",
                                       "auto|portrait|landscape",
                                       "which way up the paper is; auto: whichever shows the picture larger",
                                       false,
                                       "auto portrait landscape"};
inline constexpr Flag kWidthFlag{"--width", "", "LENGTH", "width of the drawing on the page; as large as fits if none is named",
                                 false,     ""};
inline constexpr Flag kRealWidthFlag{
    "--real-width",
    "",
    "LENGTH",
    "how wide in the world is what the drawing shows from its left edge to its right: 12m, 3km. A scale bar on the page says so",
    false,
    ""};
inline constexpr Flag kScaleFlag{
    "--scale",
    "",
    "1:NUMBER|LENGTH=LENGTH",
    "the drawing gets the size that this gives to --real-width: 1:100, or 1cm=1m; as large as fits if none is named. An SVG that "
    "tells its size needs no --real-width",
    false,
    ""};
inline constexpr Flag kPdfPageFlag{"--page", "", "NUMBER", "which page of a PDF; the first if none is named", false, ""};
inline constexpr Flag kPdfPagesFlag{
    "--page",
    "",
    "LIST",
    "which page of a PDF, or pages such as 1-3,7, each in files of its own in a folder; the first if "
    "none is named",
    false,
    ""};
inline constexpr Flag kTextFlag{
    "--text",
    "",
    "",
    "lay what is written in a PDF or a text file out as pages of braille: paragraphs, headings and page numbers as braille books "
    "have them; all pages of a PDF unless --page names one",
    false,
    ""};
inline constexpr Flag kAllowFlag{
    "--allow",
    "",
    "psd|ico",
    "also read files of this format, whose library hostile files can break: for files that you trust. May be given several times",
    true,
    "psd ico"};
inline constexpr Flag kTitleFlag{"--title", "", "TEXT", "title, in print and in braille", false, ""};
inline constexpr Flag kTitleFromNameFlag{
    "--title-from-name", "", "", "the title of each page is the name of its picture's file, underscores as spaces", false, ""};
inline constexpr Flag kCaptionFlag{"--caption", "", "TEXT", "caption below the title, in print and in braille from cell 7",
                                   false,       ""};
inline constexpr Flag kNoPrintTitleFlag{"--no-print-title", "", "", "the title and the caption in braille only", false, ""};
inline constexpr Flag kBrailleFlag{
    "--braille",  "",
    "TABLE|none", "table for title and labels, of tactics list braille; that of --language if none is named",
    false,        "braille none"};
inline constexpr Flag kCellFlag{
    "--cell", "", "NAME", "size of the braille, by the standard that has it; marburg-medium if none is named", false, "cells"};
inline constexpr Flag kLabelFlag{
    "--label",
    "",
    "X,Y=WORDS",
    "names what is at that place of the drawing, from its left and top, in percent or as lengths: \"30%,40%=City Park\". The "
    "braille stands beside it, clear of the lines. May be given several times",
    true,
    ""};
inline constexpr Flag kLabelsFlag{"--labels",
                                  "",
                                  "FILE|FOLDER",
                                  "a file with a label a line, \"30%,40% City Park\", and what matters, \"subject "
                                  "20%,30%-70%,90%\"; or a folder with such a file for each "
                                  "picture, map.labels for map.png",
                                  false,
                                  "files"};
inline constexpr Flag kSubjectFlag{
    "--subject",
    "",
    "BOX|POINT",
    "what matters in a photograph: \"20%,30%-70%,90%\", two corners of a box around it, or \"40%,50%\", a point in it, from the "
    "left and the top of the picture. Its outline is drawn whole and thick, all else thin and with what line is left. The recipe "
    "is photo then, if none is named. May be given several times, for several things",
    true,
    ""};
inline constexpr Flag kSubjectOnlyFlag{"--subject-only", "", "", "nothing is drawn but the subject", false, ""};
inline constexpr Flag kLeaveFlag{
    "--leave",
    "",
    "BOX",
    "nothing is drawn in that box but the subject: \"0%,0%-30%,20%\". The recipe is photo then, if none is named. May be given "
    "several times",
    true,
    ""};
inline constexpr Flag kWordsFlag{"--words",
                                 "",
                                 "auto|read|leave|remove",
                                 "print in the picture: read puts it in braille where it was (by Tesseract), leave draws its "
                                 "letters as lines, remove takes it "
                                 "out; auto reads it if the recipe is diagram, map or line-art and Tesseract is installed",
                                 false,
                                 "auto read leave remove"};
inline constexpr Flag kLanguageFlag{
    "--language",
    "",
    "TAG",
    "language of title, labels and print that is read, such as en-GB or de: it is told in the file, and the table of braille is "
    "one of it, as little contracted as there is, unless --braille names one; en if none is named",
    false,
    ""};
inline constexpr Flag kBareFlag{
    "--bare", "", "", "the drawing alone, without page and title; a png then has the size of the picture in pixels", false, ""};
inline constexpr Flag kJobsFlag{
    "--jobs", "-j", "NUMBER", "how many pictures are worked on at a time; as many as there are cores if none is named",
    false,    ""};

}  // namespace tactics
