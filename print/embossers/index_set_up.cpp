#include "print/embossers/index_set_up.h"

#include "print/dots.h"

namespace tactics {

std::string index_set_up(const Settings& settings, const std::string& keys) {
    if (settings.choice("setup") == "no") return "";
    return "\x1b" "DTM0,BI0,FO0,MC" + std::to_string(settings.whole("copies")) + ",MI" + std::to_string(settings.whole("impacts")) + ",DP1,PN0," + keys + ";";
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

DotSetting four_dot_setting(const Settings& settings, Point first) {
    const auto pitch = settings.choice("pitch");
    DotSetting setting{{}, {first, 2.5, 3}};
    // Cells are multiples of the raster. 2.5 mm is the distance of Marburg's dots, cells one and a half millimetres wider apart; at 2.0
    // the dots are closer than any standard of braille has them; at 1.6 they are twice that apart, as the machine's own 3.2 mm braille.
    setting.cell = {2.5, 7.5, 10.0, 1.6};
    if (pitch == "2.0") {
        setting.bed.raster = 2.0;
        setting.cell = {2.0, 6.0, 10.0, 1.6};
    } else if (pitch == "1.6") {
        setting.bed.raster = 1.6;
        setting.cell = {3.2, 8.0, 12.8, 1.6};
    }
    return setting;
}

}  // namespace tactics
