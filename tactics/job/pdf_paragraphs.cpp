// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/pdf_paragraphs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "tactics/readers/svg/plain_words.h"
#include "tactics/text/words.h"

namespace tactics {

namespace {

constexpr double kLarger = 1.15;                // times the usual height: a heading's letters
constexpr std::size_t kLongestHeading = 120;    // bytes of a line
constexpr int kMostHeadingLines = 3;            // more are a paragraph in large print
constexpr std::size_t kHeadingsAmongWords = 3;  // at most one word in three is in headings
constexpr double kMovedIn = 0.8;                // line heights: where a paragraph begins

double height_of(const PdfLine& line) {
    double high = 0;
    for (const PdfWord& word : line.words)
        high = std::max(high, line.upwards || line.downwards ? word.box.width : word.box.height);
    return high;
}

enum class LineLevel { on_line, above, below };

// The baseline of a font as a share of a word's box from its top: between those of Helvetica and DejaVu.
double base_of(const Rect& box) { return box.top + 0.78 * box.height; }

// Exponents, indices and marks of notes are smaller than the word beside them and a little off its line. An initial that is
// several lines high is none of their words.
LineLevel level_of(const Rect& word, const Rect& beside) {
    constexpr double kSmallest = 0.45, kLargest = 0.85, kLeastOff = 0.1, kMostOff = 0.55;  // shares of the height beside it
    const double size = word.height / beside.height, off = (base_of(beside) - base_of(word)) / beside.height;
    if (size < kSmallest || size > kLargest || std::abs(off) < kLeastOff || std::abs(off) > kMostOff) return LineLevel::on_line;
    return off > 0 ? LineLevel::above : LineLevel::below;
}

std::vector<LineLevel> levels_in(const PdfLine& line) {
    std::vector<LineLevel> levels(line.words.size(), LineLevel::on_line);
    if (line.upwards || line.downwards) return levels;
    const double high = height_of(line);
    const auto first =
        std::find_if(line.words.begin(), line.words.end(), [high](const PdfWord& word) { return word.box.height >= high; });
    const Rect* beside = &first->box;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        levels[i] = level_of(line.words[i].box, *beside);
        if (levels[i] == LineLevel::on_line) beside = &line.words[i].box;
    }
    return levels;
}

bool is_footnote_number(std::string_view text) { return text.find_first_not_of("0123456789") == std::string_view::npos; }

// In the form of one line of characters. "before" is the preceding character.
std::string off_line(const std::string& text, LineLevel level, std::string_view before) {
    constexpr std::array<std::string_view, 4> kOrdinals = {"st", "nd", "rd", "th"};
    if (level == LineLevel::below) return is_footnote_number(text) ? text : "_(" + text + ")";
    const bool counts = !before.empty() && before.back() >= '0' && before.back() <= '9';
    if (counts && std::find(kOrdinals.begin(), kOrdinals.end(), text) != kOrdinals.end()) return text;
    const std::string power = raised(text);
    return power.empty() ? "^(" + text + ")" : power;
}

// Whether a blank parts two words of a line; what is off the line stands closer to its word than a blank is wide.
bool is_parted(const PdfLine& line, std::size_t i, bool off) {
    constexpr double kSpace = 0.12, kBlank = 0.25;  // shares of the height of letters
    const Rect &before = line.words[i - 1].box, &word = line.words[i].box;
    if (line.upwards || line.downwards) return true;
    const double gap = word.left - (before.left + before.width);
    if (off) return gap >= kBlank * std::max(before.height, word.height);
    return std::abs(gap) >= kSpace * std::min(before.height, word.height);  // one over the other are two
}

bool goes_on_in(const TextBlock& block, const TextBlock& next) {
    using Kind = TextBlock::Kind;
    return block.kind == Kind::paragraph && next.kind == Kind::paragraph && ends_parted(block.text) && begins_small(next.text);
}

}  // namespace

std::string words_of(const PdfLine& line) {
    const std::vector<LineLevel> levels = levels_in(line);
    std::string words;
    for (std::size_t i = 0; i < line.words.size();) {
        const LineLevel level = levels[i];
        if (i > 0 && is_parted(line, i, level != LineLevel::on_line)) words += ' ';
        std::string piece = line.words[i].text;  // of one level
        while (++i < line.words.size() && levels[i] == level)
            piece += (is_parted(line, i, false) ? " " : "") + line.words[i].text;
        words += level == LineLevel::on_line ? piece : off_line(piece, level, words);
    }
    return words;
}

double usual_height(const std::vector<PdfText>& pages) {
    std::map<long, std::size_t> words;  // by height in quarters of a point
    for (const PdfText& page : pages)
        for (const PdfBlock& block : page.blocks)
            for (const PdfLine& line : block.lines) words[std::lround(4 * height_of(line))] += line.words.size();
    const auto most =
        std::max_element(words.begin(), words.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == words.end() ? 0 : static_cast<double>(most->first) / 4;
}

std::vector<TextBlock> paragraphs_of(const PdfText& page, double usual, PartedWords& parted) {
    using Kind = TextBlock::Kind;
    std::vector<TextBlock> blocks;
    for (const PdfBlock& block : page.blocks) {
        if (block.lines.empty()) continue;
        double left = INFINITY;
        for (const PdfLine& line : block.lines) left = std::min(left, line.words.front().box.left);
        int lines = 0;  // of what is built now
        bool heading = false;
        for (const PdfLine& line : block.lines) {
            const double high = height_of(line);
            const std::string words = words_of(line);
            const bool large = high > kLarger * usual && words.size() <= kLongestHeading;
            const bool moved_in = line.words.front().box.left > left + kMovedIn * high;
            if (lines == 0 || large != heading || (moved_in && !large)) {
                blocks.push_back({large ? Kind::heading : Kind::paragraph, ""});
                lines = 0;
            }
            parted.join(blocks.back().text, words);
            heading = large;
            if (++lines > kMostHeadingLines) blocks.back().kind = Kind::paragraph;
        }
    }
    return blocks;
}

std::vector<TextBlock> paragraphs_of(const std::vector<PdfText>& pages, PartedWords& parted) {
    using Kind = TextBlock::Kind;
    for (const PdfText& page : pages)
        for (const PdfBlock& block : page.blocks)
            for (const PdfLine& line : block.lines) parted.show(words_of(line));
    const double usual = usual_height(pages);
    std::vector<TextBlock> blocks;
    for (const PdfText& page : pages)
        for (TextBlock& block : paragraphs_of(page, usual, parted)) {
            if (!blocks.empty() && goes_on_in(blocks.back(), block))
                parted.join(blocks.back().text, block.text);
            else
                blocks.push_back(std::move(block));
        }
    std::size_t words = 0, in_headings = 0;
    for (const TextBlock& block : blocks) {
        const std::size_t own = words_of(block.text).size();
        words += own;
        if (block.kind == Kind::heading) in_headings += own;
    }
    if (kHeadingsAmongWords * in_headings > words)
        for (TextBlock& block : blocks) block.kind = Kind::paragraph;
    return blocks;
}

}  // namespace tactics
