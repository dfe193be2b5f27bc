// SPDX-License-Identifier: Apache-2.0
// Options for drawing tables, shared by all commands that take one.
#pragma once

#include "cli/command.h"
#include "tactics/job/table.h"

namespace tactics {

inline constexpr Flag kTableXFlag{
    "--x", "", "COLUMN", "column of a table to draw from left to right; default: the first column of numbers or dates",
    false, ""};
inline constexpr Flag kTableYFlag{
    "--y",
    "",
    "COLUMN",
    "column of a table to draw upwards; default: the next column of numbers. May be given several times, for a curve or a bar "
    "of each",
    true,
    ""};
inline constexpr Flag kTableZFlag{
    "--z",
    "",
    "COLUMN",
    "column of a table that holds heights over x and y: a surface if x and y form a grid, else points in "
    "space",
    false,
    ""};
inline constexpr Flag kTableMatrixFlag{
    "--matrix",
    "",
    "",
    "the table is rows of heights; x may stand in its first row and y in its first column, which tactics "
    "detects",
    false,
    ""};
inline constexpr Flag kTableHistogramFlag{"--histogram",
                                          "",
                                          "BINS|auto",
                                          "draw a histogram of a table's x column, with this many bars, or with as many as suit "
                                          "the values (auto)",
                                          false,
                                          "auto"};
inline constexpr Flag kTableGroupFlag{
    "--group",
    "",
    "COLUMN",
    "column of a table that groups its rows: one curve for each of its values, named in the key; default: one curve "
    "of all rows",
    false,
    ""};
inline constexpr Flag kTablePointsFlag{"--points",
                                       "",
                                       "",
                                       "draw each row of a table as a disc, without curves; a second group "
                                       "gets rings",
                                       false,
                                       ""};
inline constexpr Flag kTableStepsFlag{"--steps", "", "", "keep the curves of a table level from each row to the next", false, ""};
inline constexpr Flag kTableLogXFlag{"--log-x", "", "", "make a table's x axis logarithmic: equal steps are equal ratios",
                                     false,     ""};
inline constexpr Flag kTableLogYFlag{"--log-y", "", "", "make a table's y axis logarithmic", false, ""};
inline constexpr Flag kTableDecimalFlag{
    "--decimal", "",           "point|comma", "how a table's numbers are written, 0.53 or 0,53; default: as in its first rows",
    false,       "point comma"};
inline constexpr Flag kTableDatesFlag{
    "--dates", "", "YMD|DMY|MDY", "order of day, month and year in a table, where no day over 12 shows it", false, "YMD DMY MDY"};

inline constexpr Flag kTableBarsFlag{
    "--bars",
    "",
    "KIND",
    "draw a bar for each row of a table, named by x: grouped puts columns side by side, stacked puts them on top of each other, "
    "pie makes percent shares of one column",
    false,
    "grouped stacked pie"};
inline constexpr Flag kBarDirectionFlag{
    "--bar-direction",   "", "auto|upright|level", "direction of bars; auto: upright if the names have room below them", false,
    "auto upright level"};
inline constexpr Flag kTableErrorFlag{
    "--error",
    "",
    "COLUMN",
    "column with the error of the value, up and down, drawn on the bar; one for each --y, in the same "
    "order",
    true,
    ""};
inline constexpr Flag kTableLowerFlag{
    "--lower", "", "COLUMN", "column with the lower limit of the value, drawn on the bar with --upper; one for each --y",
    true,      ""};
inline constexpr Flag kTableUpperFlag{"--upper",
                                      "",
                                      "COLUMN",
                                      "column with the upper limit of the value, drawn with --lower; "
                                      "one for each --y",
                                      true,
                                      ""};

/// The wishes from all of them; options that a command does not have are ignored. Throws Error(usage).
TableWish table_wish(const Given& given);

}  // namespace tactics
