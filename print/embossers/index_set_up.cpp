// SPDX-License-Identifier: Apache-2.0
#include "print/embossers/index_set_up.h"

#include "print/dots.h"
#include "print/text_job.h"

namespace tactics {

namespace {

std::string index_text_job(std::span<const Page> pages, const Settings& settings) {
    const Page& page = pages.front();
    TextJob job;
    job.begin =
        index_set_up(settings, "BT0,TD0,CH" + std::to_string(cells_across(page)) + ",LP" + std::to_string(lines_down(page)));
    job.page_end = "\f";
    job.end = "\x1a";
    job.letter = nabcc_letter;
    return text_job(pages, job);
}

DotSetting text_dots_v3(const Settings&) { return {kMarburgMedium, {kFirstDotV3, 0, 3}}; }
DotSetting text_dots_v4(const Settings&) { return {kMarburgMedium, {kFirstDotV4, 0, 3}}; }

}  // namespace

const TextMode index_v3_text{text_dots_v3, index_text_job};
const TextMode index_v4_text{text_dots_v4, index_text_job};

std::string index_set_up(const Settings& settings, const std::string& keys) {
    if (settings.choice("setup") == "no") return "";
    return "\x1b"
           "DTM0,BI0,FO0,MC" +
           std::to_string(settings.whole("copies")) + ",MI" + std::to_string(settings.whole("impacts")) + ",DP1,PN0," + keys +
           ";";
}

std::string four_dot_job(std::span<const Page> pages, const Settings& settings) {
    const auto pitch = settings.choice("pitch");
    std::string bytes = index_set_up(settings, pitch == "2.0" ? "GD0" : pitch == "2.5" ? "GD1" : "GD2");
    for (const Page& page : pages) {
        const Dots dots = raise_on_bed(page);
        std::string lines;
        std::size_t end = 0;  // after the last line that has a dot
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
        bytes += "\x1b\x07" + lines + "\x1b\x06\f";
    }
    return bytes + '\x1a';
}

}  // namespace tactics
