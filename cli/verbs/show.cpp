// SPDX-License-Identifier: Apache-2.0
// `tactics show`: a picture on a tactile display.
#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <optional>

#include "cli/chain.h"
#include "cli/command.h"
#include "cli/model_flags.h"
#include "cli/page_flags.h"
#include "cli/report/report.h"
#include "cli/report/say.h"
#include "cli/request.h"
#include "cli/table_flags.h"
#include "print/display_parts.h"
#include "print/embosser.h"
#include "print/pin_display.h"
#include "print/screen.h"
#include "tactics/error.h"
#include "tactics/job/disk.h"
#include "tactics/job/make_pages.h"
#include "tactics/text/json.h"
#include "tactics/text/words.h"
#include "tactics/transport/channels.h"
#include "tactics/units.h"

namespace tactics {

namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr Flag kShowFlags[] = {
    {"--on", "", "DISPLAY:PLACE",
     "the display: dot-pad:/dev/ttyUSB0, graphiti:/dev/ttyACM0; brlapi: for the screen reader's braille display, brlapi:HOST:0 "
     "for one on another machine; hid: for a braille display of the HID standard, hid:/dev/hidraw0 if there are several",
     false, ""},
    {"--zoom", "", "NUMBER",
     "enlarge the drawing this many times over the size that fits, from 1 to 8; the display shows one "
     "part of it at a time",
     false, ""},
    {"--part", "", "NUMBER", "the part to show first, counted from left to right and from the top down; default: 1", false, ""},
    {"--for", "", "SECONDS", "end after this time, without keys", false, ""},
    kPdfPageFlag,
    kAllowFlag,
#include "cli/table_flags.inc"
#include "cli/table_flags_of_bars.inc"
    kModelFlag,
    kModelPartFlag,
    kFoldFlag,
    kReaderFlag,
    kRecipeFlag,
    kFilterFlag,
    {"--set", "-s", "NAME.OPTION=VALUE",
     "change a setting in every step of a filter, or of the display: graphiti.pattern=1. May be given several times", true,
     "settings"},
    kDetailFlag,
    kAsDrawnFlag,
    kTitleFlag,
    kTitleFromNameFlag,
    kCaptionFlag,
    kBrailleFlag,
    kLanguageFlag,
    kSubjectFlag,
    kSubjectOnlyFlag,
    kLeaveFlag,
    kLabelFlag,
    kLabelsFlag,
    kWordsFlag,
    {"--quiet", "-q", "", "say nothing but errors", false, ""},
    {"--json", "", "", "report the size of the display and the parts on standard output, as a JSON object", false, ""},
};

int whole_number(const Given& given, std::string_view name, int most, const Phrase& words) {
    const auto number = parse_number(given.value(name, "1"));
    if (!number || *number < 1 || *number > most || *number != std::floor(*number)) throw Error(Fault::usage, name, words);
    return static_cast<int>(*number);
}

// The user's settings for a display; no effect on displays that report everything about themselves.
Settings settings_of(const Format& format, const Given& given, bool tells_all) {
    Settings settings(format.options);
    for (const std::string& text : given.all("--set")) {
        const Change change = parse_change(text, "--set");
        if (change.name != format.name) continue;
        if (tells_all)
            throw Error(Fault::usage, "--set",
                        phrase("the display itself tells its {0}, so this would do nothing; leave it out", change.option));
        settings.set(change.option, change.value, change.place, change.name);
    }
    return settings;
}

// "dot-pad:/dev/ttyUSB0", "graphiti:/dev/ttyACM0", "hid:", "hid:/dev/hidraw0", "brlapi:", "brlapi:HOST:0".
std::unique_ptr<Screen> open_screen(const std::string& address, const Given& given) {
    const auto colon = address.find(':');
    const std::string name = address.substr(0, colon), rest = colon == std::string::npos ? "" : address.substr(colon + 1);
    if (name == "hid" || name == "brlapi") {
        settings_of(*find_format("braille-display"), given, true);
        if (name == "hid") return cell_screen(open_hid_display(rest), true, address);
        return cell_screen(open_brlapi(rest), false, address);
    }
    std::vector<std::string_view> names{"brlapi", "hid"};
    for (const Format* format : formats()) {
        if (format->embosser == nullptr || format->embosser->display == nullptr) continue;
        names.push_back(format->name);
        for (const std::string_view model : words_of(format->embosser->called)) names.push_back(model);
        if (name != format->name && find_model(name) != format) continue;
        if (rest.empty())
            throw Error(Fault::usage, "--on", phrase("say which line it is on: {0}:/dev/ttyUSB0; see tactics devices", name));
        const Settings settings = settings_of(*format, given, format->name == "dot-pad");
        return pin_screen(*format, settings, open_serial(rest, format->embosser->display->baud, Flow::none), rest);
    }
    throw Error(Fault::usage, "--on",
                phrase("there is no display \"{0}\"{1}; it is dot-pad:/dev/ttyUSB0, graphiti:/dev/ttyACM0, hid: or brlapi:, for "
                       "example; see tactics devices and tactics list displays",
                       name.substr(0, 80), did_you_mean(name, names)));
}

std::optional<Clock::time_point> end_of(const Given& given) {
    if (!given.has("--for")) return std::nullopt;
    const auto seconds = parse_number(given.value("--for"));
    if (!seconds || *seconds < 0 || *seconds > 1e6)
        throw Error(Fault::usage, "--for", phrase("it is a number of seconds, up to a million"));
    return Clock::now() + milliseconds(std::lround(1000 * *seconds));
}

// The pages, enlarged beyond the display by the wished factor; names and title keep their size.
Outcome made_for(const Screen& screen, const Given& given, int zoom) {
    Request request = plan_pages({{given.words[0], {{&screen.format(), "", ""}}}}, given, real_disk());
    request.settings.front().second = screen.settings();
    request.zoom = zoom;
    Outcome outcome = make_pages(Job{request.items.front(), request});
    if (!outcome.error.empty()) throw Error(outcome.fault, "", outcome.error);
    if (!given.has("--quiet"))
        for (const Note& note : outcome.notes) say(phrase("{0}: {1}", outcome.input, note.words));
    // A finger cannot tell an empty display from one that was not set.
    if (outcome.layouts.front().empty)
        say(phrase("{0}: nothing can be felt of it on {1}; try --zoom 3, --recipe line-art or --detail 2", outcome.input,
                   given.value("--on")));
    return outcome;
}

enum class Next { forward, back, end };

// The first event: a line from the keyboard, a key of the display, or the end of the time.
Next wait_for(Screen& screen, bool keyboard, std::optional<Clock::time_point> end) {
    constexpr milliseconds kStep{50};
    for (;;) {
        if (end && Clock::now() >= *end) return Next::end;
        if (screen.key_within(kStep)) return Next::forward;
        pollfd line{STDIN_FILENO, POLLIN, 0};
        if (!keyboard || poll(&line, 1, 0) <= 0) continue;
        char block[256];
        const ssize_t count = read(STDIN_FILENO, block, sizeof block);
        if (count <= 0 || block[0] == 'q') return Next::end;
        return block[0] == 'p' ? Next::back : Next::forward;
    }
}

Phrase show_told(const Given& given, const std::vector<Page>& parts, std::size_t part) {
    return phrase("{0}: part {1} of {2}", given.value("--on"), std::to_string(part + 1), std::to_string(parts.size()));
}

std::string show_in_json(const Given& given, const DotSetting& size, const Made& made, std::size_t parts, std::size_t part,
                         bool confirmed) {
    JsonAnswer json;
    json.add("display", given.value("--on"));
    json.add("width_mm", size.width);
    json.add("height_mm", size.height);
    json.add("parts", static_cast<double>(parts));
    json.add("part", static_cast<double>(part + 1));
    if (made.heights) json.add_raw("heights", heights_json(*made.heights));
    json.add_raw("confirmed", confirmed ? "true" : "false");
    return json.text() + "\n";
}

int run_show(const Given& given) {
    if (given.words.size() != 1)
        throw Error(Fault::usage, "show",
                    phrase("name one picture; for example: tactics show photo.jpg --on dot-pad:/dev/ttyUSB0"));
    if (!given.has("--on"))
        throw Error(Fault::usage, "--on",
                    phrase("name the display: dot-pad:/dev/ttyUSB0, graphiti:/dev/ttyACM0, hid: or brlapi:, for example"));
    const int zoom = whole_number(given, "--zoom", 8, phrase("it is a whole number from 1 to {0}", "8"));
    whole_number(given, "--part", 1'000'000, phrase("it is the number of a part, from 1"));
    end_of(given);  // before anything moves
    const auto screen = open_screen(given.value("--on"), given);
    const DotSetting size = screen->format().dots(screen->settings());
    const Outcome made = made_for(*screen, given, zoom);
    const std::vector<Page> parts = parts_of(made.layouts.front().shown, size.width, size.height);
    const Phrase there_are = parts.size() == 1 ? phrase("there is one part; --zoom makes more")
                                               : phrase("there are {0} parts", std::to_string(parts.size()));
    auto part = static_cast<std::size_t>(whole_number(given, "--part", static_cast<int>(parts.size()), there_are)) - 1;
    const auto end = end_of(given);
    const bool keyboard = isatty(STDIN_FILENO) != 0;
    const bool stays = end || keyboard || !screen->keeps();
    if (stays && keyboard && !given.has("--quiet"))
        say(phrase("Enter shows the next part, p the one before, q ends; a key of the display is as Enter"));
    for (bool first = true;; first = false) {
        const bool confirmed = screen->show(parts[part]);
        if (given.has("--json") && first) print_out(show_in_json(given, size, made.made.front(), parts.size(), part, confirmed));
        if (!confirmed)
            say(phrase("{0}: the display did not say that it shows it; feel whether it does, else switch it off and on again",
                       given.value("--on")));
        if (!given.has("--quiet")) say(show_told(given, parts, part));
        if (!stays) return 0;
        const Next next = wait_for(*screen, keyboard, end);
        if (next == Next::end || (next == Next::forward && part + 1 == parts.size())) return 0;
        if (next == Next::forward)
            ++part;
        else if (part > 0)
            --part;
    }
}

}  // namespace

extern const Command show_command;
const Command show_command{
    .name = "show",
    .summary = "show a picture on a tactile display: pins, or the braille display of a screen reader",
    .words = "PICTURE --on DISPLAY:PLACE",
    .details =
        "tactics asks the display for its size, lays the drawing out for it as convert would, and shows it. With --zoom, or "
        "with names that need a key, there are several parts. At a keyboard, Enter shows the next part, p the previous one, and "
        "q ends; a key on the display also shows the next part, and after the last part the command ends. Without a keyboard, "
        "the part given by --part is shown. Pins then stay up; the braille display of a screen reader moves on at each of its "
        "keys, until the last part or until the time of --for is over.\n\n"
        "tactics convert writes the same to a file: -o dot-pad:FILE, -o graphiti:FILE, -o braille-display:FILE.",
    .example =
        "tactics show photo.jpg --on dot-pad:/dev/ttyUSB0 --title \"A bridge\"\n"
        "tactics show map.png --on brlapi: --zoom 3\n"
        "tactics show plan.svg --on graphiti:/dev/ttyACM0 --part 2",
    .flags = kShowFlags,
    .offers = "files",
    .takes_kept = true,
    .run = run_show,
};

}  // namespace tactics
