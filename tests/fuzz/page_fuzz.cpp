// SPDX-License-Identifier: Apache-2.0
// A drawing with words, as bytes say it, on a sheet, as bytes of one format, read back: the whole way of a page.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "print/embosser.h"
#include "print/format.h"
#include "tactics/error.h"
#include "tactics/layout/lay_out.h"
#include "tactics/layout/place.h"
#include "tactics/layout/texture.h"
#include "tactics/readers/read.h"
#include "tactics/readers/svg/svg.h"
#include "tactics/text/utf8.h"
#include "tactics/units.h"

namespace {

using namespace tactics;

void require(bool holds) {
    if (!holds) std::abort();
}

class Bytes {
public:
    explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
    bool empty() const { return at_ >= bytes_.size(); }
    std::uint8_t next() { return empty() ? std::uint8_t{0} : bytes_[at_++]; }
    std::string word() {
        std::string text;
        while (!empty() && text.size() < 40)
            if (const auto c = static_cast<char>(next()); c == '\0')
                break;
            else
                text += c;
        return text;
    }

private:
    std::span<const std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

constexpr std::size_t kMostThings = 60, kMostNames = 4;

// A letter says what comes; places are bytes on a drawing of 256 x 256 mm.
Drawing drawing_from(Bytes& bytes, Sheet& sheet) {
    Drawing drawing;
    drawing.width = drawing.height = 256;
    const auto points = [&] {
        std::vector<Point> line(bytes.next() % 12u);
        for (Point& p : line) p = {static_cast<double>(bytes.next()), static_cast<double>(bytes.next())};
        return line;
    };
    for (std::size_t things = 0; !bytes.empty() && things < kMostThings; ++things) {
        const std::uint8_t kind = bytes.next();
        if (kind == 'n' && drawing.names.size() < kMostNames) {
            const Point at{static_cast<double>(bytes.next()), static_cast<double>(bytes.next())};
            drawing.names.push_back({at, bytes.word(), "name", 0, bytes.next() % 2 == 0});
        } else if (kind == 't') {
            sheet.title = to_line(bytes.word());
        } else if (std::vector<Point> line = points(); line.size() > 2 && kind == 'a') {
            Area& area = drawing.areas.emplace_back();
            area.rings = {std::move(line)};
            area.texture = static_cast<int>(bytes.next() % (textures().size() + 1));
        } else if (line.size() > 1) {
            drawing.strokes.push_back({std::move(line), kind % 2 == 1});
            if (drawing.strokes.back().points.size() < 3) drawing.strokes.back().closed = false;
        }
    }
    return drawing;
}

void read_back(const Format& format, const std::string& bytes, const Page& page, const Settings& settings) {
    require(!bytes.empty());
    if (format.embosser != nullptr) {
        const Punched punched = format.embosser->punch(bytes, settings);
        require(punched.notes.empty());
    } else if (format.name == "svg") {
        const FoundPage found = read_svg(bytes, "page.svg", 0, std::nullopt);
        require(std::abs(found.page.width - page.width) < 0.01 && std::abs(found.page.height - page.height) < 0.01);
        require(found.page.areas.size() <= page.areas.size());  // one without an inside is none
    } else if (format.name == "png" || format.name == "tiff") {
        Source source = memory_source({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, "page");
        const Image picture = read_picture(source, {});
        require(picture.width > 0 && picture.height > 0);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 3) return 0;
    Bytes bytes({data, size});
    const auto all = formats();
    const Format& format = *all[bytes.next() % all.size()];
    const std::uint8_t way = bytes.next();
    Settings settings(format.options);
    for (const Option& option : format.options)
        if (option.name == "dpi")
            settings.set("dpi", "40", "dpi", format.name);
        else if (option.name == "pitch" && option.unit == "mm" && format.embosser == nullptr)
            settings.set("pitch", "0.5mm", "pitch", format.name);
    try {
        Sheet sheet;
        sheet.paper = format.embosser == nullptr ? Paper{"small", "", 120, 90} : find_paper(format.paper, "paper");
        sheet.medium = &find_medium(format.medium, "medium");
        sheet.duplex = (way & 1) != 0;
        if ((way & 2) != 0) sheet.tiles = {1 + (way >> 6), 1 + (way >> 5 & 1)};
        if ((way & 4) != 0) sheet.binding = Binding{Binding::Edge::left, 15};
        if ((way & 8) != 0) sheet.braille_table.clear();
        if ((way & 16) != 0) sheet.orientation = Orientation::landscape;
        fit_to_machine(sheet, format, settings);
        const Drawing drawing = drawing_from(bytes, sheet);
        const Pages pages = pages_of(drawing, sheet);
        const std::vector<std::string> files = files_of(format, pages.all, settings);
        // What holds one page has a file for each that is not empty; fronts may be blank, or hold the key.
        const auto first = std::find_if_not(pages.all.begin(), pages.all.end(), is_blank);
        if (!files.empty()) read_back(format, files.front(), first != pages.all.end() ? *first : pages.all.front(), settings);
    } catch (const Error& error) {
        require(error.what()[0] != '\0');
    }
    return 0;
}
