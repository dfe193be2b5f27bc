// SPDX-License-Identifier: Apache-2.0
// Print of few pixels, known by its company: in so few the shape of a letter and that of a mark are much the same.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>

#include "tactics/lettering/pale_ink.h"
#include "tactics/lettering/print_company.h"
#include "tactics/lettering/read_line.h"

namespace tactics {

namespace {

// Settings, relative to print that is known: heights from letters without ascenders to brackets; of its strokes.
constexpr double kLowest = 0.58, kHighest = 1.35, kThinner = 0.65, kThicker = 1.5;

// A letter is more than a bar or a block.
constexpr double kFilled = 0.8, kStraight = 0.85;

// The width of what it is drawn with, from its ink and its edge: a stroke has two of them for each pixel of its length.
double stroke_of(const InkPiece& piece) {
    int area = 0, shared = 0;
    for (std::size_t i = 0; i < piece.runs.size(); ++i) {
        const InkRun& run = piece.runs[i];
        area += run.right - run.left;
        for (std::size_t k = i + 1; k < piece.runs.size() && piece.runs[k].y <= run.y + 1; ++k)
            if (piece.runs[k].y == run.y + 1)
                shared += std::max(0, std::min(run.right, piece.runs[k].right) - std::max(run.left, piece.runs[k].left));
    }
    const int edge = 2 * static_cast<int>(piece.runs.size()) + 2 * (area - shared);
    return edge > 0 ? 2.0 * area / edge : 0;
}

double stroke_of(const LetteringLine& line) {
    double sum = 0;
    for (const InkPiece& piece : line.letters) sum += stroke_of(piece);
    return sum / static_cast<double>(line.letters.size());
}

bool is_small_form(const InkPiece& piece) {
    const MarkShape shape = mark_shape(piece);
    return shape.band < kStraight && shape.share < kFilled && shape.across > 2;
}

// Above and below it is the same ground. A tick stands on an axis, which may be as pale as what it blends with, or on the pale
// ground of a plot.
bool is_on_one_ground(const Image& grey, const PixelBox& box) {
    constexpr int kBeyond = 2, kAside = 3;  // pixels, behind what fades from it; of a row that noise is averaged in
    constexpr double kOneGround = 12;       // grey levels
    const int left = std::max(0, box.left - kAside), right = std::min(grey.width, box.right + kAside);
    const auto mean = [&](int y) {
        const std::uint8_t* row = grey.row(std::clamp(y, 0, grey.height - 1));
        return static_cast<double>(std::accumulate(row + left, row + right, 0)) / (right - left);
    };
    return std::abs(mean(box.top - 1 - kBeyond) - mean(box.bottom + kBeyond)) <= kOneGround;
}

// A piece as rows of pixels.
struct SmallForm {
    PixelBox box;
    std::vector<std::uint64_t> rows;

    explicit SmallForm(const InkPiece& piece) : box(piece.box), rows(static_cast<std::size_t>(piece.box.height()), 0) {
        for (const InkRun& run : piece.runs)
            for (int x = run.left; x < std::min(run.right, box.left + 64); ++x)
                rows[static_cast<std::size_t>(run.y - box.top)] |= std::uint64_t{1} << (x - box.left);
    }

    // Marks that lie otherwise between pixels have most of them in common, a pixel aside or not.
    bool is_like(const SmallForm& other) const {
        constexpr double kCommon = 0.6;  // of all their pixels; a setting
        if (std::abs(box.width() - other.box.width()) > 1 || std::abs(box.height() - other.box.height()) > 1) return false;
        for (int down = -1; down <= 1; ++down)
            for (int across = -1; across <= 1; ++across)
                if (common(other, down, across) >= kCommon) return true;
        return false;
    }

private:
    double common(const SmallForm& other, int down, int across) const {
        int both = 0, any = 0;
        const int height = static_cast<int>(std::max(rows.size(), other.rows.size()));
        for (int y = -1; y <= height; ++y) {
            const std::uint64_t own = row(y) << 1, its = other.row(y + down) << (1 + across);
            both += std::popcount(own & its);
            any += std::popcount(own | its);
        }
        return any > 0 ? static_cast<double>(both) / any : 0;
    }
    std::uint64_t row(int y) const { return y >= 0 && y < static_cast<int>(rows.size()) ? rows[static_cast<std::size_t>(y)] : 0; }
};

std::vector<SmallForm> forms_of(const std::vector<InkPiece>& pieces) { return {pieces.begin(), pieces.end()}; }

// Known print with what it is drawn with.
struct Company {
    const LetteringLine* line;
    double stroke;

    explicit Company(const LetteringLine* of) : line(of), stroke(stroke_of(*of)) {}
    bool has_size_of(const LetteringLine& other, double its_stroke) const {
        const double ratio = static_cast<double>(other.letter_height) / line->letter_height;
        return other.light == line->light && ratio >= kLowest && ratio <= kHighest && its_stroke >= kThinner * stroke &&
               its_stroke <= kThicker * stroke;
    }
};

bool is_small(const LetteringLine& line) { return is_words(line) && line.letter_height <= kMostSmallPrint; }

// Small print that was read, or what else is alike in four lines and more and was read as words that may be none.
KnownPrint known_small_print(const std::vector<ReadLine>& lines) {
    constexpr std::size_t kRead = 2, kLikely = 4;
    KnownPrint known, likely;
    for (const ReadLine& one : lines) {
        if (!is_small(one.line)) continue;
        if (!is_doubtful(one)) known.push_back(&one.line);
        if (!is_doubtful(one) || one.likely) likely.push_back(&one.line);
    }
    if (known.size() >= kRead) return known;
    const std::vector<Company> company(likely.begin(), likely.end());
    std::size_t at = 0;
    std::erase_if(likely, [&](const LetteringLine* one) {
        const double stroke = company[at++].stroke;
        return std::count_if(company.begin(), company.end(), [&](const Company& other) {
                   return other.has_size_of(*one, stroke) && std::abs(one->letter_height - other.line->letter_height) <= 1;
               }) < static_cast<std::ptrdiff_t>(kLikely);
    });
    return likely;
}

class SmallThings {
public:
    SmallThings(const Image& grey, const std::vector<ReadLine>& lines, const KnownPrint& known)
        : grey_(grey), lines_(lines), known_(known), company_(known.begin(), known.end()) {
        const LetteringLine& of = *known.front();
        const std::vector<InkPiece> pieces = pieces_of(grey, of.level, of.light, 2 * kMostSmallPrint);
        is_texture_ = pieces.size() > kTexture;
        if (is_texture_) return;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const LetteringLine& line = lines[i].line;
            on_scale_.push_back(!is_words(line) && line.letter_height <= kMostSmallPrint && is_sized(line) &&
                                is_on_scale(i, lines) &&
                                (is_small_form(line.letters.front()) || is_on_one_ground(grey, line.box)));
        }
        for (const InkPiece& piece : pieces)
            if (!is_of_words(piece.box)) free_.emplace_back(piece);
        find_marks();
    }

    SmallPrint find(std::size_t which) const {
        if (is_texture_) return SmallPrint::none;
        const ReadLine& one = lines_[which];
        const LetteringLine& line = one.line;
        const bool in_line = in_line_with_print(line, known_);
        const bool may_be_mark = !on_scale_[which] && (!in_line || (is_doubtful(one) && !is_words(line)));
        if (may_be_mark && is_among_marks(line)) return SmallPrint::mark;
        if (!is_doubtful(one) || line.letter_height > kMostSmallPrint || !is_sized(line)) return SmallPrint::none;
        if (on_scale_[which]) return SmallPrint::out;
        if (is_of_one_shape(line) || is_repeated(line) || !has_room_around(grey_, line)) return SmallPrint::none;
        if (!is_words(line)) return in_line && is_uneven(line.letters.front()) ? SmallPrint::told : SmallPrint::none;
        const auto forms = static_cast<std::size_t>(std::count_if(line.letters.begin(), line.letters.end(), is_small_form));
        const bool bars = 2 * forms < line.letters.size();
        if (bars ? !(in_line && one.likely) : !(in_line || one.likely)) return SmallPrint::none;
        return in_line && !bars ? SmallPrint::out : SmallPrint::told;
    }

private:
    static constexpr std::size_t kTexture = 2000;  // more is texture
    static constexpr std::size_t kMarks = 5;       // of one kind

    struct Marks {
        SmallForm form;
        PixelBox area;
    };

    // A letter by itself is the same on both sides, and above and below, no oftener than marks are not.
    static bool is_uneven(const InkPiece& piece) {
        constexpr double kEven = 0.03;  // of its box
        const MarkShape shape = mark_shape(piece);
        return is_small_form(piece) && (std::abs(shape.middle.x - 0.5) > kEven || std::abs(shape.middle.y - 0.5) > kEven);
    }

    bool is_sized(const LetteringLine& line) const {
        const double stroke = stroke_of(line);
        return std::any_of(company_.begin(), company_.end(), [&](const Company& one) { return one.has_size_of(line, stroke); });
    }

    bool is_of_words(const PixelBox& box) const {
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const ReadLine& one = lines_[i];
            const bool words = is_words(one.line) ? !is_of_one_shape(one.line) : one.words.sure || on_scale_[i];
            if (words && overlap(one.line.box, box)) return true;
        }
        return false;
    }

    // "oooo" and "////" are patterns.
    static bool is_of_one_shape(const LetteringLine& line) {
        constexpr std::size_t kSeveral = 3;
        if (line.letters.size() < kSeveral) return false;
        const std::vector<SmallForm> forms = forms_of(line.letters);
        return std::all_of(forms.begin() + 1, forms.end(), [&](const SmallForm& one) { return one.is_like(forms.front()); });
    }

    // All that it consists of is there three times and more elsewhere, and no part of words.
    bool is_repeated(const LetteringLine& line) const {
        constexpr std::ptrdiff_t kSeveral = 3;
        const std::vector<SmallForm> forms = forms_of(line.letters);
        return std::all_of(forms.begin(), forms.end(), [&](const SmallForm& form) {
            return std::count_if(free_.begin(), free_.end(), [&](const SmallForm& other) {
                       return !overlap(other.box, line.box) && form.is_like(other);
                   }) >= kSeveral;
        });
    }

    void find_marks() {
        std::vector<bool> taken(free_.size(), false);
        for (std::size_t i = 0; i < free_.size(); ++i) {
            if (taken[i] || std::min(free_[i].box.width(), free_[i].box.height()) < kLeastInkHeight) continue;
            Marks marks{free_[i], free_[i].box};
            std::size_t count = 0;
            for (std::size_t k = i; k < free_.size(); ++k) {
                if (!free_[k].is_like(free_[i])) continue;
                taken[k] = true;
                marks.area = around(marks.area, free_[k].box);
                ++count;
            }
            if (count >= kMarks) marks_.push_back(marks);
        }
    }

    // Marks of a plot beside or on top of each other.
    bool is_among_marks(const LetteringLine& line) const {
        constexpr std::size_t kFew = 3;
        constexpr double kMost = 3;  // times as large
        if (line.letters.size() > kFew) return false;
        const std::vector<SmallForm> forms = forms_of(line.letters);
        return std::any_of(marks_.begin(), marks_.end(), [&](const Marks& marks) {
            const PixelBox& mark = marks.form.box;
            return overlap(marks.area, line.box) && std::all_of(forms.begin(), forms.end(), [&](const SmallForm& form) {
                       const bool covered = form.box.width() >= mark.width() && form.box.height() >= mark.height() &&
                                            form.box.width() + form.box.height() >= mark.width() + mark.height() + 2;
                       const bool near = form.box.width() <= kMost * mark.width() && form.box.height() <= kMost * mark.height();
                       return form.is_like(marks.form) || (covered && near);
                   });
        });
    }

    const Image& grey_;
    const std::vector<ReadLine>& lines_;
    const KnownPrint& known_;
    const std::vector<Company> company_;
    bool is_texture_ = false;
    std::vector<bool> on_scale_;
    std::vector<SmallForm> free_;  // none of words
    std::vector<Marks> marks_;
};

}  // namespace

void add_low_print(const Image& grey, std::vector<LetteringLine>& lines, std::vector<LetteringLine> low) {
    std::vector<Company> company;
    for (const LetteringLine& line : lines)
        if (is_small(line) && !line.upwards) company.emplace_back(&line);
    if (company.empty()) return;
    const auto is_print = [&](const LetteringLine& one) {
        const auto forms = static_cast<std::size_t>(std::count_if(one.letters.begin(), one.letters.end(), is_small_form));
        if (2 * forms < one.letters.size()) return false;
        const double stroke = stroke_of(one);
        KnownPrint known;
        for (const Company& other : company)
            if (other.has_size_of(one, stroke)) known.push_back(other.line);
        return !known.empty() && (is_words(one) || in_line_with_print(one, known));
    };
    std::vector<LetteringLine> added;
    for (LetteringLine& one : low) {
        const bool free =
            std::none_of(added.begin(), added.end(), [&](const LetteringLine& other) { return overlap(other.box, one.box); });
        if (free && is_print(one)) added.push_back(std::move(one));
    }
    for (LetteringLine& one : added) {
        add_pale_ink(grey, one);
        lines.push_back(std::move(one));
    }
}

std::vector<SmallPrint> small_print(const Image& grey, const std::vector<ReadLine>& lines) {
    std::vector<SmallPrint> found(lines.size(), SmallPrint::none);
    const KnownPrint known = known_small_print(lines);
    if (known.empty()) return found;
    const SmallThings things(grey, lines, known);
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (!lines[i].words.sure) found[i] = things.find(i);
    return found;
}

}  // namespace tactics
