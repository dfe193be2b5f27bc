// SPDX-License-Identifier: Apache-2.0
#include "print/machines/sheet_feed.h"

#include <array>

namespace tactics {

namespace {

constexpr std::size_t kMostNotes = 20;
// Per job: a thousand pages full of dots, far more than anybody looks at. Anything beyond is reported, not stored.
constexpr std::size_t kMostDots = 10'000'000, kMostSheets = 100'000;
constexpr std::size_t kMostLines = 10'000;  // of a sheet, and cells of a line

// The dots of each letter from 20h on, as braille is read aloud: American computer braille, BANA.
constexpr std::array<const char*, 64> kDots = {
    "",     "2346", "5",    "3456",   "1246", "146",   "12346", "3",    "12356", "23456", "16",    "346",  "6",
    "36",   "46",   "34",   "356",    "2",    "23",    "25",    "256",  "26",    "235",   "2356",  "236",  "35",
    "156",  "56",   "126",  "123456", "345",  "1456",  "4",     "1",    "12",    "14",    "145",   "15",   "124",
    "1245", "125",  "24",   "245",    "13",   "123",   "134",   "1345", "135",   "1234",  "12345", "1235", "234",
    "2345", "136",  "1236", "2456",   "1346", "13456", "1356",  "246",  "1256",  "12456", "45",    "456"};

}  // namespace

std::optional<std::uint8_t> cell_of_letter(unsigned char letter) {
    if (letter >= 0x60 && letter < 0x80) letter = static_cast<unsigned char>(letter - 0x20);
    if (letter < 0x20 || letter >= 0x60) return std::nullopt;
    std::uint8_t cell = 0;
    for (const char* dot = kDots[letter - 0x20u]; *dot != 0; ++dot) cell = static_cast<std::uint8_t>(cell | 1u << (*dot - '1'));
    return cell;
}

// What stands between two sheets belongs to the second.
void SheetFeed::begin() {
    if (began_) return;
    began_ = true;
    sheet_.begin = punched_.sheets.empty() ? 0 : punched_.sheets.back().end;
    sheet_.set_up_begin = set_up_begin_;
    sheet_.set_up_end = set_up_end_;
}

void SheetFeed::set_up(std::size_t end) {
    if (at_ != set_up_end_) set_up_begin_ = at_;
    set_up_end_ = end;
}

void SheetFeed::set_cell(std::uint8_t cell) {
    begin();
    if (column_ >= kMostLines || line_ >= kMostLines) return;
    if (sheet_.lines.size() <= line_) sheet_.lines.resize(line_ + 1);
    auto& line = sheet_.lines[line_];
    if (line.size() <= column_) line.resize(column_ + 1);
    line[column_] = static_cast<std::uint8_t>(line[column_] | cell);
    const double x = head_.first.x + static_cast<double>(column_) * head_.cell,
                 y = head_.first.y + static_cast<double>(line_) * head_.line;
    for (int dot = 1; dot <= 8; ++dot) {
        if ((cell >> (dot - 1) & 1) == 0) continue;
        const bool right = (dot >= 4 && dot <= 6) || dot == 8;
        const int down = dot >= 7 ? 3 : (dot - 1) % 3;
        set_dot({x + (right ? head_.dot : 0), y + down * head_.dot});
    }
    ++column_;
}

void SheetFeed::set_dot(Point at, double height) {
    begin();
    if (++dots_ > kMostDots) return;
    if (height < 1 && sheet_.heights.empty()) sheet_.heights.assign(sheet_.dots.size(), 1);
    sheet_.dots.push_back(at);
    if (!sheet_.heights.empty() || height < 1) sheet_.heights.push_back(height);
}

void SheetFeed::line_feed() {
    begin();
    ++line_;
    column_ = 0;
}

void SheetFeed::form_feed(std::size_t end) {
    begin();
    began_ = false;
    sheet_.end = end;
    sheet_.dots.shrink_to_fit();  // a job of noise has a hundred thousand sheets
    sheet_.lines.shrink_to_fit();
    if (punched_.sheets.size() < kMostSheets)
        punched_.sheets.push_back(std::move(sheet_));
    else
        punched_.sheets.back().end = end;
    sheet_ = {};
    column_ = line_ = 0;
}

void SheetFeed::end_job(std::size_t end) {
    if (!began_ && !punched_.sheets.empty()) punched_.sheets.back().end = end;
    punched_.job_end_begin = at_;
    punched_.job_end_end = end;
}

void SheetFeed::note(std::size_t byte, const Phrase& text) {
    if (++notes_ > kMostNotes) return;
    punched_.notes.push_back(phrase("byte {0}: {1}", std::to_string(byte), text));
}

Punched SheetFeed::finish(std::size_t end) {
    if (!sheet_.dots.empty() || punched_.sheets.empty()) form_feed(end);
    punched_.sheets.back().end = end;  // what ends the job goes with its last sheet
    if (dots_ > kMostDots) punched_.notes.push_back(phrase("there are over 10 million dots; those behind them are left out"));
    if (punched_.sheets.size() >= kMostSheets)
        punched_.notes.push_back(phrase("there are over 100000 sheets; those behind them are left out"));
    if (notes_ > kMostNotes) punched_.notes.push_back(phrase("and {0} more", std::to_string(notes_ - kMostNotes)));
    return std::move(punched_);
}

}  // namespace tactics
