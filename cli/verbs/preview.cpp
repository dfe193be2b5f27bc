// SPDX-License-Identifier: Apache-2.0
// `tactics preview`: what comes out of an embosser that is sent a file.
#include <algorithm>
#include <cmath>

#include "cli/command.h"
#include "cli/embosser_flags.h"
#include "cli/outputs.h"
#include "cli/report/say.h"
#include "cli/report/user_language.h"
#include "print/embosser.h"
#include "print/format.h"
#include "tactics/error.h"
#include "tactics/job/disk.h"
#include "tactics/job/page_files.h"
#include "tactics/layout/sheet.h"
#include "tactics/readers/append_file.h"
#include "tactics/text/json.h"
#include "tactics/transport/file.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr Flag kPreviewFlags[] = {
    {"--embosser", "-e", "NAME", "the machine that the bytes are for, from tactics list embossers or tactics list displays",
     false, "embossers displays"},
    {"--output", "-o", "FILE",
     "write a picture of the sheets; the ending of FILE chooses the format: .png, .svg, .pdf. May be given several times", true,
     "files"},
    {"--unicode", "", "", "print the sheets as Unicode braille, for a braille display or an editor", false, ""},
    {"--paper", "-p", "PAPER", "the sheet in the machine; default: what convert uses for it", false, "papers"},
    {"--orientation", "", "auto|portrait|landscape", "how the sheet was fed; auto: turned if a dot lies off the upright sheet",
     false, "auto portrait landscape"},
    {"--set", "-s", "NAME.OPTION=VALUE",
     "a setting of the machine, as given to convert: index-v4.pitch=2.0. May be given several times", true, "settings"},
    {"--json", "", "", "one JSON object for each sheet: its dots in mm, and what the machine would not understand", false, ""},
};

struct PreviewExtent {
    double left = 0, right = 0, top = 0, bottom = 0;
};

PreviewExtent extent_of(const PunchedSheet& sheet) {
    const Point first = sheet.dots.front();
    PreviewExtent extent{first.x, first.x, first.y, first.y};
    for (const Point& dot : sheet.dots) {
        extent.left = std::min(extent.left, dot.x);
        extent.right = std::max(extent.right, dot.x);
        extent.top = std::min(extent.top, dot.y);
        extent.bottom = std::max(extent.bottom, dot.y);
    }
    return extent;
}

Phrase mm(double value) { return numeral(std::round(value * 10) / 10); }

Phrase preview_told(const PunchedSheet& sheet, std::size_t number, double width, double height) {
    if (sheet.dots.empty()) return phrase("sheet {0}: no dots", std::to_string(number));
    const PreviewExtent extent = extent_of(sheet);
    const Phrase line = phrases(sheet.dots.size(), "sheet {1}: {0} dot, from {2} to {3} mm across and from {4} to {5} mm down",
                                "sheet {1}: {0} dots, from {2} to {3} mm across and from {4} to {5} mm down",
                                std::to_string(number), mm(extent.left), mm(extent.right), mm(extent.top), mm(extent.bottom));
    if (extent.right > width || extent.bottom > height || extent.left < 0 || extent.top < 0)
        return phrase("{0}; some lie beside the sheet of {1} x {2} mm", line, mm(width), mm(height));
    return line;
}

std::string json_of_preview(const PunchedSheet& sheet, std::size_t number, double width, double height,
                            const std::vector<Phrase>& notes) {
    JsonAnswer json;
    json.add("sheet", static_cast<double>(number));
    json.add("width_mm", width);
    json.add("height_mm", height);
    std::vector<std::string> dots;
    for (std::size_t i = 0; i < sheet.dots.size(); ++i) {
        const double share = sheet.height_of(i);
        dots.push_back("[" + to_text(sheet.dots[i].x) + "," + to_text(sheet.dots[i].y) + (share < 1 ? "," + to_text(share) : "") +
                       "]");
    }
    json.add_raw("dots", json_array(dots));
    if (!sheet.apart.empty()) json.add("text_line", unicode_of(sheet.apart));
    json.add_raw("notes", json_text_array(notes));
    return json.text() + "\n";
}

struct Preview {
    const Format* format = nullptr;
    Settings settings;
    Sheet sheet;
    std::string way;  // up, of the paper
    std::vector<Item> items;
};

Preview plan_preview(const Given& given) {
    if (given.words.size() != 1)
        throw Error(Fault::usage, "preview", phrase("name one file of bytes for an embosser, or - for standard input"));
    const Format* named = machine_of(given, MachineKinds::with_displays);
    if (named == nullptr)
        throw Error(Fault::usage, "--embosser",
                    phrase("name the machine that the bytes are for; see tactics list embossers and tactics list displays"));
    const Format& format = *named;
    if (format.embosser->display != nullptr)
        for (const std::string_view flag : {"--paper", "--orientation"})
            if (given.has(flag))
                throw Error(
                    Fault::usage, flag,
                    phrase("{0} is a display, all of which is shown, so this would do nothing; leave it out", format.name));
    Preview preview{&format, embosser_settings(format, given), {}, given.value("--orientation", "auto"), {}};
    preview.sheet.paper = sheet_in(given, &format, preview.settings);
    fit_to_machine(preview.sheet, format, preview.settings);
    if (preview.way != "auto" && preview.way != "portrait" && preview.way != "landscape")
        throw Error(Fault::usage, "--orientation", phrase("it is auto, portrait or landscape"));
    if (given.has("--output")) preview.items = plan_outputs(given.words, given.all("--output"), {}, real_disk());
    for (const Item& item : preview.items)
        for (const Output& output : item.outputs)
            if (output.format->embosser != nullptr)
                throw Error(Fault::usage, "-o",
                            phrase("a picture of the sheets is a png, svg, pdf or another of tactics list formats"));
    return preview;
}

// A page that is wider than high went in turned.
bool went_in_turned(const Preview& preview, const Punched& punched) {
    const auto lies_beside = [&](const PunchedSheet& sheet) {
        return !sheet.dots.empty() && extent_of(sheet).right > preview.sheet.paper.width;
    };
    return preview.way == "landscape" || preview.sheet.orientation == Orientation::landscape ||
           (preview.way == "auto" && std::any_of(punched.sheets.begin(), punched.sheets.end(), lies_beside));
}

// For all pictures together: far more than anybody looks at. A page takes ten times the memory of its dots.
constexpr std::size_t kMostDrawnSheets = 1000, kMostDrawnDots = 500'000;

// The first sheets, up to the limit; if a single sheet exceeds it, its first dots.
std::vector<PunchedSheet> drawn_sheets(const Punched& punched) {
    std::vector<PunchedSheet> drawn;
    std::size_t left = kMostDrawnDots;
    for (const PunchedSheet& sheet : punched.sheets) {
        if (drawn.size() == kMostDrawnSheets || (sheet.dots.size() > left && !drawn.empty())) break;
        const auto dots = static_cast<std::ptrdiff_t>(std::min(sheet.dots.size(), left));
        PunchedSheet& one = drawn.emplace_back();
        one.dots.assign(sheet.dots.begin(), sheet.dots.begin() + dots);
        if (!sheet.heights.empty()) one.heights.assign(sheet.heights.begin(), sheet.heights.begin() + dots);
        left -= one.dots.size();
    }
    return drawn;
}

// Empty: all is drawn.
Phrase not_drawn(const std::vector<PunchedSheet>& drawn, const Punched& punched) {
    if (drawn.size() < punched.sheets.size())
        return phrase("pictures show the first {0} of {1} sheets; cut the file up to see the others",
                      std::to_string(drawn.size()), std::to_string(punched.sheets.size()));
    if (drawn.size() == 1 && drawn.front().dots.size() < punched.sheets.front().dots.size())
        return phrase("pictures show the first {0} of {1} dots; cut the file up to see the others",
                      std::to_string(drawn.front().dots.size()), std::to_string(punched.sheets.front().dots.size()));
    return {};
}

void write_pictures(const Preview& preview, const std::vector<PunchedSheet>& drawn, double width, double height) {
    std::vector<Page> pages;
    for (const PunchedSheet& sheet : drawn) pages.push_back(page_of(sheet, width, height, 1.6));
    NewFiles files;
    for (const Item& item : preview.items)
        for (const Output& output : item.outputs) {
            std::size_t number = 0;
            each_file(*output.format, pages, Settings(output.format->options),
                      [&](std::string_view bytes) { files.add(path_of_page(output, ++number), bytes); });
        }
    files.take_names();
}

int run_preview(const Given& given) {
    const Preview preview = plan_preview(given);
    Punched punched;
    {
        std::string sent;
        append_file(sent, given.words[0]);
        punched = preview.format->embosser->punch(sent, preview.settings);
    }
    double width = preview.sheet.paper.width, height = preview.sheet.paper.height;
    if (went_in_turned(preview, punched)) std::swap(width, height);
    if (!preview.items.empty()) {
        const std::vector<PunchedSheet> drawn = drawn_sheets(punched);
        if (Phrase note = not_drawn(drawn, punched); !note.empty()) punched.notes.push_back(std::move(note));
        write_pictures(preview, drawn, width, height);
    }

    const double raster = preview.format->dots != nullptr ? preview.format->dots(preview.settings).bed.raster : 0;
    const double pitch = raster > 0 ? raster : 2.5;
    for (std::size_t i = 0; i < punched.sheets.size(); ++i) {
        const PunchedSheet& sheet = punched.sheets[i];
        std::string text;
        if (given.has("--json")) {
            text = json_of_preview(sheet, i + 1, width, height, punched.notes);
        } else if (given.has("--unicode")) {
            if (i > 0) text = "\f";
            if (!sheet.apart.empty()) text += unicode_of(sheet.apart) + "\n";
            for (const std::string& line : unicode_of(sheet, pitch)) text += line + "\n";
        } else {
            text = preview_told(sheet, i + 1, width, height).in(user_language()) + "\n";
            if (!sheet.apart.empty()) text += phrase("its line of text: {0}", unicode_of(sheet.apart)).in(user_language()) + "\n";
        }
        print_out(text);
    }
    for (const Phrase& note : punched.notes) say(phrase("{0}: {1}", given.words[0], note));
    return 0;
}

}  // namespace

extern const Command preview_command;
const Command preview_command{
    .name = "preview",
    .summary = "show what an embosser or a display makes of a file written for it",
    .words = "FILE --embosser NAME",
    .details =
        "FILE holds the bytes that would be sent, from convert or from another program; - is standard input. preview reads them "
        "as the machine would, with code independent of the writer, so that one checks the other. It reports each sheet with "
        "the number and extent of its dots; bytes that the machine would not understand go to standard error, with their "
        "position in the file.",
    .example =
        "tactics convert photo.jpg -o index-v4:page.prn\n"
        "tactics preview page.prn --embosser index-v4 -o preview.png\n"
        "tactics preview page.prn --embosser index-v4 --unicode",
    .flags = kPreviewFlags,
    .offers = "files",
    .takes_kept = true,
    .run = run_preview,
};

}  // namespace tactics
