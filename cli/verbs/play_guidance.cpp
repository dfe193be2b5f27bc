// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/play_guidance.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "cli/report/say.h"
#include "cli/request.h"
#include "cli/verbs/play_arm_flags.h"
#include "cli/verbs/play_device.h"
#include "cli/verbs/play_speech.h"
#include "cli/verbs/terminal_keys.h"
#include "tactics/error.h"
#include "tactics/haptics/scenes/plot_part.h"
#include "tactics/haptics/voice/keyed_scene.h"
#include "tactics/text/json.h"
#include "tactics/text/words.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kUnlimited = 3600;  // s of tones kept if no duration is given

struct OffCurve {
    double rms = 0, p95 = 0;
};
// Of the finger, along a curve.
std::optional<OffCurve> off_curve(const LeadRecord& way, const PlayedScene& played, const FeltLines& felt) {
    const bool along = way.goal.lead == LeadTo::follow || way.goal.lead == LeadTo::extremum;
    if (!along || played.lost || way.to > played.records.size() || way.from >= way.to) return std::nullopt;
    std::vector<std::vector<Point>> lines;
    for (std::size_t i = 0; i < felt.lines.size(); ++i)
        if (felt.curve[i] == way.goal.curve) lines.push_back(felt.lines[i]);
    constexpr double kFar = 10;  // mm
    const NearLines curve(lines, kFar);
    std::vector<double> off;
    double squares = 0;
    for (std::size_t tick = way.from; tick < way.to; ++tick) {
        const Point at = played.records[tick].at;
        const Nearness near = curve.at({at.x, at.y, 0});
        off.push_back(near.within ? distance(at, near.place) : kFar);
        squares += off.back() * off.back();
    }
    std::sort(off.begin(), off.end());
    return OffCurve{std::sqrt(squares / static_cast<double>(off.size())), off[off.size() * 95 / 100]};
}

const char* name_of(LeadTo lead) {
    switch (lead) {
        case LeadTo::start: return "start";
        case LeadTo::follow: return "follow";
        case LeadTo::extremum: return "extremum";
        case LeadTo::compare: return "compare";
    }
    return "";
}

const char* name_of(LeadEnd end) {
    switch (end) {
        case LeadEnd::arrived: return "arrived";
        case LeadEnd::resisted: return "resisted";
        case LeadEnd::left: return "left";
        case LeadEnd::stopped: return "stopped";
    }
    return "";
}

}  // namespace

std::vector<unsigned> keys_to_press(const Given& given, const HandKind& hand) {
    std::vector<unsigned> keys;
    if (!given.has("--guide")) return keys;
    if (!kind_of_device(given.value("--device")).has_hand)
        throw Error(
            Fault::usage, "--guide",
            phrase("only a simulated hand presses keys by itself (--device arm); leave it out, and press those of the arm"));
    if (hand.name != kLedHand)
        throw Error(Fault::usage, "--guide", phrase("only the hand that is led presses these keys; leave out --hand"));
    std::vector<std::string_view> names;
    for (const PlotKey& key : plot_keys().first(kNumberedKeys)) names.push_back(key.name.text);
    const std::string text = given.value("--guide");
    for (std::string_view rest = text; !rest.empty();) {
        const auto comma = std::min(rest.find(','), rest.size());
        const std::string_view name = rest.substr(0, comma);
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end())
            throw Error(Fault::usage, "--guide",
                        phrase("no key is called \"{0}\"{1}; it is {2}", name.substr(0, 80), did_you_mean(name, names),
                               either_of({names.begin(), names.end()})));
        keys.push_back(static_cast<unsigned>(found - names.begin()) + 1);
        rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
    if (keys.empty()) throw Error(Fault::usage, "--guide", phrase("name a key; for example --guide start,follow"));
    return keys;
}

struct PlotLayers::Parts {
    bool quiet = false;
    FeltLines felt;
    Guidance guidance;
    std::optional<Speaking> speaking;
    std::optional<Toning> toning;
    bool heard = false;
    std::optional<WavFile> wav;
    std::optional<ToneTrack> track;
    std::string wav_path;
    TypedKeys typed;
    std::optional<TerminalKeys> terminal;
    std::optional<KeyedScene> scene;

    Parts(const Given& given, const Plot& plot, const PlotFrame& frame, const PlotLayersWish& wish)
        : quiet(given.has("--quiet")),
          felt(felt_lines(plot, frame, wish.resolution)),
          guidance(wish.scene, GuidedLines(plot, frame, felt, wish.resolution), frame,
                   guidance_for(wish.most_force, wish.law.stiffness, wish.law.damping_ns_per_m)),
          speaking(speaking_of(given, plot, frame, quiet)) {}

    void open_tones_of(const Given& given) {
        if (!given.has("--tones")) return;
        wav_path = given.value("--tones");
        if (wav_path.ends_with(".wav")) {
            wav.emplace(wav_path);
            track.emplace(given.has("--seconds") ? number_value(given, "--seconds", 0, 0, 86'400) : kUnlimited);
            return;
        }
        if (wav_path != "alsa")
            throw Error(Fault::usage, "--tones", phrase("it is alsa, for the loudspeaker, or a file whose name ends in .wav"));
        OpenedTones opened = open_tones();
        heard = opened.note.empty();
        if (heard)
            toning.emplace(std::move(opened.sink));
        else if (!quiet)
            say(opened.note);
    }
};

namespace {

// That can be felt; nullptr: none.
const PlotSurface* surface_under(const Given& given, const Plot& plot) {
    if (plot.surfaces.empty()) return nullptr;
    const auto parts = parts_of(given);
    const bool is_felt = std::any_of(parts.begin(), parts.end(), [](const PlotPart* part) { return part->name == "surface"; });
    return is_felt ? &plot.surfaces.front() : nullptr;
}

}  // namespace

PlotLayers::PlotLayers(const Given& given, const Plot& plot, const PlotFrame& frame, const PlotLayersWish& wish)
    : parts_(std::make_unique<Parts>(given, plot, frame, wish)) {
    Parts& parts = *parts_;
    parts.open_tones_of(given);
    const auto at = [](auto& optional) { return optional ? &*optional : nullptr; };
    parts.scene.emplace(
        parts.guidance,
        KeyedParts{at(parts.speaking), &parts.typed, at(parts.toning), at(parts.track), surface_under(given, plot)}, frame,
        parts.felt);
}

PlotLayers::~PlotLayers() = default;

Scene& PlotLayers::scene() { return *parts_->scene; }
bool PlotLayers::are_heard() const { return parts_->heard; }

void PlotLayers::begin(bool by_wall) {
    if (!by_wall) return;
    parts_->terminal.emplace(parts_->typed);
    if (parts_->terminal->listens() && !parts_->quiet)
        say(phrase("the keyboard has the keys of the arm, too: 1 to {0} and letters; tactics help arms says what they do",
                   std::to_string(kNumberedKeys)));
}

void PlotLayers::finish() {
    Parts& parts = *parts_;
    parts.terminal.reset();
    if (parts.speaking) tell_voice(*parts.speaking, parts.quiet);
    if (parts.toning) {
        parts.toning->finish();
        if (!parts.quiet && !parts.toning->note().empty()) say(parts.toning->note());
    }
    if (!parts.wav) return;
    parts.wav->finish(parts.track->tones());
    if (!parts.quiet && parts.track->lost())
        say(phrase("{0}: only the first {1} s of the tones are in it", parts.wav_path,
                   numeral(static_cast<double>(parts.track->tones().size()) / kTonesPerSecond)));
}

void PlotLayers::tell_ways(const PlayedScene& played, HandReport& report) const {
    std::vector<std::string> ways;
    for (const LeadRecord& way : parts_->guidance.records()) {
        JsonObject json;
        json.add("lead", name_of(way.goal.lead));
        json.add("end", name_of(way.end));
        json.add("curve", static_cast<double>(way.goal.curve) + 1);
        json.add("ticks", static_cast<double>(way.to - way.from));
        json.add("off_mm", way.off);
        const Phrase led = name_of(way.goal.lead), miss = numeral(std::round(way.off / 0.01) * 0.01);
        Phrase line = way.end == LeadEnd::arrived    ? phrase("{0}: the finger arrived {1} mm from where it was led", led, miss)
                      : way.end == LeadEnd::resisted ? phrase("{0}: the finger resisted {1} mm from where it was led", led, miss)
                      : way.end == LeadEnd::left
                          ? phrase("{0}: the finger left {1} mm from where it was led", led, miss)
                          : phrase("{0}: the finger was let go of {1} mm from where it was led", led, miss);
        if (const auto off = off_curve(way, played, parts_->felt)) {
            json.add("rms_mm", off->rms);
            json.add("p95_mm", off->p95);
            line = phrase("{0}, on its way {1} mm off the curve (root of the mean square), 95 % within {2} mm", std::move(line),
                          numeral(std::round(off->rms / 0.01) * 0.01), numeral(std::round(off->p95 / 0.01) * 0.01));
        }
        report.lines.push_back(line);
        ways.push_back(json.text());
    }
    if (!ways.empty()) report.json += (report.json.empty() ? "" : ",") + std::string("\"ways\":") + json_array(ways);
}

}  // namespace tactics
