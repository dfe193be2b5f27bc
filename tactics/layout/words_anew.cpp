// SPDX-License-Identifier: Apache-2.0
#include "tactics/layout/words_anew.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tactics/braille/braille.h"
#include "tactics/layout/dot_grid.h"
#include "tactics/layout/key.h"
#include "tactics/layout/label.h"
#include "tactics/layout/room.h"
#include "tactics/layout/title.h"

namespace tactics {

namespace {

using Cells = std::vector<std::uint8_t>;

const Medium& medium_of(const Page& page) {
    for (const Medium& medium : media())
        if (medium.name == page.medium) return medium;
    return media().front();
}

double dots_span(std::size_t cells, const Page& page) {
    return cells == 0 ? 0 : static_cast<double>(cells - 1) * page.cell.cell_pitch + page.cell.dot_pitch;
}

// All lines of title and caption, from where they begin now.
Phrase set_title_anew(Page& page) {
    const auto is_title = [&](int words) {
        if (words < 0) return false;
        const WordsKind kind = page.words[static_cast<std::size_t>(words)].kind;
        return kind == WordsKind::title || kind == WordsKind::caption;
    };
    Sheet sheet = sheet_of(page);
    Rect room = page.live;
    double first = page.height;
    for (const BrailleLine& line : page.braille)
        if (is_title(line.words)) first = std::min(first, line.first_dot.y - page.braille_dot / 2);
    for (const PrintLine& line : page.print)
        if (is_title(line.words)) first = std::min(first, line.baseline.y - kAscent * line.size);
    room.top = std::min(first, page.height);
    TitleBand band = set_title(title_of(sheet), sheet, room);
    const auto before = static_cast<std::size_t>(
        std::count_if(page.braille.begin(), page.braille.end(), [&](const BrailleLine& line) { return is_title(line.words); }));
    // set_title counts from 0 the words that there are.
    std::vector<int> numbers;
    for (const WordsKind kind : {WordsKind::title, WordsKind::caption})
        for (std::size_t i = 0; i < page.words.size(); ++i)
            if (page.words[i].kind == kind && !page.words[i].text.empty()) numbers.push_back(static_cast<int>(i));
    const auto take = [&](auto& lines, auto& fresh) {
        const auto old = std::find_if(lines.begin(), lines.end(), [&](const auto& line) { return is_title(line.words); });
        const auto at = old - lines.begin();
        std::erase_if(lines, [&](const auto& line) { return is_title(line.words); });
        for (auto& line : fresh)
            line.words =
                static_cast<std::size_t>(line.words) < numbers.size() ? numbers[static_cast<std::size_t>(line.words)] : -1;
        lines.insert(lines.begin() + std::min<std::ptrdiff_t>(at, static_cast<std::ptrdiff_t>(lines.size())), fresh.begin(),
                     fresh.end());
    };
    take(page.print, band.print);
    take(page.braille, band.braille);
    if (band.braille.size() <= before) return {};
    return phrase("the title takes {0} lines of braille now, {1} before; look whether they meet the drawing",
                  std::to_string(band.braille.size()), std::to_string(before));
}

// How far its left end moves when it becomes so much wider.
double shift_of(const Page& page, int words, double wider) {
    const PageWords& said = page.words[static_cast<std::size_t>(words)];
    if (said.kind == WordsKind::label) return -std::clamp(said.across, 0.0, 1.0) * wider;
    for (const PageName& name : page.names)
        if (name.words == words && name.thing.x > name.place.middle().x) return -wider;
    return 0;
}

Cells cells_for(const PageWords& words, const Page& page) {
    const Cells said = to_braille(words.text, page.braille_table, "the words \"" + words.text + "\"");
    if (words.kind != WordsKind::key || words.key.size() != 2) return said;
    Cells cells{letter_cell(words.key[0]), letter_cell(words.key[1])};
    cells.resize(kWordsFrom, 0);
    cells.insert(cells.end(), said.begin(), said.end());
    return cells;
}

Phrase set_line_anew(Page& page, int words) {
    const PageWords& said = page.words[static_cast<std::size_t>(words)];
    const auto is_its = [&](const auto& line) { return line.words == words; };
    Phrase note;
    if (const auto line = std::find_if(page.braille.begin(), page.braille.end(), is_its);
        line != page.braille.end() && said.kind != WordsKind::letters) {
        Cells cells = cells_for(said, page);
        const double wider = dots_span(cells.size(), page) - dots_span(line->cells.size(), page);
        const double right = page.width - page.braille_dot / 2 - dots_span(cells.size(), page);
        if (right < page.braille_dot / 2 && said.kind == WordsKind::key)
            return phrase("\"{0}\" is longer than a line of the key in braille, which stays as it was; shorten it", said.text);
        if (right < page.braille_dot / 2)
            note = phrase("\"{0}\" is longer than the page is wide in braille; shorten it", said.text);
        const double from = line->first_dot.x;
        line->first_dot.x = std::max(page.braille_dot / 2, std::min(from + shift_of(page, words, wider), right));
        line->cells = std::move(cells);
        const BrailleLine first = *line;
        page.braille.erase(std::remove_if(line + 1, page.braille.end(), is_its), page.braille.end());
        for (PageName& name : page.names) {
            if (name.words != words) continue;
            name.place.left += first.first_dot.x - from;
            name.place.width = std::max(0.0, name.place.width + wider);
        }
    }
    for (PrintLine& line : page.print) {
        if (line.words != words) continue;
        const double wider = (print_width(said.text) - print_width(line.text)) * line.size;
        line.baseline.x = std::max(0.0, line.baseline.x + shift_of(page, words, wider));
        line.text = said.text;
    }
    return note;
}

// The line that led from words at `before` to that thing leads from where they are now.
void lead_anew(Page& page, const Rect& before, const Rect& now, Point thing) {
    constexpr double kNear = 1;  // mm besides the gap
    const Medium& medium = medium_of(page);
    const double gap = clear_of_braille(medium) + medium.thin_line / 2;
    for (PageStroke& stroke : page.strokes) {
        if (stroke.role != Role::lead || stroke.points.size() != 2) continue;
        Point &from = stroke.points[0], &to = stroke.points[1];
        const double off = distance(nearest_of(before, from), from);
        if (off > gap + kNear || distance(nearest_of(before, to), to) < off) continue;
        if (distance(to, thing) > distance(from, thing)) continue;
        const Point near = nearest_of(now, to);
        const double far = distance(near, to), begin = std::min(1.0, gap / std::max(far, 1e-9));
        from = on_steps({near.x + begin * (to.x - near.x), near.y + begin * (to.y - near.y)});
        return;
    }
}

}  // namespace

Sheet sheet_of(const Page& page) {
    Sheet sheet;
    sheet.medium = &medium_of(page);
    sheet.cell = page.cell;
    sheet.bed = page.bed;
    sheet.braille_table = page.braille_table;
    sheet.language = page.language;
    sheet.title = page.title;
    sheet.caption = page.caption;
    sheet.description = page.description;
    sheet.print_title = !page.print.empty();
    return sheet;
}

KeyEntry key_entry(const PageWords& words, const Page& page) { return {words.key, words.text, cells_for(words, page)}; }

Phrase set_words_anew(Page& page, int words, const std::string& text) {
    PageWords& said = page.words[static_cast<std::size_t>(words)];
    const std::string before = std::exchange(said.text, text);
    Phrase note;
    if (said.kind == WordsKind::title || said.kind == WordsKind::caption) {
        (said.kind == WordsKind::title ? page.title : page.caption) = text;
        note = set_title_anew(page);
    } else {
        note = set_line_anew(page, words);
    }
    const std::string key = said.key;
    for (PageName& name : page.names)
        if (name.words == words || (!key.empty() && name.key == key)) name.text = text;
    for (PageWords& other : page.words)
        if (!key.empty() && other.key == key) other.text = text;
    if (page.scale && said.kind == WordsKind::scale && page.scale->text == before) page.scale->text = text;
    put_on_dots(page);
    return note;
}

void move_words(Page& page, int words, double right, double down) {
    for (BrailleLine& line : page.braille)
        if (line.words == words) line.first_dot = {line.first_dot.x + right, line.first_dot.y + down};
    follow_words(page, words, right, down);
}

void follow_words(Page& page, int words, double right, double down) {
    put_on_dots(page);
    PageWords& said = page.words[static_cast<std::size_t>(words)];
    if (said.kind == WordsKind::label) said.at = {said.at.x + right, said.at.y + down};
    for (PageName& name : page.names) {
        if (name.words != words) continue;
        const Rect before = name.place;
        name.place.left += right;
        name.place.top += down;
        lead_anew(page, before, name.place, name.thing);
    }
}

void add_words(Page& page, Point at, const std::string& text) {
    Sheet sheet = sheet_of(page);
    sheet.print_title = page.braille_table.empty();
    LabelBlock block = set_label(text, sheet);
    const double top = at.y - block.height;
    say(block, page, {WordsKind::label, text, "", {at.x, top}});
    for (PrintLine& line : block.print) {
        line.baseline = {line.baseline.x + at.x, line.baseline.y + top};
        page.print.push_back(line);
    }
    for (BrailleLine& line : block.braille) {
        line.first_dot = {line.first_dot.x + at.x, line.first_dot.y + top};
        page.braille.push_back(line);
    }
    put_on_dots(page);
}

}  // namespace tactics
