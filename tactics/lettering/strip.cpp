// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/strip.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tactics {

namespace {

constexpr int kHalo = 1;  // pixels beyond a letter's own ink, where it fades into the ground
// Of the height of letters. A gap between letters is up to 0.3 ("1 1" of DejaVu Sans), a word space with its letters' bearings
// mostly 0.45 and more; between them it may be either ("n J").
constexpr double kSpace = 0.38, kSurelySpace = 0.45, kSurelyNone = 0.3;
constexpr double kWider = 0.3;

const std::vector<InkPiece>& pieces_of(const LetteringLine& line, Part part) {
    return part == Part::raised ? line.raised : line.letters;
}

// The place of the strip's pixel (x, y) in the picture. A rising line is turned clockwise.
struct View {
    PixelBox box;
    bool upwards = false;
    int width() const { return upwards ? box.height() : box.width(); }
    int height() const { return upwards ? box.width() : box.height(); }
    int picture_x(int x, int y) const { return upwards ? box.left + y : box.left + x; }
    int picture_y(int x, int y) const { return upwards ? box.bottom - 1 - x : box.top + y; }
    PixelBox strip_box(const PixelBox& part) const {
        return upwards ? PixelBox{box.bottom - part.bottom, part.left - box.left, box.bottom - part.top, part.right - box.left}
                       : PixelBox{part.left - box.left, part.top - box.top, part.right - box.left, part.bottom - box.top};
    }
};

std::vector<const InkPiece*> ink_of(const LetteringLine& line, Part part) {
    std::vector<const InkPiece*> ink;
    for (const InkPiece& piece : pieces_of(line, part)) ink.push_back(&piece);
    if (part == Part::words)
        for (const InkPiece& piece : line.marks) ink.push_back(&piece);
    return ink;
}

// Columns of the strip before which words begin anew.
std::vector<int> gaps_of(const std::vector<const InkPiece*>& ink, const View& view, double least) {
    std::vector<bool> used(static_cast<std::size_t>(view.width()), false);
    for (const InkPiece* piece : ink) {
        const int left = view.upwards ? view.box.bottom - piece->box.bottom : piece->box.left - view.box.left;
        const int right = view.upwards ? view.box.bottom - piece->box.top : piece->box.right - view.box.left;
        for (int x = std::max(0, left); x < std::min(view.width(), right); ++x) used[static_cast<std::size_t>(x)] = true;
    }
    std::vector<int> gaps;
    int empty = 0;
    bool begun = false;
    for (int x = 0; x < view.width(); ++x) {
        if (!used[static_cast<std::size_t>(x)]) {
            ++empty;
            continue;
        }
        if (begun && empty >= least) gaps.push_back(x - (empty + 1) / 2);
        begun = true;
        empty = 0;
    }
    return gaps;
}

View view_of(const LetteringLine& line, const std::vector<const InkPiece*>& ink, int halo = kHalo) {
    View view{ink.front()->box, line.upwards};
    for (const InkPiece* piece : ink) view.box = around(view.box, piece->box);
    view.box = {view.box.left - halo, view.box.top - halo, view.box.right + halo, view.box.bottom + halo};
    return view;
}

// Black letters on white, all else white.
Image cut_out(const Image& grey, const LetteringLine& line, const std::vector<const InkPiece*>& ink, const View& view,
              int halo = kHalo) {
    Image own = make_image(view.box.width(), view.box.height(), 1, 0, 0);  // 1: near its ink
    int deepest = line.light ? 0 : 255;
    for (const InkPiece* piece : ink)
        for (const InkRun& run : piece->runs) {
            for (int x = run.left; x < run.right; ++x)
                deepest = line.light ? std::max<int>(deepest, grey.row(run.y)[x]) : std::min<int>(deepest, grey.row(run.y)[x]);
            for (int y = run.y - halo; y <= run.y + halo; ++y)
                std::fill(own.row(y - view.box.top) + (run.left - halo - view.box.left),
                          own.row(y - view.box.top) + (run.right + halo - view.box.left), std::uint8_t{1});
        }
    // The ground is what the halo's lightest half is (darkest of light letters): letters fill the rest.
    std::vector<int> around_it;
    for (int y = std::max(0, view.box.top); y < std::min(grey.height, view.box.bottom); ++y)
        for (int x = std::max(0, view.box.left); x < std::min(grey.width, view.box.right); ++x)
            if ((grey.row(y)[x] < line.level) == line.light) around_it.push_back(grey.row(y)[x]);
    std::sort(around_it.begin(), around_it.end());
    const int ground = around_it.empty() ? (line.light ? 0 : 255) : around_it[around_it.size() / 2];
    const double range = ground == deepest ? 1 : ground - deepest;
    Image strip = make_image(view.width(), view.height(), 1, 0, 255);
    for (int y = 0; y < strip.height; ++y)
        for (int x = 0; x < strip.width; ++x) {
            const int px = view.picture_x(x, y), py = view.picture_y(x, y);
            if (px < 0 || py < 0 || px >= grey.width || py >= grey.height || own.row(py - view.box.top)[px - view.box.left] == 0)
                continue;
            const double share = (grey.row(py)[px] - deepest) / range;
            strip.row(y)[x] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
        }
    return strip;
}

// The veil and what fades from it.
std::vector<bool> veiled_in(const LetteringLine& line, const View& view) {
    std::vector<bool> veiled;
    if (line.veil.empty()) return veiled;
    const int width = view.width();
    veiled.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(view.height()));
    for (const InkRun& run : line.veil) {
        const PixelBox part = view.strip_box({run.left - 1, run.y - 1, run.right + 1, run.y + 2});
        for (int y = std::max(0, part.top); y < std::min(view.height(), part.bottom); ++y)
            for (int x = std::max(0, part.left); x < std::min(width, part.right); ++x)
                veiled[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] = true;
    }
    return veiled;
}

Image with_gaps(const Image& strip, const std::vector<int>& gaps, int wider) {
    Image wide = make_image(strip.width + static_cast<int>(gaps.size()) * wider, strip.height, 1, 0, 255);
    for (int y = 0; y < strip.height; ++y) {
        int shift = 0;
        std::size_t next = 0;
        for (int x = 0; x < strip.width; ++x) {
            if (next < gaps.size() && gaps[next] == x) {
                shift += wider;
                ++next;
            }
            wide.row(y)[x + shift] = strip.row(y)[x];
        }
    }
    return wide;
}

// Catmull-Rom, as wide as the coarser of both grids needs.
double kernel(double t) {
    t = std::abs(t);
    if (t < 1) return 1 + t * t * (1.5 * t - 2.5);
    return t < 2 ? 2 + t * (-4 + t * (2.5 - 0.5 * t)) : 0;
}

// One row or column of `count` samples `step` apart, to `size` of them.
void resample(const std::uint8_t* from, int count, std::size_t step, std::uint8_t* to, int size, std::size_t to_step) {
    const double scale = static_cast<double>(count) / size, reach = std::max(1.0, scale);
    for (int i = 0; i < size; ++i) {
        const double middle = (i + 0.5) * scale - 0.5;
        double sum = 0, weights = 0;
        for (int k = static_cast<int>(std::ceil(middle - 2 * reach)); k <= middle + 2 * reach; ++k) {
            const double weight = kernel((k - middle) / reach);
            sum += weight * from[static_cast<std::size_t>(std::clamp(k, 0, count - 1)) * step];
            weights += weight;
        }
        to[static_cast<std::size_t>(i) * to_step] = static_cast<std::uint8_t>(std::lround(std::clamp(sum / weights, 0.0, 255.0)));
    }
}

Image resized(const Image& image, int width, int height) {
    Image wide = make_image(width, image.height, 1, 0, 255), out = make_image(width, height, 1, 0, 255);
    for (int y = 0; y < image.height; ++y) resample(image.row(y), image.width, 1, wide.row(y), width, 1);
    for (int x = 0; x < width; ++x)
        resample(wide.row(0) + x, image.height, wide.row_bytes(), out.row(0) + x, height, out.row_bytes());
    return out;
}

void put16(std::string& text, unsigned value) {
    text += static_cast<char>(value & 0xFF);
    text += static_cast<char>(value >> 8 & 0xFF);
}
void put32(std::string& text, std::size_t value) {
    put16(text, static_cast<unsigned>(value & 0xFFFF));
    put16(text, static_cast<unsigned>(value >> 16 & 0xFFFF));
}

}  // namespace

WordCount words_in(const LetteringLine& line) {
    const auto ink = ink_of(line, Part::words);
    const View view = view_of(line, ink);
    return {gaps_of(ink, view, kSurelySpace * line.letter_height).size() + 1,
            gaps_of(ink, view, kSurelyNone * line.letter_height).size() + 1};
}

Image strip_of(const Image& grey, const LetteringLine& line, Part part, int letter_height) {
    const auto ink = ink_of(line, part);
    const View view = view_of(line, ink);
    const std::vector<int> gaps = gaps_of(ink, view, kSpace * line.letter_height);
    const int wider = static_cast<int>(std::lround(kWider * line.letter_height));
    const Image strip = with_gaps(cut_out(grey, line, ink, view), gaps, wider);
    const double own_height = part == Part::raised ? strip.height - 2 * kHalo : line.letter_height;
    const double scale = letter_height / own_height;
    const Image letters = resized(strip, std::max(1, static_cast<int>(std::lround(strip.width * scale))),
                                  std::max(1, static_cast<int>(std::lround(strip.height * scale))));
    const int border = letter_height / 2;
    Image page = make_image(letters.width + 2 * border, letters.height + 2 * border, 1, 0, 255);
    for (int y = 0; y < letters.height; ++y) std::copy_n(letters.row(y), letters.width, page.row(y + border) + border);
    return page;
}

BareStrip bare_strip(const Image& grey, const LetteringLine& line) {
    constexpr int kFading = 2;  // pixels; thin serifs are paler than half, and reach beyond what is darker
    std::vector<const InkPiece*> ink = ink_of(line, Part::words);
    for (const InkPiece& piece : line.raised) ink.push_back(&piece);
    const View view = view_of(line, ink, kFading);
    BareStrip strip{cut_out(grey, line, ink, view, kFading), {}, {}, veiled_in(line, view)};
    const int width = strip.image.width, height = strip.image.height;
    const auto index = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    };
    strip.owner.assign(strip.image.pixels.size(), -1);
    for (std::size_t i = 0; i < ink.size(); ++i) {
        strip.pieces.push_back(view.strip_box(ink[i]->box));
        for (const InkRun& run : ink[i]->runs) {
            const PixelBox part = view.strip_box({run.left, run.y, run.right, run.y + 1});
            for (int y = part.top; y < part.bottom; ++y)
                for (int x = part.left; x < part.right; ++x) strip.owner[index(x, y)] = static_cast<int>(i);
        }
    }
    const auto is_others = [&](int x, int y) {
        const int px = view.picture_x(x, y), py = view.picture_y(x, y);
        return px < 0 || py < 0 || px >= grey.width || py >= grey.height || (grey.row(py)[px] < line.level) != line.light;
    };
    for (int step = 0; step < kFading; ++step) {
        const std::vector<int> known = strip.owner;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                if (known[index(x, y)] >= 0 || is_others(x, y)) continue;
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx)
                        if (x + dx >= 0 && x + dx < width && y + dy >= 0 && y + dy < height && known[index(x + dx, y + dy)] >= 0)
                            strip.owner[index(x, y)] = known[index(x + dx, y + dy)];
            }
    }
    return strip;
}

std::string tiff_of(const std::vector<Image>& pages) {
    // TIFF 6.0: little-endian header, then each page's samples before its directory of eight entries.
    std::string text = "II*";
    text += '\0';
    std::size_t link = text.size();
    put32(text, 0);
    for (const Image& page : pages) {
        const std::size_t samples = text.size();
        text.append(reinterpret_cast<const char*>(page.pixels.data()), page.pixels.size());
        if (text.size() % 2 != 0) text += '\0';
        std::string at;
        put32(at, text.size());
        text.replace(link, 4, at);
        const auto entry = [&](unsigned tag, unsigned type, std::size_t value) {
            put16(text, tag);
            put16(text, type);
            put32(text, 1);
            put32(text, value);
        };
        constexpr unsigned kShort = 3, kLong = 4;
        put16(text, 8);
        entry(256, kLong, static_cast<std::size_t>(page.width));
        entry(257, kLong, static_cast<std::size_t>(page.height));
        entry(258, kShort, 8);                                     // bits a sample
        entry(259, kShort, 1);                                     // not compressed
        entry(262, kShort, 1);                                     // 0 is black
        entry(273, kLong, samples);                                // where they are
        entry(278, kLong, static_cast<std::size_t>(page.height));  // rows of the one strip
        entry(279, kLong, page.pixels.size());
        link = text.size();
        put32(text, 0);
    }
    return text;
}

}  // namespace tactics
