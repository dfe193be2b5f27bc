// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/written.h"

#include <algorithm>

#include "tactics/error.h"
#include "tactics/job/figure.h"
#include "tactics/job/holds.h"
#include "tactics/job/pdf_paragraphs.h"
#include "tactics/readers/svg/cairo_glyphs.h"
#include "tactics/readers/svg/pdf.h"
#include "tactics/text/parted_words.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr std::size_t kLongLine = 5, kFewWords = 30;   // words
constexpr double kMostInLines = 0.6;                   // share of words that stand in long lines
constexpr int kPagesAtOnce = 50, kMostPages = 20'000;  // of a PDF

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

// "2", "1, 3 to 5".
std::string list_of(const std::vector<int>& pages) {
    constexpr std::size_t kNamed = 12;  // runs of pages
    std::string list;
    std::size_t named = 0;
    for (std::size_t i = 0; i < pages.size(); ++named) {
        std::size_t end = i + 1;
        while (end < pages.size() && pages[end] == pages[end - 1] + 1) ++end;
        if (named == kNamed) return list + " and " + std::to_string(pages.size() - i) + " more";
        list += (list.empty() ? "" : ", ") + std::to_string(pages[i]);
        if (end > i + 1) list += (end > i + 2 ? " to " : ", ") + std::to_string(pages[end - 1]);
        i = end;
    }
    return list;
}

Error too_much(const Source& source, bool pdf) {
    return Error(Fault::failed, source.name,
                 pdf ? "this PDF has over 4 MB of text or 20,000 pages; lay out a part of it with " + spelled("page")
                     : "this text has over 4 MB; cut it into parts");
}

std::vector<PdfText> read_pages(const Source& source, const PageRange& pages) {
    std::vector<PdfText> texts;
    std::size_t bytes = 0;
    for (int first = pages.first; first <= pages.last; first += kPagesAtOnce)
        for (PdfText& page : pdf_texts(source, first, std::min(pages.last, first + kPagesAtOnce - 1))) {
            for (const PdfBlock& block : page.blocks)
                for (const PdfLine& line : block.lines)
                    for (const PdfWord& word : line.words) bytes += word.text.size() + 1;
            if (bytes > kMostTextBytes) throw too_much(source, true);
            texts.push_back(std::move(page));
        }
    return texts;
}

// What is not set, page by page.
void tell_left_out(const Source& source, const std::vector<PdfText>& texts, const PageRange& pages,
                   std::vector<std::string>& notes) {
    std::vector<int> without_words, with_drawings, not_looked_at;
    for (int first = pages.first; first <= pages.last; first += kPagesAtOnce) {
        const int last = std::min(pages.last, first + kPagesAtOnce - 1);
        std::vector<bool> drawn(static_cast<std::size_t>(last - first + 1));
        try {
            drawn = pdf_pages_drawn(source, first, last);
        } catch (const Error&) {
            for (int page = first; page <= last; ++page) not_looked_at.push_back(page);
        }
        for (int page = first; page <= last; ++page) {
            if (!drawn[static_cast<std::size_t>(page - first)]) continue;
            const bool words = texts[static_cast<std::size_t>(page - pages.first)].count() > 0;
            (words ? with_drawings : without_words).push_back(page);
        }
    }
    const auto tell = [&](const std::vector<int>& which, const std::string& one, const std::string& many) {
        if (which.size() == 1) notes.push_back("page " + list_of(which) + one);
        if (which.size() > 1) notes.push_back("pages " + list_of(which) + many);
    };
    tell(without_words, " has no words and is left out; it may be a scan, have it read first: ocrmypdf",
         " have no words and are left out; they may be scans, have them read first: ocrmypdf");
    tell(with_drawings, " has drawings or pictures besides its words, which are left out",
         " have drawings or pictures besides their words, which are left out");
    tell(not_looked_at, " takes too much to be looked at for drawings and scans, which are left out",
         " take too much to be looked at for drawings and scans, which are left out");
}

Written written_in_pdf(const Source& source, PageRange pages) {
    const int count = pages_of_pdf(source);
    if (pages.last > count)
        throw Error(Fault::usage, source.name,
                    "there is no page " + std::to_string(pages.last) + ", but pages 1 to " + std::to_string(count));
    if (pages.first == 0) pages = {1, count};
    if (pages.last - pages.first >= kMostPages) throw too_much(source, true);
    const std::vector<PdfText> texts = read_pages(source, pages);
    PartedWords parted;
    Written written{paragraphs_of(texts, parted), {}};
    if (written.blocks.empty()) return written;
    tell_left_out(source, texts, pages, written.notes);
    if (parted.guesses() > 0) {
        std::string named;
        for (const std::string& word : parted.guessed()) named += (named.empty() ? "\"" : ", \"") + word + "\"";
        const bool one = parted.guesses() == 1;
        written.notes.push_back(
            std::to_string(parted.guesses()) +
            (one ? " word that was parted at the end of a line is put together without its hyphen: "
                 : " words that were parted at the ends of lines are put together without their hyphens, as ") +
            named);
    }
    return written;
}

std::string text_of_file(const Source& source) {
    const std::string text = bytes_of(source.file.get());
    if (text.size() > kMostTextBytes) throw too_much(source, false);
    for (std::string_view rest = text; !rest.empty();)
        if (const char32_t letter = take_letter(rest); letter == kNoLetter || letter == 0)
            throw Error(Fault::failed, source.name,
                        "it is no text in UTF-8; save it as UTF-8, or convert it: iconv -f latin1 -t utf-8");
    return text;
}

}  // namespace

std::vector<TextBlock> blocks_of_text(std::string_view text) {
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
            blocks.back().kind = TextBlock::Kind::heading;
            goes_on = false;
            continue;
        }
        if (line.starts_with('#')) {
            const auto words = std::min(line.find_first_not_of("# "), line.size());
            if (words < line.size()) blocks.push_back({TextBlock::Kind::heading, std::string(line.substr(words))});
            goes_on = false;
            continue;
        }
        if (!goes_on || begins_anew(line)) blocks.emplace_back();
        join_typed_line(blocks.back().text, line);
        goes_on = true;
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

Written text_in(Source& source, PageRange pages) {
    const bool pdf = look_at(source) == Holds::pdf;
    if (!pdf && pages.first > 0) throw Error(Fault::usage, spelled("page"), source.name + " is no PDF; leave it out");
    Written written = pdf ? written_in_pdf(source, pages) : Written{blocks_of_text(text_of_file(source)), {}};
    std::erase_if(written.blocks, [](const TextBlock& block) { return to_line(block.text).empty(); });
    if (written.blocks.empty())
        throw Error(Fault::failed, source.name,
                    pdf ? "nothing is written in it that could be laid out as text; if it is a scan, have it read first: ocrmypdf"
                        : "nothing is written in it that could be laid out as text");
    return written;
}

}  // namespace tactics
