// SPDX-License-Identifier: Apache-2.0
// Any bytes as what a display of braille cells tells of itself: the size that BrlAPI answers, or the report descriptor of a HID
// display and a report of its keys. A display that is taken is shown a page of exactly its cells and its dots; any other is
// refused.
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "print/screen.h"
#include "tactics/error.h"
#include "tactics/layout/lay_out.h"
#include "tactics/transport/braille_reports.h"

namespace {

using namespace tactics;

void require(bool holds) {
    if (!holds) std::abort();
}

class Told : public CellDisplay {
public:
    Told(CellDisplaySize size, std::size_t& shown) : size_(size), shown_(shown) {}
    CellDisplaySize size() const override { return size_; }
    void show(std::span<const std::uint8_t> cells) override {
        require(cells.size() == static_cast<std::size_t>(size_.columns) * static_cast<std::size_t>(size_.lines));
        for (const std::uint8_t cell : cells) require(size_.dots == 8 || cell <= 0x3F);
        ++shown_;
    }
    bool key_within(std::chrono::milliseconds) override { return false; }

private:
    CellDisplaySize size_;
    std::size_t& shown_;
};

// As `show` has it.
void show_on(const CellDisplaySize& size) {
    std::size_t shown = 0;
    std::unique_ptr<Screen> screen;
    try {
        screen = cell_screen(std::make_unique<Told>(size, shown), true, "display");
    } catch (const Error& error) {
        require(error.fault() == Fault::failed && error.what()[0] != '\0');
        return;
    }
    require(size.columns >= 4 && size.columns <= 1000 && size.lines >= 1 && size.lines <= 1000);
    constexpr int kMostShown = 2000;  // larger ones take their time, and nothing else happens on them
    if (size.columns * size.lines > kMostShown) return;
    Drawing drawing;
    drawing.width = drawing.height = 50;
    drawing.strokes.push_back({{{1, 1}, {49, 40}, {20, 49}}, true});
    Sheet sheet;
    sheet.title = "Page 1";
    sheet.print_title = false;
    sheet.medium = &find_medium(screen->format().medium, "medium");
    fit_to_machine(sheet, screen->format(), screen->settings());
    try {
        const Page page = lay_out(drawing, sheet);
        require(screen->show(page) && shown == 1);
    } catch (const Error& error) {
        require(error.what()[0] != '\0');  // too small for a title
    }
}

std::uint32_t number(std::span<const std::uint8_t> bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value |= static_cast<std::uint32_t>(bytes[i]) << 8 * i;
    return value;
}

void show_by_brlapi(std::span<const std::uint8_t> bytes) {
    if (bytes.size() < 8) return;
    const std::uint32_t columns = number(bytes), lines = number(bytes.subspan(4));
    const CellDisplaySize size = told_size(columns, lines);
    // What is not its number is refused below.
    require(size.columns == static_cast<std::int64_t>(columns) || size.columns == 0);
    require(size.lines == static_cast<std::int64_t>(lines) || size.lines == 0);
    show_on(size);
}

// A key is pressed when its report says so and did not before; a report in which nothing is down presses none.
void press(const BrailleReports& reports, std::span<const std::uint8_t> report) {
    std::vector<std::uint8_t> nothing(report.size(), 0);
    if (reports.numbered && !report.empty()) nothing[0] = report[0];
    KeyWatch keys(reports);
    require(!keys.pressed(nothing));
    const bool pressed = keys.pressed(report);
    require(!keys.pressed(report));
    require(!keys.pressed(nothing));
    require(keys.pressed(report) == pressed);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span<const std::uint8_t> bytes(data, size);
    if (size < 2) return 0;
    if (bytes[0] % 2 == 0) {
        show_by_brlapi(bytes.subspan(1));
        return 0;
    }
    const std::size_t report = std::min<std::size_t>(bytes[1], size - 2);
    const BrailleReports reports = braille_reports(bytes.subspan(2 + report));
    if (!reports.lines.empty()) show_on({reports.columns, static_cast<int>(reports.lines.size()), reports.dots});
    press(reports, bytes.subspan(2, report));
    return 0;
}
