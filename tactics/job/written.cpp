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
#include "tactics/text/words.h"

namespace tactics {

namespace {

constexpr std::size_t kLongLine = 5, kFewWords = 30;   // words
constexpr double kMostInLines = 0.6;                   // share of words that stand in long lines
constexpr int kPagesAtOnce = 50, kMostPages = 20'000;  // of a PDF

std::string_view without_blanks_behind(std::string_view line) { return line.substr(0, line.find_last_not_of(" \t\r") + 1); }

std::string_view take_line(std::string_view& text) {
    const auto end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

bool is_rule(std::string_view line) {
    return line.size() >= 3 && (line[0] == '=' || line[0] == '-') && line.find_first_not_of(line[0]) == std::string_view::npos;
}

// "3.", "12)".
bool is_number_of_list(std::string_view text) {
    constexpr std::size_t kYear = 4;  // digits of one, which ends a sentence
    const auto digits = std::min(text.find_first_not_of("0123456789"), text.size());
    return digits > 0 && digits < kYear && digits + 1 == text.size() && (text[digits] == '.' || text[digits] == ')');
}

// "- milk", "* milk", "3. milk", or indented: begins a paragraph.
bool begins_anew(std::string_view line) {
    const std::string_view first = line.substr(0, line.find_first_of(kBlanks));
    return first.empty() || first == "-" || first == "*" || first.starts_with("\u2022") || is_number_of_list(first);
}

// What stands behind one to six # and a blank.
std::string_view heading_in(std::string_view line) {
    constexpr std::size_t kMostMarks = 6;
    const auto marks = std::min(line.find_first_not_of('#'), line.size());
    const bool is = marks > 0 && marks <= kMostMarks && marks < line.size() && (line[marks] == ' ' || line[marks] == '\t');
    return is ? trimmed(line.substr(marks)) : std::string_view();
}

// Whether it has tabs between words, as between the cells of a table. A tab after a list mark does not count.
bool is_row(std::string_view line) {
    line = trimmed(line);
    const auto tab = line.find('\t');
    if (tab == std::string_view::npos) return false;
    const std::string_view first = line.substr(0, tab);
    const bool mark = first == "-" || first == "*" || first == "\u2022" || is_number_of_list(first);
    return !mark || line.find('\t', line.find_first_not_of(kBlanks, tab)) != std::string_view::npos;
}

std::string with_parted_cells(std::string_view row) {
    std::string out;
    for (const char c : row) out += c == '\t' ? " | " : std::string(1, c);
    return out;
}

class TextFile {
public:
    void take(std::string_view raw) {
        const std::string_view line = without_blanks_behind(raw);
        if (line.empty()) {
            lines_ = 0;
            after_row_ = false;
        } else if (is_rule(line)) {
            take_rule(line);
        } else if (const std::string_view heading = heading_in(line); !heading.empty()) {
            add(TextBlock::Kind::heading, heading);
        } else if (is_row(raw) || (after_row_ && raw.starts_with('\t'))) {
            add(TextBlock::Kind::paragraph, with_parted_cells(raw));
            after_row_ = has_rows_ = true;
        } else {
            if (lines_ == 0 || begins_anew(line)) {
                blocks_.emplace_back();
                lines_ = 0;
            }
            ++lines_;
            after_row_ = false;
            join_typed_line(blocks_.back().text, line);
        }
    }

    Written written() {
        Written all{std::move(blocks_), {}};
        if (has_rows_)
            all.notes.emplace_back(phrase("tabs between words are set as |, so that the cells of tables can be told apart"));
        return all;
    }

private:
    // After several lines it makes no heading, but ends their paragraph.
    void take_rule(std::string_view line) {
        constexpr std::size_t kLongest = 12;  // letters: a line of braille need not be full of it
        if (lines_ == 1 && !begins_anew(blocks_.back().text))
            blocks_.back().kind = TextBlock::Kind::heading;
        else
            add(TextBlock::Kind::paragraph, line.substr(0, kLongest));
        lines_ = 0;
    }

    void add(TextBlock::Kind kind, std::string_view text) {
        blocks_.push_back({kind, std::string(text)});
        lines_ = 0;
        after_row_ = false;
    }

    std::vector<TextBlock> blocks_;
    std::size_t lines_ = 0;  // of the paragraph that may go on
    bool after_row_ = false, has_rows_ = false;
};

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
                 pdf ? phrase("this PDF has over 4 MB of text or 20,000 pages; lay out a part of it with {0}", spelled("page"))
                     : phrase("this text has over 4 MB; cut it into parts"));
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
void tell_left_out(const Source& source, const std::vector<PdfText>& texts, const PageRange& pages, std::vector<Phrase>& notes) {
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
    if (!without_words.empty())
        notes.push_back(phrases(without_words.size(),
                                "page {1} has no words and is left out; it may be a scan, have it read first: ocrmypdf",
                                "pages {1} have no words and are left out; they may be scans, have them read first: ocrmypdf",
                                list_of(without_words)));
    if (!with_drawings.empty())
        notes.push_back(phrases(with_drawings.size(), "page {1} has drawings or pictures besides its words, which are left out",
                                "pages {1} have drawings or pictures besides their words, which are left out",
                                list_of(with_drawings)));
    if (!not_looked_at.empty())
        notes.push_back(phrases(
            not_looked_at.size(), "page {1} takes too much to be looked at for drawings and scans, which are left out",
            "pages {1} take too much to be looked at for drawings and scans, which are left out", list_of(not_looked_at)));
}

Written written_in_pdf(const Source& source, PageRange pages) {
    const int count = pages_of_pdf(source);
    if (pages.last > count)
        throw Error(Fault::usage, source.name,
                    phrase("there is no page {0}, but pages 1 to {1}", std::to_string(pages.last), std::to_string(count)));
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
            one ? phrase("{0} word that was parted at the end of a line is put together without its hyphen: {1}",
                         std::to_string(parted.guesses()), named)
                : phrase("{0} words that were parted at the ends of lines are put together without their hyphens, as {1}",
                         std::to_string(parted.guesses()), named));
    }
    return written;
}

// What is in a file that is no text, and what may be done.
Phrase no_text(std::string_view bytes) {
    constexpr std::size_t kHead = 64;  // that readers look at
    const auto known = [&](const Reader* reader) {
        return reader->recognises({reinterpret_cast<const unsigned char*>(bytes.data()), std::min(bytes.size(), kHead)});
    };
    if (std::any_of(readers().begin(), readers().end(), known))
        return phrase("it is a picture, no text; leave out {0}", spelled("text"));
    if (bytes.starts_with("PK\3\4"))
        return phrase("it is an Office file, an e-book or an archive; save it as text or as PDF first");
    return phrase("it is no text in UTF-8; save it as UTF-8, or convert it: iconv -f latin1 -t utf-8");
}

// Markup would be set with all its signs.
void check_markup(std::string_view text, const std::string& name) {
    constexpr std::size_t kHead = 4096;
    const auto begin = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (begin == std::string_view::npos || text[begin] != '<') return;
    std::string head(text.substr(begin, kHead));
    for (char& c : head) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
    if (head.find("<html") != std::string::npos || head.find("<!doctype html") != std::string::npos)
        throw Error(Fault::failed, name, phrase("it is an HTML page; save it as text or as PDF first"));
    if (head.find("<svg") != std::string::npos || head.find(":svg ") != std::string::npos)
        throw Error(Fault::failed, name, phrase("it is a figure in SVG, no text; leave out {0}", spelled("text")));
}

std::string text_of_file(const Source& source) {
    std::string text = bytes_of(source.file.get());
    for (std::string_view rest = text; !rest.empty();)
        if (const char32_t letter = take_letter(rest); letter == kNoLetter || letter == 0)
            throw Error(Fault::failed, source.name, no_text(text));
    if (text.size() > kMostTextBytes) throw too_much(source, false);
    check_markup(text, source.name);
    return text;
}

}  // namespace

Written written_in_text(std::string_view text) {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
    TextFile file;
    while (!text.empty()) file.take(take_line(text));
    return file.written();
}

bool is_text(const PdfText& text, std::size_t drawn) {
    const std::size_t words = text.count();
    if (words == 0) return false;
    if (drawn == 0) return true;
    // Where as much is drawn as written, a long line that stands by itself may be the name of something.
    const std::size_t least_lines = drawn >= words ? 2 : 1;
    std::size_t in_lines = 0;
    for (const PdfBlock& block : text.blocks)
        for (const PdfLine& line : block.lines)
            if (line.words.size() >= kLongLine && block.lines.size() >= least_lines) in_lines += line.words.size();
    return words >= kFewWords && static_cast<double>(in_lines) >= kMostInLines * static_cast<double>(words);
}

bool is_page_of_text(const Source& pdf, int page) {
    const PdfText text = pdf_text(pdf, page);
    const auto svg = pdf_page_as_svg(pdf, page, text);
    return is_text(text, svg ? drawn_in(*svg) : 1);
}

Written text_in(Source& source, PageRange pages) {
    const bool pdf = look_at(source) == Holds::pdf;
    if (!pdf && pages.first > 0) throw Error(Fault::usage, spelled("page"), phrase("{0} is no PDF; leave it out", source.name));
    Written written = pdf ? written_in_pdf(source, pages) : written_in_text(text_of_file(source));
    std::erase_if(written.blocks, [](const TextBlock& block) { return to_line(block.text).empty(); });
    if (written.blocks.empty())
        throw Error(
            Fault::failed, source.name,
            pdf ? phrase("nothing is written in it that could be laid out as text; if it is a scan, have it read first: ocrmypdf")
                : phrase("nothing is written in it that could be laid out as text"));
    return written;
}

}  // namespace tactics
