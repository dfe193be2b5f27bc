// SPDX-License-Identifier: Apache-2.0
// The facts about an embosser, apart from the encoding of its bytes. The embossers are formats (format.h) in embossers/, one file
// each.
#pragma once

#include <span>
#include <string_view>

#include "print/machines/punched.h"
#include "tactics/confidence.h"
#include "tactics/option.h"
#include "tactics/page.h"
#include "tactics/text/phrase.h"

namespace tactics {

/// A fact on which its bytes rely, its source, and the confidence in it. This project has tried none of them on a machine.
struct ProtocolFact {
    std::string_view fact;
    std::string_view source;
    Confidence confidence = Confidence::uncertain;
};

struct Format;
struct DotSetting;
struct PinDisplay;

/// How a machine sets text, if that differs from the way it receives drawings.
struct TextMode {
    DotSetting (*dots)(const Settings& settings) = nullptr;
    std::string (*encode_pages)(std::span<const Page> pages, const Settings& settings) = nullptr;
};

/// A name in Embosser::called whose machine needs settings other than the entry's; written as for --set, without the entry's
/// name.
struct ModelSettings {
    std::string_view called;
    std::string_view settings;  ///< "model=romeo"
};

struct Embosser {
    std::string_view models = {};  ///< the machines that it drives, for people
    /// The same models as typed, in lower case with - for blanks: "everest-d romeo-60". Each model is in one entry only: if
    /// several drive it, in that of its newest series.
    std::string_view called = {};
    std::span<const ModelSettings> settings_by_model = {};
    std::string_view known_by = {};  ///< words in lower case, one of which occurs in its USB id; empty: the id does not identify
                                     ///< it
    /// Packet size in bytes: a job whose length is a multiple of it needs another 1Ah after it, or the machine waits for more; 0:
    /// no such size.
    std::size_t packet = 0;
    /// The machine's output; never throws, whatever it receives.
    Punched (*punch)(std::string_view bytes, const Settings& settings) = nullptr;
    double widest = 0;                                                 ///< width of a sheet, mm; 0: unknown
    double (*widest_of)(const Settings& settings) = nullptr;           ///< if its models differ; nullptr: `widest`
    double longest = 0;                                                ///< mm; 0: unknown
    std::string_view (*paper_of)(const Settings& settings) = nullptr;  ///< if models differ; nullptr: that of the entry
    std::span<const ProtocolFact> facts = {};
    const TextMode* text = nullptr;       ///< nullptr: like drawings, if those are lines of cells (text_pages.h)
    const PinDisplay* display = nullptr;  ///< a display, without paper: its pins stay up until they are set again (pin_display.h)
};

/// The format that drives the model of that name, in any spelling: "Everest-D V5", "index everest"; nullptr: no such model.
const Format* find_model(std::string_view name);
/// The settings for find_model's machine of that name, "model=romeo"; empty: those of its entry, or no such model.
std::string_view settings_of_model(std::string_view name);
/// Applies these settings. `place` is where the name was given, for messages.
void set_model(Settings& settings, std::string_view name, std::string_view place);
/// "everest is driven as index-v4", "romeo is driven as enabling, model=romeo"
Phrase driven_as(std::string_view model, const Format& format);

/// The name of its default paper.
std::string_view own_paper(const Format& format, const Settings& settings);

/// An embosser or a pin display, by its name or that of a model. Throws Error(usage) at `place` with the nearest name.
const Format& find_machine(std::string_view name, std::string_view place);
/// Throws Error(usage) at `place`; for a display, the message names the right command.
const Format& find_embosser(std::string_view name, std::string_view place);

/// Names of the embossers that a device with that id may be, "index-v4 or index-v3"; empty: no known embosser.
std::string taken_for(std::string_view id);

/// The bytes to add after a job of that length for a machine with that Embosser::packet: 1Ah, or nothing.
std::string_view packet_end(std::size_t packet, std::size_t bytes);

bool takes_sheet(const Embosser& embosser, const Settings& settings, double width, double height);
/// Throws Error(usage) at `name` if it does not.
void check_sheet(const Embosser& embosser, const Settings& settings, std::string_view name, double width, double height);

}  // namespace tactics
