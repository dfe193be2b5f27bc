// SPDX-License-Identifier: Apache-2.0
#include "print/format.h"

#include <algorithm>

#include "print/page_relief.h"
#include "tactics/layout/sheet.h"
#include "tactics/text/words.h"

namespace tactics {

#define FORMAT(name) extern const Format name##_format;
// Formats, embossers, displays: the order of the help, which clang-format would sort.
// clang-format off
#include "print/list.inc"
#include "print/embossers/list.inc"
#include "print/displays/list.inc"
// clang-format on
#undef FORMAT

std::string Format::encode(const Page& page, const Settings& settings) const {
    if (encode_pages != nullptr) return encode_pages({&page, 1}, settings);
    if (encode_page != nullptr) return encode_page(page, settings);
    PageRelief relief(page, settings, name);
    return encode_heights(relief.sheet(), relief.rows(), settings);
}

void fit_to_machine(Sheet& sheet, const Format& format, const Settings& settings, int zoom) {
    if (format.dots == nullptr) return;
    const DotSetting set = format.dots(settings);
    sheet.cell = set.cell;
    // A file of 6-dot cells has them where BRF has them: one page, the same cells in both. Whatever prints it decides where they
    // begin.
    if (format.embosser == nullptr && set.bed.raster == 0 && set.bed.dots_down < 4) return;
    sheet.bed = set.bed;
    sheet.heights = set.heights;
    sheet.reach = set.reach;
    sheet.title_cells = sheet.braille_table.empty() ? 0 : set.title_cells;
    if (set.width > 0) {
        sheet.window = Point{set.width, set.height};
        sheet.paper = {"", "", zoom * std::min(set.width, set.height), zoom * std::max(set.width, set.height)};
        sheet.orientation = set.width > set.height ? Orientation::landscape : Orientation::portrait;
        sheet.margin = 0;
    }
}

bool has_six_dots(const Format& format, const Settings& settings) {
    if (format.dots == nullptr) return format.six_dots;
    const DotBed bed = format.dots(settings).bed;
    return bed.raster == 0 && bed.dots_down < 4;
}

std::size_t count_files(const Format& format, std::span<const Page> pages) {
    if (format.encode_pages != nullptr || pages.size() == 1) return 1;
    const auto blank = std::count_if(pages.begin(), pages.end(), [](const Page& page) { return is_blank(page); });
    return std::max<std::size_t>(1, pages.size() - static_cast<std::size_t>(blank));
}

void each_file(const Format& format, std::span<const Page> pages, const Settings& settings,
               const std::function<void(std::string_view bytes)>& take) {
    if (format.encode_pages != nullptr && pages.size() > 1) return take(format.encode_pages(pages, settings));
    const bool all_blank = std::all_of(pages.begin(), pages.end(), [](const Page& page) { return is_blank(page); });
    if (all_blank) return take(format.encode(pages.front(), settings));
    for (const Page& page : pages)
        if (pages.size() == 1 || !is_blank(page)) take(format.encode(page, settings));
}

std::vector<std::string> files_of(const Format& format, std::span<const Page> pages, const Settings& settings) {
    std::vector<std::string> files;
    each_file(format, pages, settings, [&](std::string_view bytes) { files.emplace_back(bytes); });
    return files;
}

std::span<const Format* const> formats() {
    static const Format* const kFormats[] = {
#define FORMAT(name) &name##_format,
// clang-format off
#include "print/list.inc"
#include "print/embossers/list.inc"
#include "print/displays/list.inc"
// clang-format on
#undef FORMAT
    };
    return kFormats;
}

const Format* find_format(std::string_view name) {
    for (const Format* format : formats())
        if (format->name == name) return format;
    return nullptr;
}

std::size_t ending_size(const Format& format, std::string_view path) {
    std::size_t best = 0;
    for (const auto extension : words_of(format.extensions)) {
        const std::string ending = "." + std::string(extension);
        if (path.size() <= ending.size() || ending.size() <= best) continue;
        std::string tail(path.substr(path.size() - ending.size()));
        for (char& c : tail)
            if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        if (tail == ending) best = ending.size();
    }
    return best;
}

const Format* format_of_path(std::string_view path) {
    // The longest matching end wins, so that "page.height.png" is a height map and not a picture.
    const Format* best = nullptr;
    std::size_t best_size = 0;
    for (const Format* format : formats())
        if (const std::size_t size = ending_size(*format, path); size > best_size) {
            best = format;
            best_size = size;
        }
    return best;
}

const Format* heights_format_of_path(std::string_view path) {
    const std::string name = "any.height" + std::string(path.substr(std::min(path.size(), path.rfind('.'))));
    for (const Format* format : formats())
        if (format->encode_heights != nullptr && ending_size(*format, name) > 0) return format;
    return nullptr;
}

}  // namespace tactics
