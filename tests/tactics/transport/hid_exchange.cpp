// SPDX-License-Identifier: Apache-2.0
// Shows cells 1, 2, 3 ... on the only braille display that is there, and says what it is or what is wrong.
#include <cstdio>
#include <vector>

#include "tactics/error.h"
#include "tactics/transport/cell_display.h"

int main() {
    using namespace tactics;
    try {
        const auto display = open_hid_display("");
        const CellDisplaySize size = display->size();
        std::printf("%d x %d of %d dots\n", size.columns, size.lines, size.dots);
        std::vector<std::uint8_t> cells(static_cast<std::size_t>(size.columns * size.lines));
        for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = static_cast<std::uint8_t>(i + 1);
        display->show(cells);
        std::printf("key %d\n", display->key_within(std::chrono::milliseconds{1}) ? 1 : 0);
        return 0;
    } catch (const Error& error) {
        std::printf("%s\n", error.what());
        return 2;
    }
}
