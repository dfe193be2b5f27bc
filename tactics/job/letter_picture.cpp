// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/letter_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "print/raster.h"
#include "tactics/job/print_fonts.h"
#include "tactics/lettering/lettering.h"
#include "tactics/readers/svg/rings.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

// A letter that its font has not is Greek or a sign, which readers of print take for the Latin letter that looks most like it.
bool is_unread(const FoundPage& figure, const FoundWords& words) {
    return words.text.empty() && !words.letters.empty() &&
           std::none_of(words.letters.begin(), words.letters.end(), [&](const DrawnLetter& letter) {
               return figure.letter_shapes[letter.shape].adopted || figure.letter_shapes[letter.shape].lone;
           });
}

bool are_fonts_installed() {
    bool any = false;
    each_print_font({}, [&](const PrintFont&) {
        any = true;
        return false;
    });
    return any;
}

// Lower- and upper-case forms of these letters differ only in size, and some digits look the same: alone they are ambiguous,
// unless fonts tell their size.
bool is_doubtful(std::string_view text) {
    constexpr std::string_view kAlike = "cosvwxzuCOSVWXZUlI|10 ";
    const bool letter = std::any_of(text.begin(), text.end(), [](char c) { return (c | 32) >= 'a' && (c | 32) <= 'z'; });
    return letter && text.find_first_not_of(kAlike) == text.npos;
}

// All unread letters, in black.
Page page_of(const FoundPage& figure) {
    Page page;
    page.width = figure.page.width;
    page.height = figure.page.height;
    page.live = {0, 0, page.width, page.height};
    for (const FoundWords& words : figure.words) {
        if (!is_unread(figure, words)) continue;
        for (const DrawnLetter& letter : words.letters) {
            auto rings = figure.letter_shapes[letter.shape].rings;
            for (auto& ring : rings)
                for (Point& p : ring) {
                    const double x = words.unit * (letter.at + p.x), y = words.unit * (p.y - letter.up);
                    p = {words.start.x + x * words.way.x - y * words.way.y, words.start.y + x * words.way.y + y * words.way.x};
                }
            if (!rings.empty()) page.areas.push_back({to_even_odd(std::move(rings)), Role::line});
        }
    }
    return page;
}

// Large letters count as drawn things. Each pixel is as dark as the share of its parts that is ink.
Image picture_of(const Page& page, double tallest) {
    constexpr double kTall = 24;  // pixels: in larger ones a font's sizes for small and large print differ
    constexpr int kParts = 4;     // of a pixel, across and down
    const double scale = std::min(kLookForWords / std::max(page.width, page.height), kTall / tallest);
    const PixelSize size{std::max(1, static_cast<int>(std::lround(page.width * scale))),
                         std::max(1, static_cast<int>(std::lround(page.height * scale)))};
    Image image = make_image(size.width, size.height, 1, 0, 255);
    std::vector<int> ink(static_cast<std::size_t>(size.width), 0);
    int part = 0;
    draw_rows(page, {kParts * size.width, kParts * size.height}, [&](const std::uint8_t* row) {
        for (int x = 0; x < kParts * size.width; ++x) ink[static_cast<std::size_t>(x / kParts)] += row[x / 8] >> (7 - x % 8) & 1;
        if (++part % kParts != 0) return;
        std::uint8_t* to = image.row(part / kParts - 1);
        for (int x = 0; x < size.width; ++x)
            to[x] = static_cast<std::uint8_t>(255 - 255 * std::exchange(ink[static_cast<std::size_t>(x)], 0) / (kParts * kParts));
    });
    return image;
}

}  // namespace

Phrase read_letter_picture(FoundPage& figure, std::string_view language, const std::string& program) {
    if (std::none_of(figure.words.begin(), figure.words.end(), [&](const FoundWords& words) { return is_unread(figure, words); }))
        return {};
    double tallest = 0;
    for (const FoundWords& words : figure.words)
        if (is_unread(figure, words)) tallest = std::max(tallest, words.height);
    if (!(tallest > 0)) return {};
    const Image image = picture_of(page_of(figure), tallest);
    const Lettering lettering = read_lettering(image, language, kSureEnough, each_print_font, program);
    const bool fonts = are_fonts_installed();
    const double mm = figure.page.width / image.width;
    std::vector<FoundWords*> unread;
    for (FoundWords& words : figure.words)
        if (is_unread(figure, words)) unread.push_back(&words);
    for (const PrintedWords& print : lettering.words) {
        const Rect box{mm * print.box.left, mm * print.box.top, mm * print.box.width(), mm * print.box.height()};
        std::vector<FoundWords*> within;
        for (FoundWords* words : unread)
            if (box.holds(words->middle)) within.push_back(words);
        // The reading must cover exactly one line of letters; otherwise it is unclear which letters belong to which word.
        if (within.size() != 1) continue;
        FoundWords& words = *within.front();
        const double along = words.upwards ? box.height : box.width;
        if (std::abs(along - words.width) > words.height / 2) continue;
        words.seen = words.seen || letters_in(print.text) > 2;
        if (!print.sure || (!fonts && is_doubtful(print.text))) continue;
        words.text = print.text;
        words.sureness = print.sureness;
    }
    return lettering.trouble;
}

}  // namespace tactics
