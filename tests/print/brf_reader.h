// SPDX-License-Identifier: Apache-2.0
// Reads BRF as an embosser does: letters to dots on paper. Written from the definition of the code, apart from the writer.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tactics::test {

struct BrfDot {
    double x = 0;  ///< mm from dot 1 of the first cell
    double y = 0;
};

struct BrfPage {
    std::vector<std::string> lines;  ///< without their ends
    std::vector<BrfDot> dots;
};

/// The dots of a letter as digits, "" for the blank. Throws std::runtime_error for what is not in the code.
inline std::string dots_of_letter(char letter) {
    static const std::map<char, std::string> kCode = [] {
        std::map<char, std::string> code{{' ', ""}};
        // The ten letters of the first decade; the next two decades add dot 3, then dots 3 and 6; w stands apart.
        const std::string first[] = {"1", "12", "14", "145", "15", "124", "1245", "125", "24", "245"};
        const std::string second = "KLMNOPQRST", third = "UVXYZ&=(!)";
        const std::string low[] = {"2", "23", "25", "256", "26", "235", "2356", "236", "35", "356"};
        for (std::size_t i = 0; i < 10; ++i) {
            code[static_cast<char>('A' + i)] = first[i];
            code[second[i]] = first[i] + "3";
            code[third[i]] = first[i] + "36";
            code["1234567890"[i]] = low[i];           // digits: the first decade one row down
            code["*<%?:$]\\[W"[i]] = first[i] + "6";  // the decade with dot 6
        }
        const std::pair<char, std::string> rest[] = {{'/', "34"}, {'+', "346"}, {'#', "3456"}, {'>', "345"}, {'\'', "3"},
                                                     {'-', "36"}, {'@', "4"},   {'^', "45"},   {'_', "456"}, {'"', "5"},
                                                     {'.', "46"}, {';', "56"},  {',', "6"}};
        for (const auto& [sign, dots] : rest) code[sign] = dots;
        return code;
    }();
    const auto found = kCode.find(letter);
    if (found == kCode.end()) throw std::runtime_error("not a letter of braille ASCII: " + std::to_string(letter));
    return found->second;
}

/// All pages of a file. Throws std::runtime_error where an embosser would stumble.
inline std::vector<BrfPage> read_brf(std::string_view text) {
    std::vector<BrfPage> pages;
    BrfPage page;
    std::string line;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\f') {
            if (!line.empty()) throw std::runtime_error("a page ends within a line");
            pages.push_back(page);
            page = {};
        } else if (text[i] == '\r') {
            if (i + 1 == text.size() || text[i + 1] != '\n') throw std::runtime_error("CR without LF");
            ++i;
            const double y = 10.0 * static_cast<double>(page.lines.size());
            for (std::size_t column = 0; column < line.size(); ++column)
                for (const char dot : dots_of_letter(line[column])) {
                    const int number = dot - '0';
                    page.dots.push_back(
                        {6.0 * static_cast<double>(column) + (number > 3 ? 2.5 : 0.0), y + 2.5 * ((number - 1) % 3)});
                }
            page.lines.push_back(line);
            line.clear();
        } else {
            line += text[i];
        }
    }
    if (!line.empty() || !page.lines.empty()) throw std::runtime_error("the last page does not end with a form feed");
    return pages;
}

}  // namespace tactics::test
