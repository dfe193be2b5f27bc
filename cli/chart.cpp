// SPDX-License-Identifier: Apache-2.0
// `tactics chart`: a table of figures as a page to be felt.
#include <algorithm>
#include <cmath>
#include <optional>

#include "cli/chart_files.h"
#include "cli/command.h"
#include "cli/page_flags.h"
#include "cli/say.h"
#include "tactics/error.h"
#include "tactics/readers/csv.h"
#include "tactics/text/utf8.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kMost = 1e12;   // a number with more digits is no word to be felt
constexpr double kLeast = 1e-4;  // between the least and the largest: ticks are written to 1e-6

constexpr Flag kFlags[] = {
    {"--output", "-o", "OUT",
     "where to write: FILE, whose ending names the format, or FORMAT:FILE, as in convert. May be given several times", true,
     "files formats"},
    {"--x", "", "COLUMN", "what goes from left to right; the first column of numbers if none is named", false, ""},
    {"--y", "", "COLUMN", "what goes up; the next column of numbers if none is named", false, ""},
    {"--group", "", "COLUMN", "a curve for each of its values, named in the key; one curve of all rows if none is named", false,
     ""},
    {"--label", "", "COLUMN", "a row with words in it is marked by a disc with a letter, and the key has the words", false, ""},
    {"--points", "", "", "each row a disc, and no curves; of a second group rings", false, ""},
    {"--log-x", "", "", "a logarithmic axis: equal steps are equal ratios", false, ""},
    {"--log-y", "", "", "the same upwards", false, ""},
    {"--set", "-s", "FORMAT.OPTION=VALUE", "change a setting of an output format: png.width=800. May be given several times",
     true, "settings"},
    {"--paper", "-p", "PAPER", "paper: a name or a size such as 200x150mm; each format has its own if none is named", false,
     "papers"},
    {"--medium", "-m", "MEDIUM", "what is printed on; each format has its own if none is named", false, "media"},
    kMarginFlag,
    {"--orientation", "", "auto|portrait|landscape", "which way up the paper is", false, "auto portrait landscape"},
    {"--title", "", "TEXT", "title; what is shown against what if none is named", false, ""},
    kCaptionFlag,
    kNoPrintTitleFlag,
    {"--braille", "", "TABLE|none", "liblouis table for all words; en-ueb-g2.ctb if none is named", false,
     "en-ueb-g1.ctb en-ueb-g2.ctb none"},
    {"--dpi", "", "NUMBER", "dots per inch of png and tiff", false, ""},
    {"--quiet", "-q", "", "nothing but errors", false, ""},
};

// Without its unit: "time (s)", "time".
std::string_view bare(std::string_view column) { return column.substr(0, std::min(column.find(" ("), column.size())); }

std::size_t column_of(const Csv& csv, std::string_view flag, const std::string& wanted) {
    for (std::size_t i = 0; i < csv.columns.size(); ++i)
        if (csv.columns[i] == wanted) return i;
    for (std::size_t i = 0; i < csv.columns.size(); ++i)
        if (bare(csv.columns[i]) == wanted) return i;
    std::string all;
    for (const std::string& column : csv.columns) {
        if (all.size() > 400) {
            all += ", ...";
            break;
        }
        all += (all.empty() ? "\"" : ", \"") + beginning_of(column) + '"';
    }
    throw Error(Fault::usage, flag,
                csv.name + " has no column \"" + beginning_of(wanted) + "\"" +
                    did_you_mean(wanted, {csv.columns.begin(), csv.columns.end()}) + "; it has " + all);
}

// A number as half of the world writes it; empty: it is none.
std::string with_point(std::string cell) {
    const auto comma = cell.find(',');
    if (comma == std::string::npos) return "";
    cell[comma] = '.';
    return parse_number(cell) ? cell : "";
}

// What a message says to do about a cell that is no number.
std::string how_to_write(const std::string& cell) {
    const std::string better = with_point(cell);
    return better.empty() ? "write it like 0.53, or leave it empty" : "write a point and no comma: " + beginning_of(better);
}

// Where the values of the table are.
struct Choice {
    std::size_t x = 0, y = 0;
    std::optional<std::size_t> group, label;
};

Choice choose(const Csv& csv, const Given& given) {
    Choice choice;
    std::vector<std::size_t> taken;
    const auto named = [&](std::string_view flag) -> std::optional<std::size_t> {
        if (!given.has(flag)) return std::nullopt;
        taken.push_back(column_of(csv, flag, given.value(flag)));
        return taken.back();
    };
    choice.group = named("--group");
    choice.label = named("--label");
    const auto x = named("--x"), y = named("--y");
    const auto next_of_numbers = [&](std::string_view flag) {
        for (std::size_t i = 0; i < csv.columns.size(); ++i) {
            const auto number = [&](const CsvRow& row) { return parse_number(row.cells[i]).has_value(); };
            if (std::find(taken.begin(), taken.end(), i) != taken.end() || !std::any_of(csv.rows.begin(), csv.rows.end(), number))
                continue;
            taken.push_back(i);
            return i;
        }
        for (const CsvRow& row : csv.rows)
            for (const std::string& cell : row.cells)
                if (!with_point(cell).empty())
                    throw Error(Fault::failed, csv.name + ":" + std::to_string(row.line),
                                "\"" + beginning_of(cell) + "\" is no number; " + how_to_write(cell));
        throw Error(Fault::usage, flag,
                    csv.name + " has no column of numbers for it; name one, or write numbers such as 0.53 below its name");
    };
    choice.x = x ? *x : next_of_numbers("--x");
    choice.y = y ? *y : next_of_numbers("--y");
    const std::string &across = csv.columns[choice.x], &up = csv.columns[choice.y];
    const auto is_number = [](const std::string& name) { return parse_number(name) || !with_point(name).empty(); };
    if (is_number(across) && is_number(up) && !(x && y))
        throw Error(Fault::failed, csv.name,
                    "its first line names the columns, and there is \"" + beginning_of(across) + "\" and \"" + beginning_of(up) +
                        "\", which are numbers; write a line of names above them, time (s),length (mm) for example, or name both "
                        "by --x and --y");
    return choice;
}

// Nothing for an empty cell.
std::optional<double> number_in(const Csv& csv, const CsvRow& row, std::size_t column, bool logarithmic) {
    const std::string& cell = row.cells[column];
    if (cell.empty()) return std::nullopt;
    const std::string place = csv.name + ":" + std::to_string(row.line),
                      what = beginning_of(csv.columns[column]) + " is \"" + beginning_of(cell) + "\"";
    const auto number = parse_number(cell);
    if (!number) throw Error(Fault::failed, place, what + ", which is no number; " + how_to_write(cell));
    if (std::abs(*number) > kMost)
        throw Error(Fault::failed, place, what + ", too large to be written at an axis; write all in a larger unit");
    if (logarithmic && !(*number > 0))
        throw Error(Fault::failed, place,
                    what + ", and a logarithmic axis shows numbers over 0 only; leave the row out, or take an axis that is not");
    return number;
}

struct Range {
    double low = INFINITY, high = -INFINITY;
    void take(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

void check_range(const Csv& csv, std::size_t column, const Range& range, bool logarithmic) {
    const double least = logarithmic ? range.low : range.high - range.low;
    if (least != 0 && least < kLeast)
        throw Error(Fault::failed, csv.name,
                    "the numbers of " + beginning_of(csv.columns[column]) +
                        " are too small to be written at an axis; write them in a smaller unit");
}

Plot plot_of(const Csv& csv, const Choice& choice, const Given& given, std::size_t& left_out) {
    const bool log_x = given.has("--log-x"), log_y = given.has("--log-y"), points = given.has("--points");
    Plot plot{std::string(bare(csv.columns[choice.y])) + " against " + std::string(bare(csv.columns[choice.x])),
              {csv.columns[choice.x], log_x},
              {csv.columns[choice.y], log_y},
              {},
              {}};
    std::vector<std::string> groups;
    Range across, up;
    for (const CsvRow& row : csv.rows) {
        const auto x = number_in(csv, row, choice.x, log_x), y = number_in(csv, row, choice.y, log_y);
        if (!x || !y) {
            ++left_out;
            continue;
        }
        across.take(*x);
        up.take(*y);
        const std::string name = choice.group ? row.cells[*choice.group] : "",
                          label = choice.label ? row.cells[*choice.label] : "";
        const auto at = static_cast<std::size_t>(std::find(groups.begin(), groups.end(), name) - groups.begin());
        const bool fresh = at == groups.size();
        if (fresh) {
            groups.push_back(name);
            plot.curves.push_back({name, {}});
        }
        if (points && at > 1)
            throw Error(
                Fault::usage, "--points",
                "a finger tells two groups of points, discs and rings, and " + csv.name + " has more; leave it out, or keep two");
        plot.curves[at].points.push_back({*x, *y});
        if (points)
            plot.marks.push_back({label.empty() && fresh ? name : label, *x, *y, at == 0});
        else if (!label.empty())
            plot.marks.push_back({label, *x, *y, true});
    }
    if (groups.empty())
        throw Error(Fault::failed, csv.name,
                    "there is no row with numbers in " + beginning_of(csv.columns[choice.x]) + " and " +
                        beginning_of(csv.columns[choice.y]) + "; write some there, or name other columns by --x and --y");
    check_range(csv, choice.x, across, log_x);
    check_range(csv, choice.y, up, log_y);
    if (points) plot.curves.clear();
    // What is one point has no line: a ring of its name, unless it has a label.
    for (const PlotCurve& curve : plot.curves)
        if (curve.points.size() == 1 && std::none_of(plot.marks.begin(), plot.marks.end(), [&](const PlotMark& mark) {
                return mark.x == curve.points[0].x && mark.y == curve.points[0].y;
            }))
            plot.marks.push_back({curve.name, curve.points[0].x, curve.points[0].y, false});
    std::erase_if(plot.curves, [](const PlotCurve& curve) { return curve.points.size() == 1; });
    return plot;
}

int run(const Given& given) {
    if (given.words.size() != 1) throw Error(Fault::usage, "chart", "name one file of figures, or - for standard input");
    if (!given.has("--output")) throw Error(Fault::usage, "chart", "say where to write it: -o chart.pdf");
    const std::vector<ChartFile> charts = plan_chart_files(given, "--output", real_disk());
    const Csv csv = read_csv(open_source(given.words[0]));
    std::size_t left_out = 0;
    const Plot plot = plot_of(csv, choose(csv, given), given, left_out);
    if (left_out > 0 && !given.has("--quiet"))
        say(csv.name + ": " + std::to_string(left_out) + (left_out == 1 ? " row has" : " rows have") +
            " no number for the chart and " + (left_out == 1 ? "is" : "are") + " left out");
    write_chart_files(plot, charts);
    return 0;
}

}  // namespace

extern const Command chart_command;
const Command chart_command{
    .name = "chart",
    .summary = "draw a table of figures as curves or points to be felt",
    .words = "FILE.csv -o OUT",
    .details =
        "The first line of the file names the columns, with units in parentheses: dots a page,F or time (s),length (mm). The "
        "rest are numbers with a "
        "point, 0.53, between commas, tabs or semicolons. Rows of a curve are joined in their order. A cell that is empty leaves "
        "its row out.\n\n"
        "--x and --y take a column's name with its unit or without. The axes have ticks with numbers; curves and marked points "
        "have a letter each, and "
        "a key below says what the letters are.",
    .example =
        "tactics chart results.csv -o chart.pdf\n"
        "tactics chart results.csv --x \"dots a page\" --y F --group tool --label method --log-x -o chart.pdf -o chart.brf\n"
        "cut -d, -f2,5 measured.csv | tactics chart - --points -o points.svg --title \"Height and age\"",
    .flags = kFlags,
    .offers = "files",
    .run = run,
};

}  // namespace tactics
