// SPDX-License-Identifier: Apache-2.0
// What is known of an embosser besides how to write its bytes. The embossers are formats (format.h) in embossers/, one a file.
#pragma once

#include <span>
#include <string_view>

#include "print/machines/punched.h"
#include "tactics/confidence.h"
#include "tactics/option.h"
#include "tactics/page.h"

namespace tactics {

/// Something that its bytes rely on, who says so, and how sure that is. None was tried on a machine by this project.
struct ProtocolFact {
    std::string_view fact;
    std::string_view source;
    Confidence confidence = Confidence::uncertain;
};

struct Format;
struct DotSetting;
struct PinDisplay;

/// How a machine sets text, where that is not how it is sent drawings.
struct TextMode {
    DotSetting (*dots)(const Settings& settings) = nullptr;
    std::string (*encode_pages)(std::span<const Page> pages, const Settings& settings) = nullptr;
};

/// A name of Embosser::called whose machine has other settings than its entry; as --set has them, without the entry's name.
struct ModelSettings {
    std::string_view called;
    std::string_view settings;  ///< "model=romeo"
};

struct Embosser {
    std::string_view models = {};  ///< what it drives, for people
    /// Those models as they are typed, in small letters with - for blanks: "everest-d romeo-60". A model is called in one entry
    /// only: that of its newest series where several drive it.
    std::string_view called = {};
    std::span<const ModelSettings> settings_by_model = {};
    std::string_view known_by = {};  ///< words, in small letters, one of which its id has on USB; empty: nothing tells it
    /// Bytes: a job that is a multiple of them long has another 1Ah behind it, or the machine waits for more; 0: it does not.
    std::size_t packet = 0;
    /// What comes out of the machine; never throws for what it is sent.
    Punched (*punch)(std::string_view bytes, const Settings& settings) = nullptr;
    double widest = 0;                                        ///< mm, of a sheet; 0: not known
    double (*widest_of)(const Settings& settings) = nullptr;  ///< where the models that it drives differ; nullptr: `widest`
    double longest = 0;                                       ///< mm; 0: not known
    std::string_view (*paper_of)(const Settings& settings) = nullptr;  ///< where models differ; nullptr: that of the entry
    std::span<const ProtocolFact> facts = {};
    const TextMode* text = nullptr;       ///< nullptr: as drawings, if those are lines of cells (text_pages.h)
    const PinDisplay* display = nullptr;  ///< no paper goes through it: its pins stay up until they are set again (pin_display.h)
};

/// What drives the model of that name, however it is written: "Everest-D V5", "index everest"; nullptr: none is called so.
const Format* find_model(std::string_view name);
/// What find_model's machine of that name is set to, "model=romeo"; empty: as its entry is, or no model is called so.
std::string_view settings_of_model(std::string_view name);
/// Sets that. `place` is where the name stands, for messages.
void set_model(Settings& settings, std::string_view name, std::string_view place);
/// "everest is driven as index-v4", "romeo is driven as enabling, model=romeo"
std::string driven_as(std::string_view model, const Format& format);

/// The name of the paper that is in it if nobody says which.
std::string_view own_paper(const Format& format, const Settings& settings);

/// An embosser or a display of pins, by its name or that of a model. Throws Error(usage) at `place` with the nearest name.
const Format& find_machine(std::string_view name, std::string_view place);
/// Throws Error(usage) at `place`, of a display with the command for it.
const Format& find_embosser(std::string_view name, std::string_view place);

/// Names of the embossers that a device with that id may be, "index-v4 or index-v3"; empty: it is not known to be one.
std::string taken_for(std::string_view id);

/// What stands behind a job of so many bytes for a machine with that Embosser::packet: 1Ah, or nothing.
std::string_view packet_end(std::size_t packet, std::size_t bytes);

bool takes_sheet(const Embosser& embosser, const Settings& settings, double width, double height);
/// Throws Error(usage) at `name` if it does not.
void check_sheet(const Embosser& embosser, const Settings& settings, std::string_view name, double width, double height);

}  // namespace tactics
