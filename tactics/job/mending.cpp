// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/mending.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tactics/error.h"
#include "tactics/layout/place.h"
#include "tactics/text/table.h"

namespace tactics {

namespace {

bool is_legible(const MendingTold& told) { return told.complete && told.broken_after == 0 && told.kept >= kLegible; }

// The result for the same drawing in a larger size; nothing if there is no such sheet.
double kept_on(Sheet sheet, const Drawing& drawing, Tiles tiles) {
    sheet.tiles = tiles;
    try {
        const Rect place = place_on(sheet, drawing.width / drawing.height).drawing;
        const Repaired larger = repair(scaled_to(drawing, place.width), *sheet.medium);
        return larger.complete && larger.broken_after == 0 ? larger.kept : 0;
    } catch (const Error&) {
        return 0;
    }
}

// With more places than this the trials would take long, and little comes of them.
constexpr std::size_t kMostTried = 1000;

// Split it, enlarge it, or say it in words.
Phrase advice_for(const Sheet& sheet, const Drawing& drawing, const MendingTold& told, bool finer) {
    const Phrase words =
        phrase("draw a part of it with {0} \"crop ...\", or describe it instead: tactics describe", spelled("filter"));
    Phrase text =
        told.complete
            ? phrase("too much is too close for a finger in this size; {0} of its lines are left", percent(told.kept))
            : phrase("there is far more in it than this size has room for; {0} of its lines are left", percent(told.kept));
    if (told.broken_after > 0)
        text = phrases(told.broken_after, "{1} and {0} place still breaks a hard rule",
                       "{1} and {0} places still break a hard rule", std::move(text));
    if (sheet.drawing_width || sheet.real_width)
        return phrase("{0}. Draw it larger ({1}, {2}), {3}", text, spelled("width"), spelled("scale"), words);
    if (sheet.tiles.several() || sheet.bare || told.broken_before > kMostTried)
        return phrase("{0}. A larger page may help; else {1}", text, words);
    if (finer)
        return phrase("{0}. More sheets ({1} 2x2) may help, though more is drawn on them, too; else {2}", text, spelled("tiles"),
                      words);
    for (const int sheets : {2, 3})
        if (const double kept = kept_on(sheet, drawing, {sheets, sheets}); kept >= kLegible)
            return phrase("{0}. On {1} sheets ({2} {1}) {3} would be; else {4}", text,
                          std::to_string(sheets) + "x" + std::to_string(sheets), spelled("tiles"), percent(kept), words);
    return phrase("{0}. Nine sheets ({1} 3x3) help little; {2}", text, spelled("tiles"), words);
}

// Lines found in a photograph that are this short on average, as a share of the drawing's side, are pieces of fur, leaves or
// waves rather than outlines of things. Of 100 photographs on A4 (tactics evaluate --study repair, recipe photo) 9 are such:
// their F against what people drew is 0.33, that of the others 0.52.
constexpr double kShareOfPieces = 0.09;
constexpr std::size_t kFewLines = 8;

Phrase advice_for_pieces(const Drawing& drawing) {
    const std::size_t count = drawing.strokes.size();
    const bool seen =
        std::any_of(drawing.strokes.begin(), drawing.strokes.end(), [](const Stroke& stroke) { return stroke.strength > 0; });
    if (!seen || count <= kFewLines) return {};
    const double mean = total_stroke_length(drawing) / static_cast<double>(count);
    if (mean >= kShareOfPieces * std::sqrt(drawing.width * drawing.height)) return {};
    return phrase(
        "its {0} lines are short pieces, {1} mm on average, which seldom show what is depicted; take a picture with a "
        "calmer ground, draw a part of it with {2} \"crop ...\", or describe it instead: tactics describe",
        std::to_string(count), std::to_string(std::lround(mean)), spelled("filter"));
}

// Pages with less expected agreement are reported. Chosen on BSDS500's 200 photographs for training and every second of its 100
// for validation, to maximise the F measure of reported pages against pages that are poor by people's contours (is_poor): 33 and
// 20 pages are reported, 19 of the 37 and 9 of the 11 poor ones among them; with 0.58 it is 15 and 12, with 8 and 5, with 0.66 69
// and 22, with 25 and 9. See tactics evaluate --study page --json.
constexpr double kDoubt = 0.62;

// To a twentieth: finer is not known.
std::string about(double share) { return percent(std::round(share * 20) / 20); }

Phrase doubt_about(const Trust& trust) {
    return phrase(
        "probably not fit to be handed out as it is: about {0} of its line is what people would draw, and about {1} of what "
        "they would draw is on it; draw a box around what matters ({2} 20%,30%-70%,90%), draw another part of the "
        "picture with {3} \"crop ...\", or describe it instead: tactics describe",
        about(trust.line), about(trust.found), spelled("subject"), spelled("filter"));
}

}  // namespace

bool is_doubtful(const std::optional<Trust>& trust) { return trust && trust->agreement() < kDoubt; }

Mended mend_for(const Medium& medium, double width, Drawing drawing, bool as_drawn) {
    drawing = scaled_to(std::move(drawing), width);
    Mended mended;
    mended.told.trust = drawing.trust;
    if (is_doubtful(drawing.trust)) mended.told.doubt = doubt_about(*drawing.trust);
    if (as_drawn) {
        cut_dashes(drawing, medium);
        mended.drawing = std::move(drawing);
        return mended;
    }
    Drawing before = drawing;
    Repaired repaired = repair(std::move(drawing), medium);
    mended.told.measured = true;
    mended.told.complete = repaired.complete;
    mended.told.notes = notes_of(repaired);
    mended.told.broken_before = repaired.broken_before;
    mended.told.broken_after = repaired.broken_after;
    mended.told.kept = repaired.kept;
    mended.told.changes = std::move(repaired.changes);
    mended.drawing = std::move(repaired.drawing);
    if (!is_legible(mended.told)) mended.before = std::move(before);
    return mended;
}

void advise(const Sheet& sheet, Mended& mended, bool finer) {
    MendingTold& told = mended.told;
    if (!told.measured || !told.advice.empty()) return;
    if (!is_legible(told))
        told.advice = advice_for(sheet, mended.before, told, finer);
    else if (!told.trust)  // the filter gave no estimate
        told.advice = advice_for_pieces(mended.drawing);
}

}  // namespace tactics
