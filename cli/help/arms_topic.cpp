// SPDX-License-Identifier: Apache-2.0
// `tactics help arms`: for who has a haptic arm, and what each is asked and told.
#include "cli/help/topics.h"
#include "tactics/haptics/voice/plot_keys.h"
#include "tactics/text/words.h"

namespace tactics {

namespace {

// Lines of at most 80 letters.
std::string folded(std::string line, const std::string& set_in) {
    constexpr std::size_t kWidth = 80;
    std::string text;
    while (line.size() > kWidth) {
        const auto blank = line.rfind(' ', kWidth);
        text += line.substr(0, blank) + "\n";
        line = set_in + line.substr(blank + 1);
    }
    return text + line + "\n";
}

std::string keys() {
    std::string text;
    const auto all = plot_keys();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string letter = all[i].letter == 0 ? "" : std::string(1, all[i].letter);
        const std::string number = i < kNumberedKeys ? std::to_string(i + 1) : "";
        text += folded("  " + number + (number.empty() || letter.empty() ? "" : " or ") + letter + ": " +
                           std::string(all[i].name) + ", " + std::string(all[i].what),
                       "    ");
    }
    return text;
}

std::string chosen_names() {
    std::vector<std::string_view> names;
    for (const PlotAction action : chosen_actions()) names.push_back(key_of(action).name);
    return joined(names, ", ", " and ");
}

std::string key_text() {
    return "Keys of an arm, by their numbers, and on the keyboard of the terminal while the\n"
           "play goes by the clock:\n" +
           keys() +
           folded(
               "With two keys everything is reached: 2 steps through " + chosen_names() + ", and says each (--speak); 1 does it.",
               "") +
           "Nothing is held down, and nothing depends on how long a key is pressed. For an\n"
           "arm with one key the others are on the keyboard.\n"
           "A finger that is led is let go when 2 is pressed, when it is there, when it\n"
           "stands still against the pull for a second, or when it goes away by more than\n"
           "5 mm. The pull is a quarter of what the arm gives at most, and never over 1 N.\n"
           "Turns of a curve that are lower than 1 mm under the finger are passed over.\n";
}

std::string text() {
    return "A haptic arm knows where the finger is and pushes it in space. Three kinds are\n"
           "spoken with. Nobody has tried them on a real device yet: they follow what the\n"
           "makers have published, and were tested against programs of our own.\n"
           "\n"
           "inverse3: or inverse3:localhost:10001 or inverse3:localhost:10001/049D\n"
           "  Haply's Inverse3, Inverse3x and Minverse, by Haply's Inverse Service from\n"
           "  version 3.1 on, which must run on this machine (Haply Hub starts it, or\n"
           "  systemctl start haply-inverse-service). Another machine is refused. Of several\n"
           "  devices name one by its id. Keys are those of a VerseGrip: a, b, c. No force\n"
           "  is given while the service says that the device is not ready, not calibrated\n"
           "  or without power. Its events (port 10020) are not listened to.\n"
           "dhd: or dhd:/opt/sdk/lib/libdhd.so\n"
           "  delta, omega, sigma and lambda of Force Dimension, and the Novint Falcon, by\n"
           "  the maker's own library, which is not part of tactics: get the SDK from\n"
           "  forcedimension.com/software/sdk, which says how to be permitted the device.\n"
           "openhaptics: or openhaptics:/usr/lib/libHD.so\n"
           "  The Touch and Phantoms of 3D Systems, by the maker's own library and driver:\n"
           "  OpenHaptics for Linux, from support.3dsystems.com. It is the default device.\n"
           "A library that is named by its path runs with your rights.\n"
           "\n"
           "All tell and take x to the right, y upwards and z towards you. The origin of an\n"
           "Inverse3 is the middle of what it reaches, that of the others their maker's.\n"
           "\n"
           "A force is at most 8 N whichever way, and holds for 10 ms: if tactics hangs, the\n"
           "device is told that there is none. So it is at the end, before anything else is\n"
           "done. Where a device says nothing for 3 ms the force goes; an Inverse Service\n"
           "without an answer for 20 ms is told once more that there is none, and after half\n"
           "a second it is gone. What an arm does by itself when tactics is killed is its\n"
           "maker's affair; keep its stop button within reach.\n"
           "\n"
           "arm is one without a machine: a simulated Omni, Desktop or Phantom (--arm, or a\n"
           "file of its numbers, such as arm.delay = 0.001 s), in which a finger is. What it\n"
           "does is --hand: trace finds a curve from the axes, follows it to its end and\n"
           "stops at a tick; points takes down where points are; sections how high a\n"
           "surface is along two lines; to-and-fro goes through the middle; led lets itself\n"
           "be led, by the keys that --guide names. It feels what a person could, a little\n"
           "late, and play tells how right it was.\n"
           "\n"
           "A table becomes a plot in space: a wall, axes that hold the finger in, with a\n"
           "bump at each tick, a grid that is passed like honey, curves that draw the finger\n"
           "to them, points that push it away, surfaces that bear it (--feel names some).\n"
           "\n" +
           key_text() +
           "\n"
           "The weighting function of curves (--fixture) is lost from the papers; r1 and r2\n"
           "are reconstructions. Stiffness and damping that the arm does not bear, with a\n"
           "finger in it and with none, are refused with the nearest that it does; --arm\n"
           "also tells the limits of a real arm.\n"
           "\n"
           "recorded:FILE.csv (with --arm) repeats a way: time_s,x_mm,y_mm,z_mm a line,\n"
           "named by the first line. What play --csv writes can be played again.\n";
}

}  // namespace

extern const Topic arms_topic;
const Topic arms_topic{"arms", "haptic arms: which are spoken with, their axes and limits", text};

}  // namespace tactics
