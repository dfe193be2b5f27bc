// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/csv.h"

#include <algorithm>
#include <cstring>

#include "tactics/error.h"
#include "tactics/readers/cell.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr std::size_t kCsvChunk = 256 * 1024;   // bytes that are read at a time
constexpr std::size_t kSampledRecords = 100;    // used to find the separator
constexpr std::size_t kSampledBytes = 1 << 20;  // at most

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view without_blanks(std::string_view cell) {
    while (!cell.empty() && is_blank(cell.front())) cell.remove_prefix(1);
    while (!cell.empty() && is_blank(cell.back())) cell.remove_suffix(1);
    return cell;
}

template <class Take>
void split_by(std::string_view line, char separator, Take take) {
    if (separator == kBlankSeparator) {
        for (std::size_t at = 0; at < line.size();) {
            while (at < line.size() && is_blank(line[at])) ++at;
            const std::size_t begin = at;
            while (at < line.size() && !is_blank(line[at])) ++at;
            if (at > begin) take(line.substr(begin, at - begin));
        }
        return;
    }
    for (;;) {
        const auto end = line.find(separator);
        take(without_blanks(line.substr(0, end)));
        if (end == std::string_view::npos) return;
        line.remove_prefix(end + 1);
    }
}

// By the first line alone: a comma between digits is one within a number where tabs or semicolons part the values.
char separator_in(std::string_view header) {
    bool decimal = true;
    for (std::size_t at = header.find(','); at != std::string::npos; at = header.find(',', at + 1))
        decimal &= at > 0 && at + 1 < header.size() && is_digit(header[at - 1]) && is_digit(header[at + 1]);
    if (decimal)
        for (const char separator : {'\t', ';'})
            if (header.find(separator) != std::string::npos) return separator;
    for (const char separator : {',', '\t', ';'})
        if (header.find(separator) != std::string::npos) return separator;
    return ',';
}

// The share of numbers in the beginning, or less than nothing if its records are not equally long.
double numbers_by(const Source& source, char separator, std::string& first_line) {
    CsvRecords records(source, separator);
    std::size_t columns = 0, first = 0, cells = 0, numbers = 0, count = 0;
    try {
        for (; count < kSampledRecords && records.bytes() < kSampledBytes && records.next(); ++count) {
            const std::size_t here = records.cells().size();
            if (count == 0) {
                first = columns = here;
                for (const auto cell : records.cells()) first_line.append(cell).append(1, separator);
                first_line.pop_back();
            }
            if (count == 1) columns = here;
            if (here != columns) return -1;
            for (const auto cell : records.cells())
                if (is_number(cell)) ++numbers;
            cells += here;
        }
    } catch (const Error&) {
        return -1;
    }
    const bool nameless = leaves_out_row_names(separator) && first + 1 == columns;
    if (columns < 2 || (first != columns && !nameless)) return -1;
    return static_cast<double>(numbers) / static_cast<double>(cells);
}

}  // namespace

CsvRecords::CsvRecords(const Source& source, char separator) : source_(source), separator_(separator) {
    buffer_.resize(kCsvChunk);
    if (source_.file == nullptr) return;
    std::rewind(source_.file.get());
    fill();
    const std::string_view head(buffer_.data(), end_);
    if (head.starts_with("\xFF\xFE") || head.starts_with("\xFE\xFF"))
        throw Error(Fault::failed, source_.name,
                    phrase("it is text in UTF-16; save it as UTF-8, for example: iconv -f UTF-16 -t UTF-8 FILE > NEW.csv"));
    if (head.starts_with("\xEF\xBB\xBF")) at_ = 3;
}

void CsvRecords::fail(const Phrase& message) const {
    throw Error(Fault::failed, source_.name + ":" + std::to_string(number_), message);
}

// Keeps what is not taken yet; whether there is more.
bool CsvRecords::fill() {
    if (source_.file == nullptr) return false;
    if (at_ > 0) std::memmove(buffer_.data(), buffer_.data() + at_, end_ - at_);
    end_ -= at_;
    at_ = 0;
    if (end_ > kLongestCsvRecord) {
        ++number_;
        fail(phrase("the line is longer than {0} bytes; is this a table?", std::to_string(kLongestCsvRecord)));
    }
    if (buffer_.size() < end_ + kCsvChunk) buffer_.resize(end_ + kCsvChunk);
    const std::size_t count = std::fread(buffer_.data() + end_, 1, kCsvChunk, source_.file.get());
    if (std::ferror(source_.file.get()) != 0) throw Error(Fault::failed, source_.name, phrase("it cannot be read"));
    end_ += count;
    return count > 0;
}

bool CsvRecords::next_line(std::string_view& line) {
    std::size_t searched = at_;
    for (;;) {
        const void* found = searched < end_ ? std::memchr(buffer_.data() + searched, '\n', end_ - searched) : nullptr;
        std::size_t end = end_, after = end_;
        if (found != nullptr) {
            end = static_cast<std::size_t>(static_cast<const char*>(found) - buffer_.data());
            after = end + 1;
        } else {
            searched = end_ - at_;
            if (fill()) continue;
            if (at_ == end_) return false;
            end = after = end_;
        }
        ended_ = found != nullptr;
        line = std::string_view(buffer_).substr(at_, end - at_);
        bytes_ += after - at_;
        at_ = after;
        ++number_;
        return true;
    }
}

bool CsvRecords::next() {
    std::string_view line;
    for (apart_ = false;;) {
        if (!next_line(line)) return false;
        const auto begin = std::find_if_not(line.begin(), line.end(), is_blank);
        if (begin == line.end()) {
            apart_ = begun_ && separator_ == kBlankSeparator;
            continue;
        }
        if (*begin != '#' || (begun_ && separator_ != kBlankSeparator)) break;
        if (!begun_) comment_ = std::string(begin + 1, line.end());
    }
    begun_ = true;
    line_ = number_;
    cells_.clear();
    if (line.find('"') == std::string_view::npos)
        split(line);
    else
        split_quoted(line);
    return true;
}

void CsvRecords::add_cell(std::string_view cell) {
    if (cells_.size() == kMostTableColumns)
        fail(phrase("there are more than {0} columns; keep those that are to be shown", std::to_string(kMostTableColumns)));
    cells_.push_back(cell);
}

void CsvRecords::split(std::string_view line) {
    split_by(line, separator_, [&](std::string_view cell) { add_cell(cell); });
}

void CsvRecords::split_quoted(std::string_view line) {
    enum class In { cell, quotes, behind } in = In::cell;
    const bool blanks = separator_ == kBlankSeparator;
    std::vector<std::size_t> ends;  // of cells in unquoted_
    std::size_t begin = 0;
    bool quoted = false;
    unquoted_.clear();
    const auto end_cell = [&] {
        if (ends.size() == kMostTableColumns) add_cell({});  // which says that it is one too many
        if (!blanks || quoted || unquoted_.size() > begin) ends.push_back(unquoted_.size());
        begin = unquoted_.size();
        quoted = false;
        in = In::cell;
    };
    for (;;) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            const char c = line[i];
            if (in == In::quotes) {
                if (c != '"')
                    unquoted_ += c;
                else if (i + 1 < line.size() && line[i + 1] == '"')
                    unquoted_ += line[++i];
                else
                    in = In::behind;
            } else if (blanks ? is_blank(c) : c == separator_) {
                end_cell();
            } else if (c == '"' && in == In::cell && without_blanks(std::string_view(unquoted_).substr(begin)).empty()) {
                unquoted_.resize(begin);
                in = In::quotes;
                quoted = true;
            } else if (in == In::cell) {
                unquoted_ += c;
            } else if (!is_blank(c)) {
                fail(phrase(
                    "something stands between a closing quote and the next value; write a quote within a value twice: \"\""));
            }
        }
        if (in != In::quotes) break;
        unquoted_ += '\n';
        const std::size_t opened = line_;
        if (unquoted_.size() > kLongestCsvRecord || !next_line(line)) {
            number_ = opened;
            fail(phrase("a quote is not closed; close it, and write a quote within a value twice: \"\""));
        }
    }
    end_cell();
    begin = 0;
    for (const std::size_t end : ends) {
        add_cell(without_blanks(std::string_view(unquoted_).substr(begin, end - begin)));
        begin = end;
    }
}

bool leaves_out_row_names(char separator) { return separator == kBlankSeparator || separator == '\t'; }

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
    std::vector<std::string_view> cells;
    split_by(line, separator, [&](std::string_view cell) { cells.push_back(cell); });
    return cells;
}

char separator_of(const Source& source) {
    char best = '\0';
    double most = -1;
    std::string first;
    for (const char separator : {'\t', ';', ',', kBlankSeparator}) {
        std::string line;
        const double numbers = numbers_by(source, separator, line);
        if (separator == '\t') first = std::move(line);
        if (numbers > most) {
            most = numbers;
            best = separator;
        }
    }
    return best == '\0' ? separator_in(first) : best;
}

}  // namespace tactics
