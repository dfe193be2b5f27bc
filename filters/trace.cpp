// SPDX-License-Identifier: Apache-2.0
// From pixels to lines in millimetres: the middle lines of ink or of edges, or the outlines of black regions.
#include <optional>
#include <stdexcept>
#include <utility>

#include "filters/edge_map.h"
#include "filters/traced.h"
#include "tactics/filter.h"

namespace tactics {

namespace {

constexpr Option kTraceOptions[] = {
    {.name = "method",
     .type = Option::Type::choice,
     .fallback = 0,
     .min = 0,
     .max = 1,
     .summary = "lines: the middle of each line, with dots kept as dots; areas: black regions, filled",
     .choices = "lines areas"},
    {.name = "spur",
     .type = Option::Type::length,
     .fallback = 2,
     .min = 0,
     .max = 50,
     .unit = "mm",
     .summary = "side branches shorter than this are cut off"},
    {.name = "bridge",
     .type = Option::Type::length,
     .fallback = 2,
     .min = 0,
     .max = 20,
     .unit = "mm",
     .summary = "line ends that point at each other over a gap up to this are joined; 0 = none"},
    {.name = "shortest",
     .type = Option::Type::length,
     .fallback = 2,
     .min = 0,
     .max = 100,
     .unit = "mm",
     .summary = "lines shorter and areas smaller than this are left out; from one line to another half of it is enough"},
};

Artwork apply_trace(Artwork artwork, const Settings& settings) {
    const EdgeMap* edges = std::get_if<EdgeMap>(&artwork);
    const bool areas = settings.choice("method") == "areas";
    Image grey;
    EdgeMap ridges;
    if (edges == nullptr) grey = to_grey(std::get<Image>(std::move(artwork)));
    const double scale = edges != nullptr ? edges->mm_per_pixel : grey.mm_per_pixel;
    if (!(scale > 0)) throw std::logic_error("trace needs a picture that has its size in mm");
    const EdgeMap* unthinned = nullptr;
    if (edges != nullptr && !edges->thinned && !areas) {
        ridges = thin_edges(*edges, std::nullopt);
        unthinned = std::exchange(edges, &ridges);
    }
    InkMap ink = edges != nullptr ? ink_of(*edges) : ink_of(grey);

    Drawing drawing;
    drawing.width = ink.width * scale;
    drawing.height = ink.height * scale;
    if (areas)
        for (const Outline& outline : outlines_of(ink)) add_area(drawing, outline, scale, settings.number("shortest"));
    else
        add_lines(drawing, std::move(ink), edges, unthinned, scale,
                  {settings.number("shortest"), settings.number("spur"), settings.number("bridge")});
    return drawing;
}

}  // namespace

extern const Filter trace_filter;
const Filter trace_filter{
    .name = "trace",
    .summary = "turns pixels into lines: the middle of lines and edges, or the outlines of black regions",
    .takes = Kind::picture | Kind::edges,
    .gives = static_cast<Kinds>(Kind::drawing),
    .options = kTraceOptions,
    .apply = apply_trace,
};

}  // namespace tactics
