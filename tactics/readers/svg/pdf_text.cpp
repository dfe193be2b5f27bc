// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/pdf_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tactics/error.h"
#include "tactics/readers/svg/cairo_glyphs.h"
#include "tactics/readers/svg/plain_words.h"
#include "tactics/readers/xml.h"
#include "tactics/text/utf8.h"
#include "tactics/units.h"

namespace tactics {

namespace {

// In em. What a letter takes on average; a gap over which a line does not go on, and one over which a number does not, as between
// those of an axis: the spaces of a line may be wide, those within a number are not; and one that is no space.
constexpr double kPdfLetterWidth = 0.55, kPiece = 0.9, kPieceOfNumber = 0.45, kWide = 3, kSpace = 0.12;
// Shares of the size of a line: an exponent or an index is smaller, and off its base line.
constexpr double kSmall = 0.85, kOffLine = 0.1;

double number(std::string_view text) { return parse_number(text).value_or(0); }

Rect box_of(const Element& element) {
    const double left = number(element.attribute("xMin")), top = number(element.attribute("yMin"));
    return {left, top, number(element.attribute("xMax")) - left, number(element.attribute("yMax")) - top};
}

// Words one above the other run up or down, but no narrow letter with its index, such as I₁; a single word does so if it is much
// higher than wide.
void find_direction(PdfLine& line) {
    const PdfWord &first = line.words.front(), &last = line.words.back();
    const double across = std::abs(last.box.left - first.box.left), down = last.box.top - first.box.top;
    if (line.words.size() > 1) {
        const double both =
            std::min(first.box.left + first.box.width, last.box.left + last.box.width) - std::max(first.box.left, last.box.left);
        const bool stacked = both > 0.5 * std::min(first.box.width, last.box.width);
        line.upwards = stacked && across < -down;
        line.downwards = stacked && across < down;
    } else {
        line.upwards = letters_in(first.text) > 1 && first.box.height > 1.5 * first.box.width;
    }
}

// Along its line, whichever way that runs.
struct Along {
    double from = 0, to = 0, high = 0;
};
Along along(const PdfLine& line, const PdfWord& word) {
    const Rect& box = word.box;
    if (line.upwards) return {-(box.top + box.height), -box.top, box.width};
    if (line.downwards) return {box.top, box.top + box.height, box.width};
    return {box.left, box.left + box.width, box.height};
}

// The size of letters, from their widths: boxes of fonts differ more than letters do.
double size_of(const PdfLine& line, const std::vector<PdfWord>& words) {
    double width = 0, high = 0;
    std::size_t letters = 0;
    for (const PdfWord& word : words) {
        const Along at = along(line, word);
        width += at.to - at.from;
        high = std::max(high, at.high);
        letters += letters_in(word.text);
    }
    return std::clamp(width / (kPdfLetterWidth * static_cast<double>(std::max<std::size_t>(1, letters))), 0.45 * high,
                      0.9 * high);
}

// Letters of fonts that do not tell what they are may be any bytes, which XML has no place for.
constexpr std::string_view kReplacement = "\uFFFD";
std::string as_xml(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        std::string_view rest = text;
        const char32_t letter = take_letter(rest);
        const bool control = letter < 0x20 && letter != '\t' && letter != '\n' && letter != '\r';
        if (letter == kNoLetter || control || letter == 0xFFFE || letter == 0xFFFF)
            out += kReplacement;
        else
            out += text.substr(0, text.size() - rest.size());
        text = rest;
    }
    return out;
}

std::string in_xml(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else
            out += c;
    }
    return out;
}

constexpr std::string_view kMinus = "\u2212";

std::string with_degrees(std::string text) {
    for (const std::string_view ring : kRings)
        for (auto at = text.find(ring, 1); at != std::string::npos; at = text.find(ring, at + 1))
            if (text[at - 1] >= '0' && text[at - 1] <= '9') text.replace(at, ring.size(), kDegree);
    return text;
}

bool begins_with_digit(std::string_view text) { return text[0] == '.' || (text[0] >= '0' && text[0] <= '9'); }

// A word with the letters that cairo drew for it.
struct SeenWord {
    const PdfWord* word = nullptr;
    std::vector<std::size_t> letters = {};
};

LineRuns runs_of(const PdfLine& line) {
    return line.upwards ? LineRuns::upwards : line.downwards ? LineRuns::downwards : LineRuns::across;
}

// Words of a line that go on without a gap.
struct Run {
    const PdfLine* line = nullptr;
    std::vector<SeenWord> words = {};
};

Rect box_of(const Run& run) {
    Rect all = run.words.front().word->box;
    for (const SeenWord& seen : run.words) {
        const Rect& box = seen.word->box;
        const double right = std::max(all.left + all.width, box.left + box.width),
                     bottom = std::max(all.top + all.height, box.top + box.height);
        all.left = std::min(all.left, box.left);
        all.top = std::min(all.top, box.top);
        all.width = right - all.left;
        all.height = bottom - all.top;
    }
    return all;
}

// What a run says, in XML.
std::string said(const Run& run, double size, double high, double base, CairoGlyphs& glyphs) {
    const PdfLine& line = *run.line;
    const bool across = !line.upwards && !line.downwards;
    std::string words;
    for (std::size_t i = 0; i < run.words.size(); ++i) {
        const SeenWord& seen = run.words[i];
        const Along here = along(line, *seen.word);
        const bool small = across && here.high < kSmall * high;
        const double stands = glyphs.base_of(seen.letters), rise = small ? base - stands : 0;
        std::string word = seen.word->text;
        const bool minus =
            across && begins_with_digit(word) && glyphs.take_minus(seen.word->box, size_of(line, {*seen.word}), stands);
        if (minus) word = std::string(kMinus) + word;
        const bool off = std::abs(rise) > kOffLine * size && i > 0;
        if (i > 0 && !off && here.from - along(line, *run.words[i - 1].word).to > kSpace * size) words += ' ';
        words += in_xml(off ? off_line(word, rise > 0) : word);
    }
    return words;
}

// The run as an element of SVG; empty: it has letters that the font has not, and is left to who reads shapes.
std::string text_element(const Run& run, CairoGlyphs& glyphs) {
    const PdfLine& line = *run.line;
    std::vector<PdfWord> words;
    std::vector<std::size_t> letters, upright;
    double high = 0;
    for (const SeenWord& seen : run.words) {
        words.push_back(*seen.word);
        letters.insert(letters.end(), seen.letters.begin(), seen.letters.end());
        high = std::max(high, along(line, *seen.word).high);
    }
    const double size = size_of(line, words);
    for (const SeenWord& seen : run.words)
        if (along(line, *seen.word).high >= kSmall * high)
            upright.insert(upright.end(), seen.letters.begin(), seen.letters.end());
    const double base = glyphs.base_of(upright);
    const Rect box = box_of(run);
    const std::string text = said(run, size, high, base, glyphs);
    if (glyphs.adopt_shapes(letters, box, runs_of(line), size)) return "";
    glyphs.take(letters);
    const Point middle = box.middle();
    const double down = 0.36 * size;
    std::string element = "<text font-size=\"" + to_text(size) + "\" text-anchor=\"middle\" ";
    if (line.upwards || line.downwards)
        element += "transform=\"translate(" + to_text(middle.x) + " " + to_text(middle.y) + ") rotate(" +
                   (line.upwards ? "-90" : "90") + ")\" x=\"0\" y=\"" + to_text(down) + "\">";
    else
        element += "x=\"" + to_text(middle.x) + "\" y=\"" + to_text(base) + "\">";
    return element + text + "</text>\n";
}

// Pieces of a line that pdftotext tells as lines of their own, such as an exponent with a minus.
bool goes_on(const PdfLine& line, const PdfLine& next) {
    if (line.upwards || line.downwards || next.upwards || next.downwards) return false;
    const Rect &end = line.words.back().box, &begin = next.words.front().box;
    const double overlap = std::min(end.top + end.height, begin.top + begin.height) - std::max(end.top, begin.top);
    const double low = std::min(end.height, begin.height), gap = begin.left - (end.left + end.width);
    return overlap > 0.5 * low && gap > -0.2 * low && gap < 0.3 * low;
}

std::vector<PdfLine> joined_lines(const PdfText& text) {
    std::vector<PdfLine> lines;
    for (const PdfBlock& block : text.blocks)
        for (const PdfLine& line : block.lines) {
            if (!lines.empty() && goes_on(lines.back(), line))
                lines.back().words.insert(lines.back().words.end(), line.words.begin(), line.words.end());
            else
                lines.push_back(line);
        }
    return lines;
}

// Letters of words, those of the smallest first.
std::vector<std::vector<SeenWord>> seen_words(const std::vector<PdfLine>& lines, CairoGlyphs& glyphs) {
    std::vector<std::vector<SeenWord>> seen(lines.size());
    std::vector<SeenWord*> order;
    for (std::size_t i = 0; i < lines.size(); ++i)
        for (const PdfWord& word : lines[i].words) seen[i].push_back({&word});
    for (auto& line : seen)
        for (SeenWord& word : line) order.push_back(&word);
    std::stable_sort(order.begin(), order.end(),
                     [](const SeenWord* a, const SeenWord* b) { return a->word->box.height < b->word->box.height; });
    for (SeenWord* word : order) word->letters = glyphs.claim(word->word->box);
    return seen;
}

bool is_plain_number(std::string_view text) { return text.find_first_not_of("0123456789.,") == std::string_view::npos; }

// Without a gap, or over a letter that was drawn by itself.
bool goes_on(const Run& run, const SeenWord& next, double size, CairoGlyphs& glyphs) {
    const SeenWord& last = run.words.back();
    const double gap = std::abs(along(*run.line, *next.word).from - along(*run.line, *last.word).to);
    const bool numbers = is_plain_number(last.word->text) && is_plain_number(next.word->text);
    return gap < (numbers ? kPieceOfNumber : kPiece) * size ||
           (gap < kWide * size &&
            glyphs.has_shape_between(last.word->box, next.word->box, last.letters, runs_of(*run.line), size));
}

// What stands before may be the author's, and is no XML.
std::string_view body_of(std::string_view told, const std::string& file) {
    const auto from = told.find("<doc>"), to = told.rfind("</doc>");
    if (from == std::string_view::npos || to == std::string_view::npos || to < from)
        throw Error(Fault::failed, file, phrase("pdftotext does not tell its words; open it in a viewer to see what is wrong"));
    return told.substr(from, to + 6 - from);
}

// What cannot be told by a letter that there is.
bool is_readable(const PdfWord& word) { return word.text.find(kReplacement) == std::string::npos; }

}  // namespace

std::size_t PdfText::count() const {
    std::size_t words = 0;
    for (const PdfBlock& block : blocks)
        for (const PdfLine& line : block.lines) words += line.words.size();
    return words;
}

PdfText pdf_text_of(std::string_view bbox_layout, const std::string& file) {
    const Element root = parse_xml(as_xml(body_of(bbox_layout, file)), file);
    PdfText text;
    if (root.children.empty()) return text;
    const Element& page = root.children.front();
    text.width = number(page.attribute("width"));
    text.height = number(page.attribute("height"));
    for (const Element& flow : page.children)
        for (const Element& block : flow.children) {
            PdfBlock& into = text.blocks.emplace_back();
            for (const Element& line : block.children) {
                PdfLine found;
                for (const Element& word : line.children)
                    if (!to_line(word.text).empty()) found.words.push_back({with_degrees(to_line(word.text)), box_of(word)});
                if (found.words.empty()) continue;
                find_direction(found);
                into.lines.push_back(std::move(found));
            }
        }
    return text;
}

namespace {

// The parts of a word, if they stand apart as words do.
std::vector<PdfWord> parts_of(const PdfWord& word, const std::vector<PdfWord>& loose) {
    constexpr double kSame = 0.05, kApart = 0.2;  // points; of the height: letters of a spaced title stand nearer
    std::vector<PdfWord> parts;
    std::string said;
    for (const PdfWord& one : loose) {
        const bool same_row = std::abs(one.box.top - word.box.top) < kSame && std::abs(one.box.height - word.box.height) < kSame;
        if (!same_row || one.box.left < word.box.left - kSame || said.size() >= word.text.size()) continue;
        const bool begins = parts.empty() && std::abs(one.box.left - word.box.left) < kSame;
        const double gap = parts.empty() ? 0 : one.box.left - parts.back().box.left - parts.back().box.width;
        if (!begins && (parts.empty() || gap < kApart * word.box.height)) continue;
        parts.push_back(one);
        said += one.text;
    }
    return parts.size() > 1 && said == word.text ? parts : std::vector<PdfWord>{word};
}

}  // namespace

void part_words(PdfText& text, std::string_view raw_bbox, const std::string& file) {
    constexpr std::size_t kMostLetters = 6;
    std::vector<PdfWord> loose;
    const Element root = parse_xml(as_xml(body_of(raw_bbox, file)), file);
    for (const Element& page : root.children)
        for (const Element& word : page.children)
            if (!to_line(word.text).empty()) loose.push_back({with_degrees(to_line(word.text)), box_of(word)});
    for (PdfBlock& block : text.blocks)
        for (PdfLine& line : block.lines) {
            if (line.upwards || line.downwards) continue;
            std::vector<PdfWord> words;
            for (const PdfWord& word : line.words) {
                const std::size_t letters = letters_in(word.text);
                if (letters < 2 || letters > kMostLetters)
                    words.push_back(word);
                else
                    for (PdfWord& part : parts_of(word, loose)) words.push_back(std::move(part));
            }
            line.words = std::move(words);
        }
}

std::string with_words(std::string_view svg, const PdfText& text) {
    CairoGlyphs glyphs(svg);
    const std::vector<PdfLine> lines = joined_lines(text);
    std::vector<std::vector<SeenWord>> seen = seen_words(lines, glyphs);
    std::string texts;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        // What nobody sees is no word, and what is slanted or unreadable is left as it is drawn.
        std::erase_if(seen[i], [&](const SeenWord& word) {
            return word.letters.empty() || glyphs.are_slanted(word.letters) || !is_readable(*word.word);
        });
        if (seen[i].empty()) continue;
        const double size = size_of(lines[i], lines[i].words);
        Run run{&lines[i]};
        for (SeenWord& word : seen[i]) {
            if (!run.words.empty() && !goes_on(run, word, size, glyphs))
                texts += text_element(std::exchange(run, Run{&lines[i]}), glyphs);
            run.words.push_back(std::move(word));
        }
        texts += text_element(run, glyphs);
    }
    return glyphs.without_taken(texts);
}

}  // namespace tactics
