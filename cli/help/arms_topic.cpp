// SPDX-License-Identifier: Apache-2.0
// `tactics help arms`: for owners of a haptic arm, and the communication with each.
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
                           std::string(all[i].name.text) + ", " + std::string(all[i].what),
                       "    ");
    }
    return text;
}

std::string chosen_names() {
    std::vector<std::string_view> names;
    for (const PlotAction action : chosen_actions()) names.push_back(key_of(action).name.text);
    return joined(names, ", ", " and ");
}

std::string key_text() {
    return "Keys of an arm, by number, which also work on the terminal's keyboard while the\n"
           "play runs in real time:\n" +
           keys() +
           folded("Two keys reach everything: 2 steps through " + chosen_names() + ", and says each (--speak); 1 carries it out.",
                  "") +
           "No key has to be held down, and it does not matter how long a key is pressed. If\n"
           "the arm has one key, the others are on the keyboard.\n"
           "The arm stops leading a finger when 2 is pressed, when the finger arrives, when\n"
           "it stands still against the pull for a second, or when it moves away by more\n"
           "than 5 mm. The pull is a quarter of the arm's largest force, never over 1 N.\n"
           "Turns of a curve lower than 1 mm under the finger are skipped.\n";
}

std::string arms_text() {
    return "A haptic arm knows where the finger is and pushes it in space. tactics supports\n"
           "three kinds. None has been tried on a real device yet: the code follows the\n"
           "makers' publications, and was tested against programs of our own.\n"
           "\n"
           "inverse3: or inverse3:localhost:10001 or inverse3:localhost:10001/049D\n"
           "  Haply's Inverse3, Inverse3x and Minverse, by Haply's Inverse Service from\n"
           "  version 3.1 on, which must run on this machine (Haply Hub starts it, or\n"
           "  systemctl start haply-inverse-service). A service on another machine is\n"
           "  refused. If there are several devices, name one by its id. Keys are those of\n"
           "  a VerseGrip: a, b, c. There is no force while the service reports that the\n"
           "  device is not ready, not calibrated or without power. Its events (port 10020)\n"
           "  are ignored.\n"
           "dhd: or dhd:/opt/sdk/lib/libdhd.so\n"
           "  delta, omega, sigma and lambda of Force Dimension, and the Novint Falcon, by\n"
           "  the maker's own library, which is not part of tactics: get the SDK from\n"
           "  forcedimension.com/software/sdk, which explains how to get permission to use\n"
           "  the device.\n"
           "openhaptics: or openhaptics:/usr/lib/libHD.so\n"
           "  The Touch and Phantoms of 3D Systems, by the maker's own library and driver:\n"
           "  OpenHaptics for Linux, from support.3dsystems.com. tactics uses the default\n"
           "  device.\n"
           "A library named by its path runs with your rights.\n"
           "\n"
           "All report positions and take forces with x to the right, y upwards and z\n"
           "towards you. The origin of an Inverse3 is the middle of its reach; the others\n"
           "have the maker's origin.\n"
           "\n"
           "A force is at most 8 N in any direction, and holds for 10 ms: if tactics hangs,\n"
           "the device is sent zero force. The same happens at the end of a play, before\n"
           "anything else. If a device is silent for 3 ms, the force is dropped. An Inverse\n"
           "Service that does not answer for 20 ms is sent zero force once more, and after\n"
           "half a second it counts as gone. What an arm does when tactics is killed\n"
           "depends on its maker; keep its stop button within reach.\n"
           "\n"
           "arm is a simulated Omni, Desktop or Phantom (--arm, or a file that describes it,\n"
           "such as arm.delay = 0.001 s) with a finger in it; it needs no machine.\n"
           "--hand chooses what the finger does: trace finds a curve from the axes, follows\n"
           "it to its end and stops at a tick; points notes where points are; sections\n"
           "notes how high a surface is along two lines; to-and-fro moves through the\n"
           "middle; led lets itself be led, by the keys that --guide names. The finger\n"
           "feels what a person could, a little late, and play reports how right it was.\n"
           "\n"
           "A table becomes a plot in space: a wall, axes that hold the finger in and have\n"
           "a bump at each tick, a grid that drags like honey, curves that attract the\n"
           "finger, points that push it away, and surfaces that support it (--feel chooses\n"
           "some).\n"
           "\n" +
           key_text() +
           "\n"
           "The weighting function of curves (--fixture) is lost from the papers; r1 and r2\n"
           "are reconstructions. In sharp bends close together r2 holds a finger better; it\n"
           "may slip off r1 and linear there. Stiffness and damping at which the arm would\n"
           "not be stable, with or without a finger in it, are refused, and the nearest\n"
           "stable values are named; --arm also gives the limits of a real arm.\n"
           "\n"
           "recorded:FILE.csv (with --arm) repeats a path: each line has\n"
           "time_s,x_mm,y_mm,z_mm, and the first line names these columns. It also replays\n"
           "files from play --csv.\n";
}

}  // namespace

extern const Topic arms_topic;
const Topic arms_topic{"arms", "haptic arms: which are supported, their axes and limits", arms_text};

}  // namespace tactics
