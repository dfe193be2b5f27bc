// SPDX-License-Identifier: Apache-2.0
#include "filters/choose.h"

#include <cmath>
#include <string>

#include "filters/field_levels.h"
#include "filters/flat_regions.h"
#include "filters/pale_strokes.h"
#include "filters/traits.h"

namespace tactics {

namespace {

// What is drawn has parts of one colour with steps between them; photographs have shades of many. A scan or a camera adds
// grain, blur and uneven light to both, so these are taken off first. The limits were set by tests/bench/choice on the even half
// of its pictures and half of the training pictures of BSDS500, and tried on the odd half.
//
// Soft places, neither plain nor an edge, part them best: of photographs as taken 27 % or more of the places are soft in 19 of
// 20, of maps and charts, scanned or not, at most 24 %. The steps tell, too: 22 % and more of those in three of four maps, icons
// and flags stand between plain parts, in photographs 5 to 19 %. Alone they take 10 and 25 of 100 for the wrong kind, together 8.
constexpr double kSoftOfClear = 0.75;
// A scan blurs the borders of provinces: 27 of 100 scanned maps are taken for photographs without this line, 13 with it, and one
// photograph more of 100 for a map.
constexpr double kHardlySoft = 0.17, kSomeClear = 0.1;
// Lines have no plain part beside them, but few colours, one of them the ground.
constexpr double kFewSoft = 0.26, kFewGround = 0.3, kDrawnFew = 0.845;
// Night is dark, too, and softer than nearly all charts on dark ground: 14 of 100 photographs with half of their levels black are
// taken for charts with this line, 25 without.
constexpr double kDarkSoft = 0.17;
// A grey photograph has fewer colours than the same in colour (0.79 in the eight commonest, and 0.63).
constexpr double kGreyGround = 0.52, kGreyFew = 0.88;
// A panel on paper has half of the ground, or more; together they are as much as a ground of charts. Without this line four of
// 130 charts and scans and four of 152 drawings in ink or shaded are taken for photographs; it takes no photograph for a drawing.
constexpr double kPaper = 0.7, kPaperFew = 0.87, kPaperSoft = 0.33;
// Very few colours on white: small icons, soft all over as their borders are, and shaded ones. 45 of 100 of the latter are told
// by it, 33 without, and hardly any photograph.
constexpr double kVeryFew = 0.92, kIconSoft = 0.4;
// Dense hatches on white have many greys when the picture is reduced, but hardly a soft place. Of the 2,079 pictures of
// tests/bench/choice this line changes none.
constexpr double kHatchedFew = 0.8, kHatchedSoft = 0.13;
// A dense grid leaves no plain parts either, and hardly another colour than its own and the ground's.
constexpr double kNearlyAll = 0.97;
// Pale maps of streets and blocks are all soft. This line takes one photograph more of 100 for a map.
constexpr double kPaleClear = 0.17;
constexpr double kFewOfGrain = 0.01;  // a level; colours that grain has spread are gathered wider, in photographs, too
// Flat art is drawn best by `diagram`, as are charts: both sides of every colour's border, small parts, too. `map` gives the
// larger parts; `photo` breaks outlines and leaves parts out, `regions` fills the small ones, and `line-art` takes all that is
// dark for a line. So only what is coloured all over is a map: charts and icons stand on one ground, which is white for most.
constexpr double kMapColour = 0.1;
constexpr double kWhiteGround = 0.4, kGround = 0.5;
constexpr double kRim = 0.8;  // or one colour is all around it: of 54 charts 4 are taken for maps without this, none with it
constexpr double kInkGround = 0.7;
constexpr double kInkFlat = 0.4;
constexpr double kInkColour = 0.1;
constexpr double kInkThick = 0.02;  // nearly all of the ink is lines
// Boxes painted in a pale colour are no ink, and no recipe for ink draws them. Of 36 graphs 20 have 0.2 % or more, the others
// none.
constexpr double kPainted = 0.001;
constexpr int kInkRange = 64;  // less is no ink on paper
// Longer sides of lines that one cut loses: of 84 figures of lines three had 2.5 to 9.6, the others less than this.
constexpr double kPaleStrokes = 0.9;

// A second look, for maps in plain colours, is taken at what may be one. 19 of 20 photographs are softer, and a chart has more
// ground; of a scan the uneven light makes regions of the ground, and its grain says that it is one.
constexpr double kMapSoft = 0.25, kMapGround = 0.85, kMapNoise = 0.6;

std::string percent(double share) { return std::to_string(static_cast<int>(std::lround(100 * share))); }

}  // namespace

Choice choose_recipe(const Image& picture) {
    if (const Phrase field = levels_told(picture); !field.empty()) return {"levels", field};
    const Traits traits = traits_of(picture);
    const Phrase ground = phrase("{0} % is one ground", percent(traits.ground)),
                 seen = phrase("{0} % flat, {1} % soft, eight colours cover {2} %, {3} % of steps clear", percent(traits.flat),
                               percent(traits.soft), percent(traits.few), percent(traits.clear));
    const bool paper = traits.lightest && traits.range >= kInkRange && traits.ground >= kInkGround && traits.flat >= kInkFlat;
    if (paper && traits.colourful < kInkColour && traits.thick <= kInkThick) {
        if (traits.painted >= kPainted) return {"diagram", phrase("drawn: {0}, {1}", ground, seen)};
        if (pale_strokes(picture) >= kPaleStrokes) return {"diagram", phrase("pale lines beside dark ones: {0}", ground)};
        return {"line-art", phrase("dark lines: {0}", ground)};
    }
    const bool colourful = traits.colourful >= kMapColour;
    const bool few = traits.few >= (colourful ? kDrawnFew : kGreyFew) + kFewOfGrain * traits.noise &&
                     traits.ground >= (colourful ? kFewGround : kGreyGround);
    const bool parts =
        traits.soft < kSoftOfClear * traits.clear || (colourful && traits.soft <= kHardlySoft && traits.clear >= kSomeClear);
    const bool lines =
        few && traits.soft <= (traits.darkest ? kDarkSoft : kFewSoft) && (traits.lightest || traits.darkest || colourful);
    const bool panels =
        traits.paper >= kPaper && traits.few >= kPaperFew + kFewOfGrain * traits.noise && traits.soft <= kPaperSoft;
    const double least = (traits.soft <= kIconSoft ? kVeryFew : kNearlyAll) + kFewOfGrain * traits.noise;
    const bool bare = traits.lightest && traits.few >= least && traits.ground >= kFewGround;
    const bool pale = few && colourful && traits.clear >= kPaleClear;
    const bool hatched = traits.lightest && traits.ground >= kGreyGround && traits.soft <= kHatchedSoft &&
                         traits.few >= kHatchedFew + kFewOfGrain * traits.noise;
    const bool drawn = parts || lines || panels || bare || hatched;
    if (traits.noise <= kMapNoise && traits.soft <= kMapSoft && traits.ground <= kMapGround &&
        is_coloured_map(map_traits_of(picture)))
        return {"borders", phrase("a map in plain colours: {0}", seen)};
    const bool stands = traits.rim >= kRim || traits.ground >= (traits.lightest ? kWhiteGround : kGround);
    if (drawn && (stands || !colourful)) return {"diagram", phrase("drawn: {0}, {1}", ground, seen)};
    if (drawn || pale) return {"map", phrase("coloured regions: {0}", seen)};
    return {"photo", phrase("continuous tones: {0}", seen)};
}

}  // namespace tactics
