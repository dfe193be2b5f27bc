// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/scene_of_file.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "print/raster.h"
#include "tactics/error.h"
#include "tactics/job/felt_heights.h"
#include "tactics/job/holds.h"
#include "tactics/job/open_input.h"
#include "tactics/medium.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr std::string_view kLaidOutAs = "png";  // whose page a drawing is laid out on

FileScene of_heights(HeightFile file, const std::string& name) {
    const HeightMap& map = file.map;
    LevelGrid grid = grid_of(map, file.low, file.high, kMostLevels, name);
    return {scene_of(std::move(grid), map.pitch, file.low, file.high, name), std::move(file.format), std::move(file.notes)};
}

// Its pixels, which say neither how large they are nor how high.
FileScene of_pixels(Source& source, const HeightWish& wish) {
    const std::string format = inspect_picture(source).format;
    Image image = read_picture(source, {0, false});
    const double low = wish.low.value_or(0), high = wish.high.value_or(low + kPictureHeight);
    if (!(high > low))
        throw Error(Fault::usage, spelled("high"), phrase("white must be higher than black; change it or {0}", spelled("low")));
    const double pitch = wish.pitch ? *wish.pitch : wish.width ? *wish.width / image.width : kPixelPitch;
    FileScene found{scene_of(grid_of(std::move(image)), pitch, low, high, source.name), format, {}};
    if (!wish.high)
        found.notes.push_back(phrase(
            "its lightness is taken for heights from {0} to {1} mm; say others with {2} and {3}, or have it drawn with {4}",
            numeral(low), numeral(high), spelled("low"), spelled("high"), spelled("recipe")));
    return found;
}

Drawing lines_of(const Page& page) {
    Drawing lines{page.width, page.height, {}, page.areas, {}};
    std::transform(page.strokes.begin(), page.strokes.end(), std::back_inserter(lines.strokes), [](const PageStroke& stroke) {
        return Stroke{stroke.points, stroke.closed, LineClass::normal, 0, stroke.role};
    });
    return lines;
}

FileDrawing drawn(Source source, Wishes wishes) {
    wishes.sheet.bare = true;
    const Job job{{source.name, {{find_format(kLaidOutAs), "", ""}}}, std::move(wishes)};
    const Outcome made = make_pages(std::move(source), job);
    if (!made.error.empty()) throw Error(made.fault, "", made.error);
    const Layout& layout = made.layouts.front();
    const Page& page = layout.shown.front();
    const double dpi = layout.sheet.medium->dpi;
    const PixelSize size = pixels_at(page, dpi, kLaidOutAs);
    std::vector<std::uint8_t> black;
    black.reserve(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    draw_rows(page, size, [&](const std::uint8_t* row) {
        for (int x = 0; x < size.width; ++x) black.push_back(static_cast<std::uint8_t>(row[x / 8] >> (7 - x % 8) & 1));
    });
    std::vector<Phrase> notes;
    for (const Note& note : made.notes) notes.push_back(note.words);
    return {{size.width, size.height, 1, 2, std::move(black)}, kMmPerInch / dpi, lines_of(page), std::move(notes)};
}

}  // namespace

FileScene scene_of_file(Source source, const std::string& path, const HeightWish& heights, Wishes wishes) {
    const Holds holds = look_at(source);
    const std::string name = source.name;
    const bool way = asks_for_a_way(wishes.chain);
    if (holds == Holds::picture && !way) {
        auto told = read_told_heights(source, heights);
        return told ? of_heights(std::move(*told), name) : of_pixels(source, heights);
    }
    if (holds == Holds::model || (holds == Holds::table && !way && is_of_heights(source, wishes.table)))
        return of_heights(felt_heights(std::move(source), path, heights, std::move(wishes)).file, name);
    FileDrawing drawing = drawing_of_file(std::move(source), path, std::move(wishes));
    return {scene_of(std::move(drawing.grid), drawing.pitch, std::move(drawing.lines), name), "drawing",
            std::move(drawing.notes)};
}

FileDrawing drawing_of_file(Source source, const std::string& path, Wishes wishes) {
    std::vector<Phrase> notes;
    source = page_of_input(std::move(source), path, page_wish(wishes), notes);
    FileDrawing drawing = drawn(std::move(source), std::move(wishes));
    drawing.notes.insert(drawing.notes.begin(), notes.begin(), notes.end());
    return drawing;
}

}  // namespace tactics
