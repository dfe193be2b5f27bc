// SPDX-License-Identifier: Apache-2.0
#include "print/embossers/index_set_up.h"

#include <algorithm>
#include <cmath>

#include "print/dots.h"
#include "print/text_job.h"
#include "tactics/error.h"

namespace tactics {

namespace {

constexpr int kMostCellsV3 = 42, kMostCellsV4 = 49;  // dotify 1.0.9 IndexV3Embosser, IndexV4Embosser (Everest: 48)

// The position of its first dot from the corner; the opposite margin is the same.
int cells_of_own(const Page& page, Point first) {
    Page own;
    own.width = page.width;
    own.bed = DotBed{first, 0, 3};
    return std::min(kMostCellsV4, cells_across(own));
}

int lines_of_own(const Page& page, Point first) {
    Page own;
    own.height = page.height;
    own.bed = DotBed{first, 0, 3};
    return lines_down(own);
}

// Whole inches and a digit: no fraction, a quarter, a third, a half, two thirds, three quarters; rounded down.
std::string inches_and_part(double mm) {
    const int parts = static_cast<int>(std::floor(mm / 25.4 * 12 + 1e-6)), inch = parts / 12, twelfth = parts % 12;
    const int part = twelfth < 3 ? 0 : twelfth < 4 ? 1 : twelfth < 6 ? 2 : twelfth < 8 ? 3 : twelfth < 9 ? 4 : 5;
    return std::to_string(inch) + std::to_string(part);
}

std::string sheet_keys_v3(const Page& page, std::string_view model) {
    const auto keys = [](const std::string& width, const std::string& length) { return ",PW" + width + ",PL" + length; };
    if (model == "everest")
        return keys(std::to_string(static_cast<int>(page.width + 1e-6)), std::to_string(static_cast<int>(page.height + 1e-6)));
    return model == "basic" ? keys(inches_and_part(page.width), inches_and_part(page.height)) : "";
}

bool has(const Settings& settings, std::string_view name) {
    return std::any_of(settings.options().begin(), settings.options().end(),
                       [&](const Option& option) { return option.name == name; });
}

std::string_view graphic_key(const Settings& settings) {
    if (!has(settings, "pitch")) return "";
    const auto pitch = settings.choice("pitch");
    return pitch == "2.0" ? "GD0" : pitch == "2.5" ? "GD1" : "GD2";
}

void check_lines(std::span<const Page> pages, int most) {
    for (const Page& page : pages)
        for (const BrailleLine& line : page.braille)
            if (line.cells.size() > static_cast<std::size_t>(most))
                throw Error(Fault::usage, "index",
                            phrase("a line has {0} cells, and the machine {1}; set the text for that length",
                                   std::to_string(line.cells.size()), std::to_string(most)));
}

std::string index_text_job(std::span<const Page> pages, const Settings& settings, IndexSeries series) {
    check_lines(pages, series == IndexSeries::v3 ? kMostCellsV3 : kMostCellsV4);
    TextJob job;
    job.begin = index_set_up(pages.front(), settings, series, graphic_key(settings));
    job.page_end = "\f";
    job.end = "\x1a";
    job.letter = nabcc_letter;
    return index_job(text_job(pages, job));
}

std::string text_v3(std::span<const Page> pages, const Settings& settings) {
    return index_text_job(pages, settings, IndexSeries::v3);
}
std::string text_v4(std::span<const Page> pages, const Settings& settings) {
    return index_text_job(pages, settings, IndexSeries::v4);
}

DotSetting text_dots_v3(const Settings&) { return {kMarburgMedium, {kFirstDotV3, 0, 3}}; }
DotSetting text_dots_v4(const Settings&) { return {kMarburgMedium, {kFirstDotV4, 0, 3}}; }

// Lines up to the last that has a dot; nothing: none has.
std::string four_dot_lines(const Page& page) {
    const Dots dots = raise_on_bed(page);
    std::string lines;
    std::size_t end = 0;
    for (int row = 0; row < dots.rows; row += 4) {
        std::string line;
        for (int column = 0; column < dots.columns; ++column) {
            int four = 0;
            for (int dot = 0; dot < 4 && row + dot < dots.rows; ++dot) four |= dots.at(column, row + dot) != 0 ? 1 << dot : 0;
            line += static_cast<char>('@' + four);
        }
        line.erase(line.find_last_not_of('@') + 1);
        lines += line + "\r\n";
        if (!line.empty()) end = lines.size();
    }
    lines.resize(end);
    return lines;
}

std::string four_dot_job(std::span<const Page> pages, const Settings& settings, IndexSeries series) {
    std::string bytes = index_set_up(pages.front(), settings, series, graphic_key(settings));
    for (const Page& page : pages) {
        const std::string lines = four_dot_lines(page);
        bytes += lines.empty() ? "\f" : "\x1b\x07" + lines + "\f\r\x1b\x06";
    }
    return index_job(bytes + '\x1a');
}

}  // namespace

const TextMode index_v3_text{text_dots_v3, text_v3};
const TextMode index_v4_text{text_dots_v4, text_v4};

std::string index_set_up(const Page& page, const Settings& settings, IndexSeries series, std::string_view graphic) {
    if (settings.choice("setup") == "no") return "";
    std::string keys =
        "\x1b"
        "DTM0,BI0,FO0";
    if (settings.whole("copies") != 1) keys += ",MC" + std::to_string(settings.whole("copies"));
    keys += ",MI" + std::to_string(settings.whole("impacts"));
    keys += has(settings, kSides.name) && on_both(settings) ? ",DP2" : ",DP1";
    keys += ",TD0";
    if (!graphic.empty()) keys += "," + std::string(graphic);
    keys += ",PN0";
    if (series == IndexSeries::v3)
        keys += sheet_keys_v3(page, settings.choice("model")) + ",LS4";  // 5 mm; firmware from 12.01.3 on also has LS50
    else
        keys += ",CH" + std::to_string(cells_of_own(page, kFirstDotV4)) + ",LP" +
                std::to_string(lines_of_own(page, kFirstDotV4)) + ",LS50";
    return keys + ",BT0;";
}

std::string index_job(std::string bytes) {
    bytes += packet_end(kIndexPacket, bytes.size());
    return bytes;
}

std::string four_dot_job_v3(std::span<const Page> pages, const Settings& settings) {
    return four_dot_job(pages, settings, IndexSeries::v3);
}
std::string four_dot_job_v4(std::span<const Page> pages, const Settings& settings) {
    return four_dot_job(pages, settings, IndexSeries::v4);
}

}  // namespace tactics
