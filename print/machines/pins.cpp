// SPDX-License-Identifier: Apache-2.0
// Displays of pins, from what their protocols say. A sheet is what the pins show before they are set anew.
#include <array>

#include "print/machines/machines.h"
#include "print/machines/sheet_feed.h"

namespace tactics {

namespace {

int number(std::string_view bytes, std::size_t at) { return static_cast<unsigned char>(bytes[at]); }

class DotPad {
public:
    DotPad(std::string_view bytes, const Settings& settings)
        : bytes_(bytes), first_(settings.whole("first")), text_(settings.whole("text")), pitch_(settings.number("pitch")) {}

    Punched run() {
        std::size_t at = 0;
        while (at < bytes_.size()) {
            const std::size_t end = packet_end(at);
            if (end == 0) {
                feed_.note(at, phrase("no packet begins here"));
                at = std::min(bytes_.find("\xAA\x55", at + 1), bytes_.size());
                continue;
            }
            feed_.at(at);
            take(at, end);
            at = end;
        }
        return feed_.finish(bytes_.size());
    }

private:
    // 0: there is none.
    std::size_t packet_end(std::size_t at) const {
        if (bytes_.size() - at < 9 || bytes_.substr(at, 2) != "\xAA\x55") return 0;
        const auto count = static_cast<std::size_t>(256 * number(bytes_, at + 2) + number(bytes_, at + 3));
        return count < 5 || count > bytes_.size() - at - 4 ? 0 : at + 4 + count;
    }

    void take(std::size_t at, std::size_t end) {
        int sum = 0xA5;
        for (std::size_t i = at + 4; i + 1 < end; ++i) sum ^= number(bytes_, i);
        if (sum != number(bytes_, end - 1)) return feed_.note(at, phrase("a packet whose checksum is wrong"));
        const int row = number(bytes_, at + 4), command = 256 * number(bytes_, at + 5) + number(bytes_, at + 6);
        if (command == 0x0000 || command == 0x0100 || command == 0x0110) return;  // questions
        if (command != 0x0200 || end - at < 10) return feed_.note(at, phrase("a command that is not known"));
        const std::string_view cells = bytes_.substr(at + 9, end - 1 - (at + 9));
        // A row that was set already: the picture before it is felt no more.
        if (set_[static_cast<std::size_t>(row)]) {
            feed_.form_feed(at);
            set_ = {};
            feed_.at(at);
        }
        feed_.begin();
        set_[static_cast<std::size_t>(row)] = true;
        if (text_ > 0 && row == 0) {
            std::vector<std::uint8_t> line;
            for (std::size_t i = 0; i < cells.size(); ++i) {
                std::uint8_t cell = 0;
                for (int bit = 0; bit < 8; ++bit)
                    if ((number(cells, i) >> bit & 1) != 0) cell |= kCellBit[static_cast<std::size_t>(bit)];
                line.push_back(cell);
            }
            return feed_.set_apart(std::move(line));
        }
        for (std::size_t i = 0; i < cells.size(); ++i)
            for (int bit = 0; bit < 8; ++bit)
                if ((number(cells, i) >> bit & 1) != 0)
                    feed_.set_dot(
                        {(2 * static_cast<double>(i) + bit / 4 + 0.5) * pitch_, (4 * (row - first_) + bit % 4 + 0.5) * pitch_});
    }

    // Down the left side of a cell, then down the right: dots 1 2 3 7, 4 5 6 8.
    static constexpr std::array<std::uint8_t, 8> kCellBit{0x01, 0x02, 0x04, 0x40, 0x08, 0x10, 0x20, 0x80};

    std::string_view bytes_;
    int first_, text_;
    double pitch_;
    SheetFeed feed_{CellHead{}};
    std::array<bool, 256> set_{};
};

// The bytes of a message without its doubled ESC. One that is not doubled begins the next message, which then is where this one
// ends.
struct Unescaped {
    std::string bytes;
    std::size_t end = 0;
    int sum = 0;  // of all that was sent, the checksum included
    bool whole = false;
};

Unescaped unescaped(std::string_view sent, std::size_t from, std::size_t count) {
    Unescaped out{{}, from};
    while (out.bytes.size() < count) {
        if (out.end == sent.size()) return out;
        const int byte = number(sent, out.end);
        if (byte == 0x1B) {
            if (out.end + 1 == sent.size() || number(sent, out.end + 1) != 0x1B) return out;
            ++out.end;
            if (out.bytes.size() + 1 < count) out.sum += byte;  // the checksum itself counts once
        }
        ++out.end;
        out.sum += byte;
        out.bytes += static_cast<char>(byte);
    }
    out.whole = true;
    return out;
}

}  // namespace

Punched punch_dot_pad(std::string_view bytes, const Settings& settings) { return DotPad(bytes, settings).run(); }

Punched punch_graphiti(std::string_view bytes, const Settings& settings) {
    constexpr int kAcross = 60, kDown = 40;
    SheetFeed feed{CellHead{}};
    const double pitch = settings.number("pitch");
    bool shown = false;
    for (std::size_t at = 0; at < bytes.size();) {
        if (number(bytes, at) != 0x1B || at + 1 >= bytes.size() || number(bytes, at + 1) != 0x15) {
            feed.note(at, phrase("no picture of pins begins here"));
            at = std::min(bytes.find('\x1B', at + 1), bytes.size());
            continue;
        }
        // Whatever it is, no byte of it is read again.
        const Unescaped message = unescaped(bytes, at + 1, 1 + 2 * kAcross * kDown + 1);
        if (!message.whole || message.sum % 256 != 0) {
            feed.note(
                at, message.whole ? phrase("a picture whose checksum is wrong") : phrase("a picture of pins that is cut short"));
            at = message.end;
            continue;
        }
        if (shown) feed.form_feed(at);
        shown = true;
        feed.at(at);
        feed.begin();
        for (int pin = 0; pin < kAcross * kDown; ++pin)
            if (const int height = number(message.bytes, 1 + 2 * static_cast<std::size_t>(pin)); height > 0) {
                if (height > 4) feed.note(at, phrase("a height over 4"));
                feed.set_dot({(pin % kAcross + 0.5) * pitch, (pin / kAcross + 0.5) * pitch}, std::min(height, 4) / 4.0);
            }
        at = message.end;
    }
    return feed.finish(bytes.size());
}

}  // namespace tactics
