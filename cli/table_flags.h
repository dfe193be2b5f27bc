// SPDX-License-Identifier: Apache-2.0
// Options that say how a table is drawn, of all commands that take one.
#pragma once

#include "cli/command.h"
#include "tactics/job/table.h"

namespace tactics {

inline constexpr Flag kTableXFlag{
    "--x", "", "COLUMN", "of a table, what goes from left to right; the first column of numbers or dates if none is named",
    false, ""};
inline constexpr Flag kTableYFlag{
    "--y",
    "",
    "COLUMN",
    "of a table, what goes up; the next column of numbers if none is named. Given several times: a curve, or a bar, of each",
    true,
    ""};
inline constexpr Flag kTableZFlag{
    "--z", "", "COLUMN", "of a table, heights over x and y: a surface if those are a grid, else points in space", false, ""};
inline constexpr Flag kTableMatrixFlag{
    "--matrix", "", "", "a table is rows of heights; x may be in its first row and y in its first column, and is then seen to be",
    false,      ""};
inline constexpr Flag kTableHistogramFlag{
    "--histogram", "",    "BINS|auto", "of a table, how often x is where: as many bars, or as many as the values want",
    false,         "auto"};
inline constexpr Flag kTableGroupFlag{
    "--group", "",
    "COLUMN",  "of a table, a curve for each of its values, named in the key; one curve of all rows if none is named",
    false,     ""};
inline constexpr Flag kTablePointsFlag{"--points", "", "", "of a table, each row a disc, and no curves; of a second group rings",
                                       false,      ""};
inline constexpr Flag kTableStepsFlag{"--steps", "", "", "of a table, level from each row to the next", false, ""};
inline constexpr Flag kTableLogXFlag{"--log-x", "", "", "of a table, a logarithmic axis: equal steps are equal ratios",
                                     false,     ""};
inline constexpr Flag kTableLogYFlag{"--log-y", "", "", "of a table, the same upwards", false, ""};
inline constexpr Flag kTableDecimalFlag{
    "--decimal",   "",
    "point|comma", "how a table's numbers are written, 0.53 or 0,53; as its first rows have it if none is named",
    false,         "point comma"};
inline constexpr Flag kTableDatesFlag{
    "--dates", "",           "YMD|DMY|MDY", "in which order day, month and year stand in a table, where no day over 12 tells",
    false,     "YMD DMY MDY"};

inline constexpr Flag kTableBarsFlag{
    "--bars",
    "",
    "KIND",
    "of a table, a bar for each row, named by x: grouped sets columns side by side, stacked on each other, pie makes "
    "shares in percent of one column",
    false,
    "grouped stacked pie"};
inline constexpr Flag kBarDirectionFlag{
    "--bar-direction",   "", "auto|upright|level", "which way bars run; auto: upright if the names have room below them", false,
    "auto upright level"};
inline constexpr Flag kTableErrorFlag{
    "--error", "", "COLUMN", "on bars, how far the value may be off, up and down; one for each --y, in their order", true, ""};
inline constexpr Flag kTableLowerFlag{
    "--lower", "", "COLUMN", "on bars, the least that the value may be, with --upper; one for each --y", true, ""};
inline constexpr Flag kTableUpperFlag{"--upper", "", "COLUMN", "on bars, the largest that the value may be, with --lower",
                                      true,      ""};

/// Of all of them, those that a command does not have left out. Throws Error(usage).
TableWish table_wish(const Given& given);

}  // namespace tactics
