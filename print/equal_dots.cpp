// SPDX-License-Identifier: Apache-2.0
#include "print/equal_dots.h"

namespace tactics {

DotSetting equal_dots(std::string_view pitch, Point first) {
    DotSetting setting{{}, {first, 2.5, 3}};
    // Cells are multiples of the raster. 2.5 mm is the distance of Marburg's dots, cells one and a half millimetres wider apart;
    // at 2.0 the dots are closer than any standard of braille has them; at 1.6 they are twice that apart, as the machine's
    // own 3.2 mm braille.
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

DotSetting display_pins(double pitch, int columns, int rows) {
    return {{pitch, 3 * pitch, 4 * pitch, 1.6}, {{pitch / 2, pitch / 2}, pitch, 3}, pitch * columns, pitch * rows};
}

}  // namespace tactics
