// SPDX-License-Identifier: Apache-2.0
// `tactics devices`: what is attached that could be an embosser, and what else this program knows.
#include "tactics/transport/devices.h"

#include "cli/command.h"
#include "cli/report/say.h"
#include "cli/report/user_language.h"
#include "print/embosser.h"
#include "tactics/error.h"
#include "tactics/haptics/devices/haptic_devices.h"
#include "tactics/text/json.h"

namespace tactics {

namespace {

constexpr Flag kDevicesFlags[] = {
    {"--json", "", "", "one JSON object per line: address, id, embosser, note", false, ""},
};

int run_devices(const Given& given) {
    if (!given.words.empty()) throw Error(Fault::usage, "devices", phrase("it takes no words; see tactics devices --help"));
    std::vector<AttachedDevice> devices = attached_devices("");
    const std::vector<AttachedDevice> queues = print_queues();
    devices.insert(devices.end(), queues.begin(), queues.end());
    const std::size_t printers = devices.size();
    const std::vector<AttachedDevice> haptic = haptic_devices("");
    devices.insert(devices.end(), haptic.begin(), haptic.end());
    std::string text;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const AttachedDevice& device = devices[i];
        const std::string embosser = i >= printers || device.address.starts_with("hid:") ? "" : taken_for(device.id);
        if (given.has("--json")) {
            JsonAnswer json;
            json.add("address", device.address);
            json.add("id", device.id);
            json.add("embosser", embosser);
            json.add("note", device.note.english());
            text += json.text() + "\n";
            continue;
        }
        Phrase line = phrase("{0}: {1}", device.address.empty() ? phrase("a printer on USB") : Phrase(device.address),
                             device.id.empty() ? phrase("does not tell what it is") : Phrase(device.id));
        if (!embosser.empty()) line = phrase("{0}; {1}", line, "--embosser " + embosser);
        if (!device.note.empty()) line = phrase("{0}; {1}", line, device.note);
        text += line.in(user_language()) + "\n";
    }
    print_out(text);
    if (devices.empty() && !given.has("--json"))
        say(
            phrase("no printer on USB, no serial adapter, no print queue, no braille display, no haptic mouse and no touch "
                   "overlay is there; plug the machine in and switch it on"));
    return 0;
}

}  // namespace

extern const Command devices_command;
const Command devices_command{
    .name = "devices",
    .summary = "list what is attached: embossers, braille displays, haptic mice, touch overlays",
    .details =
        "Each line gives an address for tactics emboss --to, what the device says it is (its IEEE-1284 id), and the embossers "
        "that it may be. The list has USB printers, serial adapters, print queues and braille displays of the HID standard "
        "(hid:, to which emboss does not send), then haptic mice and touch overlays with what to write for tactics play. "
        "Nothing is opened or sent.",
    .example = "tactics devices\ntactics devices --json",
    .flags = kDevicesFlags,
    .run = run_devices,
};

}  // namespace tactics
