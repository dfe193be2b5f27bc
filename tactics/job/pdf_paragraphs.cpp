// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/pdf_paragraphs.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "tactics/text/words.h"

namespace tactics {

namespace {

constexpr double kLarger = 1.15;                // times the usual height: a heading's letters
constexpr std::size_t kLongestHeading = 120;    // bytes of a line
constexpr int kMostHeadingLines = 3;            // more are a paragraph in large print
constexpr std::size_t kHeadingsAmongWords = 3;  // one word in three at most stands in headings
constexpr double kMovedIn = 0.8;                // line heights: where a paragraph begins

double height_of(const PdfLine& line) {
    double high = 0;
    for (const PdfWord& word : line.words)
        high = std::max(high, line.upwards || line.downwards ? word.box.width : word.box.height);
    return high;
}

bool goes_on_in(const TextBlock& block, const TextBlock& next) {
    using Kind = TextBlock::Kind;
    return block.kind == Kind::paragraph && next.kind == Kind::paragraph && ends_parted(block.text) && begins_small(next.text);
}

}  // namespace

std::string words_of(const PdfLine& line) {
    std::string words;
    for (const PdfWord& word : line.words) words += (words.empty() ? "" : " ") + word.text;
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
