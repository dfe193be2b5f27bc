// SPDX-License-Identifier: Apache-2.0
// The objects of a PDF file and the cross-reference table (ISO 32000-1, 7.3 and 7.5).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tactics {

/// Objects are numbered from 1 in the order of adding.
class PdfFile {
public:
    int add(const std::string& body);
    int add_stream(const std::string& entries, const std::string& data);
    int add_deflated(const std::string& text);
    /// The page's SVG and what names it (tactics/readers/own_pdf.h); the number of the latter is for the page's /AF.
    int add_own_page(const std::string& svg);
    int next() const { return static_cast<int>(offsets_.size()) + 1; }
    /// The whole file; call it once.
    std::string finish(int root, int info);

    static std::string reference(int number) { return std::to_string(number) + " 0 R"; }

private:
    std::string bytes_ = "%PDF-1.6\n%\xE2\xE3\xCF\xD3\n";  // the second line tells mailers that the file is binary
    std::vector<std::size_t> offsets_;
};

void append_hex(std::string& text, unsigned value, int digits);
void append_utf16(std::string& text, char32_t letter);
/// UTF-8 as a hexadecimal UTF-16 string, which needs no escapes.
std::string text_string(std::string_view text);

}  // namespace tactics
