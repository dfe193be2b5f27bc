// SPDX-License-Identifier: Apache-2.0
// Index Braille V3, V4 and V5: text, 4-dot graphics and floating dots, as their public drivers have them.
#include <charconv>
#include <cmath>
#include <string>

#include "print/machines/machines.h"
#include "print/machines/sheet_feed.h"
#include "tactics/units.h"

namespace tactics {

namespace {

class IndexMachine {
public:
    // `corner` is where the first dot of text and graphics stands; `pitch` that of graphics until a job sets another.
    IndexMachine(std::string_view bytes, Point corner, double pitch, Point counted_from)
        : bytes_(bytes), feed_(CellHead{corner, 2.5, 6, 10}), corner_(corner), pitch_(pitch), counted_from_(counted_from) {}

    Punched run() {
        while (at_ < bytes_.size()) step();
        if (graphics_) feed_.note(at_, phrase("graphics are not ended with ESC 06h"));
        return feed_.finish(bytes_.size());
    }

private:
    unsigned char next() { return static_cast<unsigned char>(bytes_[at_++]); }

    void step() {
        const std::size_t start = at_;
        feed_.at(start);
        const unsigned char c = next();
        if (c == 0x1b) return command(start);
        if (c == 0x1a) return feed_.end_job(at_);
        if (graphics_) return graphic(c, start);
        if (c == '\r') return feed_.carriage_return();
        if (c == '\n') return feed_.line_feed();
        if (c == '\f') {
            column_ = row_ = 0;
            return feed_.form_feed(at_);
        }
        if (const auto cell = cell_of_letter(c)) return feed_.set_cell(*cell);
        feed_.note(start, phrase("a byte that is no letter of braille"));
    }

    void graphic(unsigned char c, std::size_t start) {
        if (c >= '@' && c <= 'O') {
            const unsigned dots = c - '@';
            for (unsigned down = 0; down < 4; ++down)
                if ((dots >> down & 1u) != 0)
                    feed_.set_dot({corner_.x + static_cast<double>(column_) * pitch_,
                                   corner_.y + (static_cast<double>(row_) * 4 + down) * pitch_});
            ++column_;
        } else if (c == '\r') {
            column_ = 0;
        } else if (c == '\n') {
            ++row_;
            column_ = 0;
        } else if (c == '\f') {
            column_ = row_ = 0;
            // What ends the graphics goes with their page.
            const std::string_view rest = bytes_.substr(at_);
            feed_.form_feed(at_ + (rest.starts_with("\r\x1b\x06") ? 3 : rest.starts_with("\x1b\x06") ? 2 : 0));
        } else {
            feed_.note(start, phrase("a byte that is no column of graphics"));
        }
    }

    void command(std::size_t start) {
        if (at_ == bytes_.size()) return feed_.note(start, phrase("ESC without a command"));
        const unsigned char c = next();
        if (c == 0x07 || c == 'F') feed_.begin();
        if (c == 0x07)
            graphics_ = true;
        else if (c == 0x06)
            graphics_ = false;
        else if (c == 'D')
            set_up(start);
        else if (c == 'F')
            floating(start);
        else if (c == '\\')
            transparent(start);
        else
            feed_.note(start, phrase("an ESC command that is not known here"));
    }

    void set_up(std::size_t start) {
        const auto end = bytes_.find(';', at_);
        if (end == std::string_view::npos) {
            at_ = bytes_.size();
            return feed_.note(start, phrase("ESC D without its ;"));
        }
        std::string_view keys = bytes_.substr(at_, end - at_);
        at_ = end + 1;
        feed_.set_up(at_);
        while (!keys.empty()) {
            const auto comma = keys.find(',');
            const std::string_view key = keys.substr(0, comma);
            keys = comma == std::string_view::npos ? std::string_view() : keys.substr(comma + 1);
            if (key == "GD0")
                pitch_ = 2.0;
            else if (key == "GD1")
                pitch_ = 2.5;
            else if (key == "GD2")
                pitch_ = 1.6;
            else if (key == "TD0")
                feed_.head().dot = 2.5, feed_.head().cell = 6.0;
            else if (key == "TD1")
                feed_.head().dot = 2.2, feed_.head().cell = 5.3;
            else if (key == "TD2")
                feed_.head().dot = 3.2, feed_.head().cell = 8.45;
            else if (!is_known(key))
                feed_.note(start, phrase("ESC D has a key that is not known here: {0}", key.substr(0, 20)));
        }
    }

    // Those that move no dot: pages of both sides come one after the other as those of one.
    static bool is_known(std::string_view key) {
        for (const std::string_view known : {"TM0", "BI0", "FO0", "DP1", "DP2", "PN0", "IM0", "OM0", "BM0"})
            if (key == known) return true;
        for (const std::string_view with_number : {"MC", "MI", "BT", "LS", "CH", "LP", "PW", "PL"})
            if (key.starts_with(with_number) && key.size() > 2 &&
                key.find_first_not_of("0123456789", 2) == std::string_view::npos)
                return true;
        return false;
    }

    void floating(std::size_t start) {
        if (at_ >= bytes_.size() || next() != ';') return feed_.note(start, phrase("ESC F without its ;"));
        while (at_ < bytes_.size()) {
            const std::size_t place = at_;
            const auto end = bytes_.find_first_of("\n;", at_);
            if (end == std::string_view::npos) break;
            const std::string_view dot = bytes_.substr(at_, end - at_);
            at_ = end + 1;
            if (!dot.empty()) {
                const auto colon = dot.find(':');
                const auto x = parse_number(dot.substr(0, colon));
                const auto y = colon == std::string_view::npos ? std::nullopt : parse_number(dot.substr(colon + 1));
                constexpr double kFarthest = 5080;  // mm; no sheet is larger
                if (x && y && std::abs(*x) <= kFarthest && std::abs(*y) <= kFarthest)
                    feed_.set_dot({counted_from_.x + *x, counted_from_.y + *y});
                else
                    feed_.note(place, phrase("a floating dot is x:y, in mm"));
            }
            if (bytes_[end] == ';') return;
        }
        at_ = bytes_.size();
        feed_.note(start, phrase("an area of floating dots is not ended with ;"));
    }

    // n1 + 256 n2 cells, of dots 1 2 3 7 4 5 6 8 from the lowest bit.
    void transparent(std::size_t start) {
        if (bytes_.size() - at_ < 2) {
            at_ = bytes_.size();
            return feed_.note(start, phrase("ESC \\ without its count"));
        }
        const unsigned low = next(), high = next();
        if (low > 127 || high > 0) feed_.note(start, phrase("counts over 127 are misread by the machine"));
        for (unsigned i = 0; i < low + 256 * high && at_ < bytes_.size(); ++i) {
            const unsigned bits = next();
            const unsigned cell = (bits & 7u) | (bits >> 3 & 1u) << 6 | (bits >> 4 & 7u) << 3 | (bits >> 7 & 1u) << 7;
            feed_.set_cell(static_cast<std::uint8_t>(cell));
        }
    }

    std::string_view bytes_;
    std::size_t at_ = 0;
    SheetFeed feed_;
    Point corner_;
    double pitch_;
    Point counted_from_;
    bool graphics_ = false;
    std::size_t column_ = 0, row_ = 0;  // of graphics
};

double pitch_of(const Settings& settings) { return parse_number(settings.choice("pitch")).value_or(2.5); }

}  // namespace

// A dot is 1.6 mm wide, and the first touches the area that the machine can reach: all of the sheet but 2 mm at the top (V3), all
// but 5 mm around (V4).
Punched punch_index_v3(std::string_view bytes, const Settings& settings) {
    return IndexMachine(bytes, {0.8, 2.8}, pitch_of(settings), {}).run();
}
Punched punch_index_v4(std::string_view bytes, const Settings& settings) {
    return IndexMachine(bytes, {5.8, 5.8}, pitch_of(settings), {}).run();
}
Punched punch_index_floating(std::string_view bytes, const Settings& settings) {
    return IndexMachine(bytes, {5.8, 5.8}, 2.0, {settings.number("left"), settings.number("top")}).run();
}

}  // namespace tactics
