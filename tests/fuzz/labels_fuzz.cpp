// SPDX-License-Identifier: Apache-2.0
// Any bytes as a file of labels: places and words or one line of what is wrong, and what can be set stands on the page.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <set>

#include "tactics/error.h"
#include "tactics/job/placed_words.h"
#include "tactics/layout/lay_out.h"
#include "tactics/text/utf8.h"
#include "tactics/units.h"

namespace {

using namespace tactics;

void require(bool holds) {
    if (!holds) std::abort();
}

Drawing drawing_of_lines() {
    Drawing drawing;
    drawing.width = 150;
    drawing.height = 100;
    drawing.strokes = {{{{10, 10}, {140, 90}}}, {{{20, 80}, {70, 20}, {120, 80}}, true}};
    drawing.areas = {{{{{60, 60}, {80, 60}, {80, 75}, {60, 75}}}}};
    return drawing;
}

// Each name is on the page, in its words or with a key, or the page is refused.
void set(Drawing drawing, std::vector<Name> names) {
    constexpr std::size_t kMost = 6;  // more would only take longer
    if (names.size() > kMost) names.resize(kMost);
    std::multiset<std::string> wanted;
    for (const Name& name : names)
        if (std::string line = to_line(name.text); !line.empty()) wanted.insert(std::move(line));
    drawing.names = std::move(names);
    Sheet sheet;
    sheet.paper = Paper{"a5", "", 148, 210};
    sheet.medium = &media()[0];
    const Pages pages = pages_of(drawing, sheet);
    std::multiset<std::string> found;
    for (const PageName& name : pages.all.front().names) found.insert(name.text);
    require(found == wanted && pages.all.front().left_out.empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = size == 0 ? std::string_view() : std::string_view(reinterpret_cast<const char*>(data), size);
    try {
        const std::vector<PlacedWords> labels = parse_labels(text, "fuzzed.labels");
        require(labels.size() <= kMostLabels);
        for (const PlacedWords& label : labels) {
            require(label.x >= 0 && label.y >= 0 && std::isfinite(label.x) && std::isfinite(label.y) && !label.text.empty());
            require(!label.share || (label.x <= 1 && label.y <= 1));
        }
        check_subject(parse_subject(text, "fuzzed.labels", {}));
        const Drawing drawing = drawing_of_lines();
        check_places(labels, drawing.width, drawing.height);
        set(drawing, names_on(drawing, labels));
    } catch (const Error& error) {
        require(error.what()[0] != '\0');
    }
    return 0;
}
