// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/own_pdf.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "tactics/coding/bytes.h"

namespace tactics {

namespace {

constexpr std::string_view kHead = "%PDF-1.6\n", kEnd = "\n%%EOF\n", kTrailer = "trailer\n<<", kId = " /ID [<";
constexpr std::string_view kName = "54414354494353";  // TACTICS
constexpr std::size_t kIdDigits = 32;

void append_hex_digits(std::string& text, std::uint64_t number, int digits) {
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) text += "0123456789ABCDEF"[number >> shift & 15];
}

// The number that stands at the beginning, which is taken off.
std::optional<std::size_t> take_number(std::string_view& text) {
    std::size_t number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc()) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

std::optional<std::size_t> number_behind(std::string_view text, std::string_view word) {
    const auto at = text.find(word);
    if (at == std::string_view::npos) return std::nullopt;
    text.remove_prefix(at + word.size());
    return take_number(text);
}

// From the trailer on, which is short.
std::string_view tail_of(std::string_view pdf) {
    if (!pdf.ends_with(kEnd)) return {};
    const std::size_t from = pdf.size() - std::min(pdf.size(), kOwnPdfEnd);
    const auto at = pdf.rfind(kTrailer);
    return at == std::string_view::npos || at < from ? std::string_view() : pdf.substr(at);
}

// The stream of an object, if it is an SVG.
std::optional<std::string_view> page_in(std::string_view object) {
    constexpr std::string_view kObject = " 0 obj\n<< ", kStream = ">>\nstream\n";
    if (!take_number(object) || !object.starts_with(kObject)) return std::nullopt;
    object.remove_prefix(kObject.size());
    if (!object.starts_with(kOwnPageEntries)) return std::nullopt;
    const auto begin = object.find(kStream);
    if (begin == std::string_view::npos) return std::nullopt;
    const auto length = number_behind(object.substr(0, begin), "/Length ");
    if (!length || object.size() - begin - kStream.size() < *length) return std::nullopt;
    return object.substr(begin + kStream.size(), *length);
}

}  // namespace

bool may_be_own_pdf(std::string_view end) {
    const std::string_view tail = tail_of(end);
    const auto at = tail.find(kId);
    return at != std::string_view::npos && tail.substr(at + kId.size()).starts_with(kName);
}

std::string own_pdf_id(std::string_view before_table) {
    std::string id(kName);
    append_hex_digits(id, crc32_of(before_table), 8);
    append_hex_digits(id, before_table.size(), static_cast<int>(kIdDigits - id.size()));
    return id;
}

std::optional<std::vector<std::string_view>> own_pdf_pages(std::string_view pdf) {
    constexpr std::string_view kTable = "xref\n0 ", kStart = "startxref\n";
    constexpr std::size_t kEntry = 20;  // ISO 32000-1, 7.5.4
    const std::string_view tail = tail_of(pdf);
    if (!pdf.starts_with(kHead) || !may_be_own_pdf(tail)) return std::nullopt;
    std::string_view end = tail.substr(std::min(tail.size(), tail.find(kStart)));
    end.remove_prefix(std::min(end.size(), kStart.size()));
    const auto start = take_number(end);
    if (!start || end != kEnd || *start >= pdf.size() || !pdf.substr(*start).starts_with(kTable)) return std::nullopt;
    const std::string_view before = pdf.substr(0, *start);
    if (tail.substr(tail.find(kId) + kId.size(), kIdDigits) != own_pdf_id(before)) return std::nullopt;
    std::string_view table = pdf.substr(*start + kTable.size());
    const auto count = take_number(table);
    if (!count || !table.starts_with('\n')) return std::nullopt;
    table.remove_prefix(1);
    // Objects stand one behind the other in the order of the table, as we write them, so that each byte is looked at once.
    std::vector<std::size_t> offsets;
    for (std::size_t i = 1; i < *count && (i + 1) * kEntry <= table.size(); ++i) {
        std::string_view entry = table.substr(i * kEntry, kEntry);
        const auto offset = take_number(entry);
        if (!offset || *offset >= before.size() || (!offsets.empty() && *offset <= offsets.back())) return std::nullopt;
        offsets.push_back(*offset);
    }
    offsets.push_back(before.size());
    std::vector<std::string_view> pages;
    for (std::size_t i = 0; i + 1 < offsets.size(); ++i)
        if (const auto page = page_in(before.substr(offsets[i], offsets[i + 1] - offsets[i]))) pages.push_back(*page);
    return pages.empty() ? std::nullopt : std::optional(std::move(pages));
}

}  // namespace tactics
