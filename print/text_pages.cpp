// SPDX-License-Identifier: Apache-2.0
#include "print/text_pages.h"

#include <array>
#include <optional>
#include <vector>

#include "print/embosser.h"
#include "print/text_job.h"
#include "tactics/braille/braille.h"
#include "tactics/error.h"

namespace tactics {

namespace {

// Far more than a book has; a form feed is a byte of the file, and a page many.
constexpr std::size_t kMostPages = 20'000;

// Which cell a byte of BRF is. Small letters are as large ones; so are the signs that share their columns.
std::optional<std::uint8_t> cell_of(unsigned char byte) {
    static const std::array<std::uint8_t, 256> kCells = [] {
        std::array<std::uint8_t, 256> cells{};
        cells.fill(0xFF);
        for (unsigned cell = 0; cell < 64; ++cell) {
            const auto letter = static_cast<unsigned char>(brf_letter(static_cast<std::uint8_t>(cell)));
            cells[letter] = static_cast<std::uint8_t>(cell);
            if (letter >= 0x40) cells[letter + 0x20u] = static_cast<std::uint8_t>(cell);
        }
        return cells;
    }();
    return kCells[byte] == 0xFF ? std::nullopt : std::optional(kCells[byte]);
}

std::string where(std::string_view name, std::size_t page, std::size_t line) {
    return std::string(name) + ", page " + std::to_string(page) + ", line " + std::to_string(line);
}

// Lines of its cells on sheets of that size.
class TextPages {
public:
    TextPages(const Page& sheet, std::string_view name, std::string_view machine)
        : sheet_(sheet),
          name_(name),
          machine_(machine),
          across_(static_cast<std::size_t>(cells_across(sheet))),
          down_(static_cast<std::size_t>(lines_down(sheet))) {}

    std::vector<Page> read(std::string_view brf) {
        while (brf.ends_with('\x1a')) brf.remove_suffix(1);  // the end of a file of CP/M and DOS
        breaks_itself_ = brf.find('\f') == std::string_view::npos;
        begin_page();
        for (const char c : brf) {
            const auto byte = static_cast<unsigned char>(c);
            if (byte == '\r') continue;
            if (byte == '\n')
                end_line();
            else if (byte == '\f')
                end_page();
            else if (const auto cell = cell_of(byte))
                cells_.push_back(*cell);
            else
                throw Error(Fault::failed, where(name_, pages_.size(), line_ + 1),
                            phrase("byte {0} is no letter of braille (BRF); if it is written for the machine, name it .prn",
                                   std::to_string(byte)));
        }
        end_line();
        if (pages_.back().braille.empty() && pages_.size() > 1) pages_.pop_back();  // after the last form feed
        check_count();
        return std::move(pages_);
    }

private:
    void check_count() const {
        if (pages_.size() > kMostPages)
            throw Error(Fault::failed, where(name_, pages_.size(), 1),
                        phrase("there are more than {0} pages; split the file and emboss one part behind the other",
                               std::to_string(kMostPages)));
    }
    void begin_page() {
        check_count();
        pages_.push_back(sheet_);
        line_ = 0;
    }
    void end_page() {
        end_line();
        begin_page();
    }
    void end_line() {
        while (!cells_.empty() && cells_.back() == 0) cells_.pop_back();
        if (breaks_itself_ && line_ == down_) begin_page();
        if (!cells_.empty()) {
            const auto refuse = [&](Phrase why) {
                throw Error(Fault::usage, where(name_, pages_.size(), line_ + 1), std::move(why));
            };
            if (cells_.size() > across_)
                refuse(
                    phrase("{0} cells are in the line, and the sheet has room for {1}; take larger {2}, or set the text for that "
                           "size; if it is a drawing, convert it for the machine: -o {3}:page.prn",
                           std::to_string(cells_.size()), std::to_string(across_), spelled("paper"), machine_));
            if (line_ + 1 > down_)
                refuse(
                    phrase("{0} lines are on the page, and the sheet has room for {1}; take larger {2}, or set the text for that "
                           "size; if it is a drawing, convert it for the machine: -o {3}:page.prn",
                           std::to_string(line_ + 1), std::to_string(down_), spelled("paper"), machine_));
            const Point first = sheet_.bed->first;
            pages_.back().braille.push_back({{first.x, first.y + static_cast<double>(line_) * sheet_.cell.line_pitch}, cells_});
        }
        cells_.clear();
        ++line_;
    }

    const Page& sheet_;
    std::string_view name_, machine_;
    std::size_t across_, down_, line_ = 0;
    bool breaks_itself_ = false;  // without form feeds a page is as long as the sheet
    std::vector<std::uint8_t> cells_;
    std::vector<Page> pages_;
};

}  // namespace

std::string text_for(std::string_view brf, const Format& format, const Settings& settings, const Paper& paper,
                     std::string_view name) {
    const TextMode* text = format.embosser->text;
    if (text == nullptr && (format.dots == nullptr || format.dots(settings).bed.raster > 0))
        throw Error(Fault::usage, name, phrase("{0} takes pictures only; send text by its own driver", format.name));
    const DotSetting set = text != nullptr ? text->dots(settings) : format.dots(settings);
    Page sheet;
    sheet.width = paper.width;
    sheet.height = paper.height;
    sheet.cell = set.cell;
    sheet.bed = set.bed;
    sheet.live = {0, 0, paper.width, paper.height};
    const std::vector<Page> pages = TextPages(sheet, name, format.name).read(brf);
    return text != nullptr ? text->encode_pages(pages, settings) : format.encode_pages(pages, settings);
}

}  // namespace tactics
