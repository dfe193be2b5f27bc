// SPDX-License-Identifier: Apache-2.0
#include "tactics/text/table.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tactics/text/utf8.h"

namespace tactics {

namespace {

std::string padded(const std::string& text, std::size_t width, bool left) {
    const std::size_t letters = letters_in(text);
    const std::string blanks(width > letters ? width - letters : 0, ' ');
    return left ? text + blanks : blanks + text;
}

std::string field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

}  // namespace

std::string fixed(double value, int digits) {
    long long scale = 1;
    for (int i = 0; i < digits; ++i) scale *= 10;
    const long long number = std::llround(value * static_cast<double>(scale));
    const long long size = std::abs(number);
    std::string text = (number < 0 ? "-" : "") + std::to_string(size / scale);
    if (digits == 0) return text;
    std::string rest = std::to_string(size % scale);
    return text + "." + std::string(static_cast<std::size_t>(digits) - rest.size(), '0') + rest;
}

std::string percent(double share) { return fixed(100 * share, 0) + " %"; }

std::string exact_percent(double share) {
    if (share > 0 && share < 0.001) return "< 0.1 %";
    if (share < 1 && share > 0.999) return "> 99.9 %";
    return fixed(100 * share, 1) + " %";
}

std::string aligned(std::vector<Row> rows) {
    std::string text;
    for (Row& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (row[i].empty() && i + 1 < row.size()) row[i] = "-";
            std::size_t width = 0;
            for (const Row& other : rows) width = std::max(width, std::max<std::size_t>(letters_in(other[i]), 1));
            const bool left = i == 0 || i + 1 == row.size();
            line += (i > 0 ? "  " : "") + padded(row[i], width, left);
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::string comma_separated(const std::vector<Row>& rows) {
    std::string text;
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) text += (i > 0 ? "," : "") + field(row[i]);
        text += "\r\n";
    }
    return text;
}

}  // namespace tactics
