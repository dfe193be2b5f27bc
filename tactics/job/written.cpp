// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/written.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "tactics/error.h"
#include "tactics/job/figure.h"
#include "tactics/job/holds.h"
#include "tactics/readers/svg/cairo_glyphs.h"
#include "tactics/readers/svg/pdf.h"
#include "tactics/readers/xml.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr std::size_t kLongLine = 5, kFewWords = 30;  // words
constexpr double kMostInLines = 0.6;                  // share of words that stand in long lines
constexpr double kLarger = 1.15;                      // times the usual height: a heading's letters
constexpr std::size_t kLongestHeading = 120;          // bytes
constexpr double kMovedIn = 0.8;                      // line heights: where a paragraph begins

bool is_small_letter(char c) { return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0xC3; }

// A line goes on: "exam-" and "ple" are one word.
void join(std::string& text, std::string_view more) {
    if (text.ends_with('-') && text.size() > 1 && is_small_letter(text[text.size() - 2]) && is_small_letter(more[0]))
        text.pop_back();
    else if (!text.empty())
        text += ' ';
    text += more;
}

std::string words_of(const PdfLine& line) {
    std::string words;
    for (const PdfWord& word : line.words) words += (words.empty() ? "" : " ") + word.text;
    return words;
}

double height_of(const PdfLine& line) {
    double high = 0;
    for (const PdfWord& word : line.words)
        high = std::max(high, line.upwards || line.downwards ? word.box.width : word.box.height);
    return high;
}

std::string_view take_line(std::string_view& text) {
    const auto end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t')) line.remove_suffix(1);
    return line;
}

bool is_rule(std::string_view line, char of) { return line.size() >= 3 && line.find_first_not_of(of) == std::string_view::npos; }

// "- milk", "* milk", "3. milk", or moved in: begins by itself.
bool begins_anew(std::string_view line) {
    const auto digits = std::min(line.find_first_not_of("0123456789"), line.size());
    return line[0] == ' ' || line[0] == '\t' || line.starts_with("- ") || line.starts_with("* ") || line.starts_with("\u2022") ||
           (digits > 0 && digits < line.size() && (line[digits] == '.' || line[digits] == ')'));
}

std::vector<TextBlock> blocks_of_text(std::string_view text) {
    using Kind = TextBlock::Kind;
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
    std::vector<TextBlock> blocks;
    bool goes_on = false;
    while (!text.empty()) {
        std::string_view line = take_line(text);
        if (line.empty()) {
            goes_on = false;
            continue;
        }
        if (goes_on && (is_rule(line, '=') || is_rule(line, '-'))) {
            blocks.back().kind = Kind::heading;
            goes_on = false;
            continue;
        }
        if (line.starts_with('#')) {
            const auto words = std::min(line.find_first_not_of("# "), line.size());
            if (words < line.size()) blocks.push_back({Kind::heading, std::string(line.substr(words))});
            goes_on = false;
            continue;
        }
        if (!goes_on || begins_anew(line)) blocks.emplace_back();
        join(blocks.back().text, line);
        goes_on = true;
    }
    return blocks;
}

std::vector<TextBlock> blocks_of_pdf(Source& source, int page) {
    const int last = page > 0 ? page : pages_of_pdf(source);
    std::vector<TextBlock> blocks;
    for (int one = std::max(1, page); one <= last; ++one) {
        const PdfText text = pdf_text(source, one);
        for (TextBlock& block : paragraphs_of(text, usual_height(text))) blocks.push_back(std::move(block));
    }
    return blocks;
}

}  // namespace

double usual_height(const PdfText& text) {
    std::map<long, std::size_t> words;  // by height in quarters of a point
    for (const PdfBlock& block : text.blocks)
        for (const PdfLine& line : block.lines) words[std::lround(4 * height_of(line))] += line.words.size();
    const auto most =
        std::max_element(words.begin(), words.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == words.end() ? 0 : static_cast<double>(most->first) / 4;
}

std::vector<TextBlock> paragraphs_of(const PdfText& text, double usual) {
    std::vector<TextBlock> blocks;
    for (const PdfBlock& block : text.blocks) {
        if (block.lines.empty()) continue;
        double left = INFINITY;
        for (const PdfLine& line : block.lines) left = std::min(left, line.words.front().box.left);
        bool first = true, heading = false;
        for (const PdfLine& line : block.lines) {
            const double high = height_of(line);
            const std::string words = words_of(line);
            const bool large = high > kLarger * usual && words.size() <= kLongestHeading;
            const bool moved_in = line.words.front().box.left > left + kMovedIn * high;
            if (first || large != heading || (moved_in && !large))
                blocks.push_back({large ? TextBlock::Kind::heading : TextBlock::Kind::paragraph, ""});
            join(blocks.back().text, words);
            heading = large;
            first = false;
        }
    }
    return blocks;
}

bool is_text(const PdfText& text, std::size_t drawn) {
    const std::size_t words = text.count();
    if (words == 0) return false;
    if (drawn == 0) return true;
    std::size_t in_lines = 0;
    for (const PdfBlock& block : text.blocks)
        for (const PdfLine& line : block.lines)
            if (line.words.size() >= kLongLine) in_lines += line.words.size();
    return words >= kFewWords && static_cast<double>(in_lines) >= kMostInLines * static_cast<double>(words);
}

bool is_page_of_text(const Source& pdf, int page) {
    const PdfText text = pdf_text(pdf, page);
    const auto svg = pdf_page_as_svg(pdf, page, text);
    return is_text(text, svg ? drawn_in(*svg) : 1);
}

std::vector<TextBlock> text_in(Source& source, int page) {
    std::vector<TextBlock> blocks;
    if (look_at(source) == Holds::pdf) {
        blocks = blocks_of_pdf(source, page);
    } else {
        if (page > 0) throw Error(Fault::usage, spelled("page"), source.name + " is no PDF; leave it out");
        const std::string text = bytes_of(source.file.get());
        if (text.size() > kMostXmlBytes) throw Error(Fault::failed, source.name, "this text has over 64 MB; cut it into parts");
        for (std::string_view rest = text; !rest.empty();)
            if (const char32_t letter = take_letter(rest); letter == kNoLetter || letter == 0)
                throw Error(Fault::failed, source.name,
                            "it is no text in UTF-8; save it as UTF-8, or convert it: iconv -f latin1 -t utf-8");
        blocks = blocks_of_text(text);
    }
    std::erase_if(blocks, [](const TextBlock& block) { return to_line(block.text).empty(); });
    if (blocks.empty())
        throw Error(Fault::failed, source.name,
                    "nothing is written in it that could be laid out as text; if it is a scan, have it read first: ocrmypdf");
    return blocks;
}

}  // namespace tactics
