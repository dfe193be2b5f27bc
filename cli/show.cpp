// `tactics show`: a picture on a tactile display.
#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <optional>

#include "cli/command.h"
#include "cli/conversion.h"
#include "cli/disk.h"
#include "cli/json.h"
#include "cli/page_flags.h"
#include "cli/request.h"
#include "cli/say.h"
#include "cli/screen.h"
#include "print/display_parts.h"
#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics {

namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr Flag kFlags[] = {
    {"--on", "", "DISPLAY:PLACE", "the display: dot-pad:/dev/ttyUSB0, graphiti:/dev/ttyACM0; brlapi: for that of the screen reader, brlapi:HOST:0 for one elsewhere; hid: for a braille display of the HID standard, hid:/dev/hidraw0 if there are several", false,
     ""},
    {"--zoom", "", "NUMBER", "so many times as large as fits, from 1 to 8; the display shows a part of it at a time", false, ""},
    {"--part", "", "NUMBER", "the part that is shown first, from left to right and from the top down; 1 if none is named", false, ""},
    {"--for", "", "SECONDS", "end after that time, without keys", false, ""},
    kPdfPageFlag,
    kRecipeFlag,
    kFilterFlag,
    {"--set", "-s", "NAME.OPTION=VALUE", "change a setting in every step of that filter, or of the display: graphiti.pattern=1. May be given several times", true, "settings"},
    kDetailFlag,
    kAsDrawnFlag,
    kTitleFlag,
    kTitleFromNameFlag,
    kCaptionFlag,
    kBrailleFlag,
    kLabelFlag,
    kLabelsFlag,
    {"--quiet", "-q", "", "say nothing but errors", false, ""},
    {"--json", "", "", "tell the size of the display and the parts on standard output, as a JSON object", false, ""},
};

// Of these options convert has the same.
constexpr std::string_view kOfThePage[] = {"--page", "--recipe", "--filter", "--set", "--detail", "--as-drawn", "--title", "--title-from-name", "--caption",
                                           "--braille", "--label", "--labels"};

int whole_number(const Given& given, std::string_view name, int most) {
    const auto number = parse_number(given.value(name, "1"));
    if (!number || *number < 1 || *number > most || *number != std::floor(*number))
        throw Error(Fault::usage, name, "it is a whole number from 1 to " + std::to_string(most));
    return static_cast<int>(*number);
}

std::optional<Clock::time_point> end_of(const Given& given) {
    if (!given.has("--for")) return std::nullopt;
    const auto seconds = parse_number(given.value("--for"));
    if (!seconds || *seconds < 0 || *seconds > 1e6) throw Error(Fault::usage, "--for", "it is a number of seconds, up to a million");
    return Clock::now() + milliseconds(std::lround(1000 * *seconds));
}

// The pages, as many times larger than the display as is wished; names and title keep their size.
std::vector<Page> pages_for(const Screen& screen, const Given& given, int zoom) {
    Request request = plan_pages({{given.words[0], {{&screen.format(), "", ""}}}}, handed_on(given, *find_command("convert"), kOfThePage), real_disk());
    request.settings.front().second = screen.settings();
    request.zoom = zoom;
    WriteGate gate;
    Outcome outcome = convert_picture(request, request.jobs.front(), gate);
    if (!outcome.error.empty()) throw Error(outcome.fault, "", outcome.error);
    if (!given.has("--quiet"))
        for (const std::string& note : outcome.notes) say(outcome.input + ": " + note);
    return std::move(outcome.layouts.front().shown);
}

enum class Next { forward, back, end };

// What comes first: a line from the keyboard, a key of the display, the end of the time.
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

std::string told(const Given& given, const std::vector<Page>& parts, std::size_t part) {
    return given.value("--on") + ": part " + std::to_string(part + 1) + " of " + std::to_string(parts.size());
}

int run(const Given& given) {
    if (given.words.size() != 1) throw Error(Fault::usage, "show", "name one picture; for example: tactics show photo.jpg --on dot-pad:/dev/ttyUSB0");
    if (!given.has("--on")) throw Error(Fault::usage, "--on", "name the display: dot-pad:/dev/ttyUSB0, graphiti:/dev/ttyACM0, hid: or brlapi:, for example");
    const int zoom = whole_number(given, "--zoom", 8);
    const auto screen = open_screen(given.value("--on"), given.all("--set"), "--on");
    const DotSetting size = screen->format().dots(screen->settings());
    const std::vector<Page> parts = parts_of(pages_for(*screen, given, zoom), size.width, size.height);
    auto part = static_cast<std::size_t>(whole_number(given, "--part", static_cast<int>(parts.size()))) - 1;
    if (given.has("--json")) {
        JsonObject json;
        json.add("display", given.value("--on"));
        json.add("width_mm", size.width);
        json.add("height_mm", size.height);
        json.add("parts", static_cast<double>(parts.size()));
        json.add("part", static_cast<double>(part + 1));
        print_out(json.text() + "\n");
    }
    const auto end = end_of(given);
    const bool keyboard = isatty(STDIN_FILENO) != 0;
    const bool stays = end || keyboard || !screen->keeps();
    if (stays && keyboard && !given.has("--quiet")) say("Enter shows the next part, p the one before, q ends; a key of the display is as Enter");
    for (;;) {
        screen->show(parts[part]);
        if (!given.has("--quiet")) say(told(given, parts, part));
        if (!stays) return 0;
        const Next next = wait_for(*screen, keyboard, end);
        if (next == Next::end || (next == Next::forward && part + 1 == parts.size())) return 0;
        if (next == Next::forward) ++part;
        else if (part > 0) --part;
    }
}

}  // namespace

extern const Command show_command;
const Command show_command{
    .name = "show",
    .summary = "show a picture on a tactile display: pins, or the braille display of a screen reader",
    .words = "PICTURE --on DISPLAY:PLACE",
    .details =
        "The display is asked how large it is, the drawing is laid out for it as convert would, and shown. With --zoom, or with names that "
        "need a key, there are several parts. At a keyboard Enter goes on to the next, p back, q ends; a key of the display goes on, too, and after "
        "the last part the command ends. Without a keyboard the part of --part is shown; pins then stay as they are, and the braille display of a "
        "screen reader shows it until a key of it is pressed or the time of --for is over.\n\n"
        "tactics convert writes the same to a file: -o dot-pad:FILE, -o graphiti:FILE, -o braille-display:FILE.",
    .example =
        "tactics show photo.jpg --on dot-pad:/dev/ttyUSB0 --title \"A bridge\"\n"
        "tactics show map.png --on brlapi: --zoom 3\n"
        "tactics show plan.svg --on graphiti:/dev/ttyACM0 --part 2",
    .flags = kFlags,
    .offers = "files",
    .run = run,
};

}  // namespace tactics
