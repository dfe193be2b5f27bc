// SPDX-License-Identifier: Apache-2.0
// `tactics help model`: how a model becomes a drawing, and the settings of --fold.
#include "cli/help/topics.h"
#include "tactics/solid/fold_options.h"
#include "tactics/text/words.h"

namespace tactics {

namespace {

constexpr std::size_t kColumns = 80;

// Words in lines of at most 80 characters, those after the first set in.
std::string wrapped(const std::string& text) {
    std::string lines;
    std::size_t column = 0;
    for (const std::string_view word : words_of(text)) {
        if (column > 0 && column + 1 + word.size() > kColumns) {
            lines += "\n    ";
            column = 4;
        } else if (column > 0) {
            lines += ' ';
            ++column;
        } else {
            lines += "  ";
            column = 2;
        }
        lines += word;
        column += word.size();
    }
    return lines + "\n";
}

std::string text() {
    std::string lines =
        "A model (VRML, X3D, COLLADA, OBJ, PLY, glTF, STL) is drawn as blind people draw\n"
        "(M. Kurze, 1997): without perspective, each face in its true shape, what cannot\n"
        "be seen from above folded out beside what can. Slender parts become lines and\n"
        "are laid flat from where they are held; flat ones become faces. What a face\n"
        "hides below it, as a table top hides its column and its foot, hangs from the\n"
        "nearest side of that face. A vessel is a U: it is open where it has no line.\n"
        "What lies on something has thicker lines. A side that is shown twice, as two\n"
        "faces that meet there were folded to different places, is dashed. A wedge is a\n"
        "line towards you, thick where it is near.\n"
        "\n"
        "Only faces that a hand can reach are folded: a stove between cupboards shows its\n"
        "top and its front. What is too small to be felt is hidden and told; draw a part\n"
        "alone to feel it: --object Table/Top. Names are those of the model without what\n"
        "exporters add: OB_Chair_001/ME_Chair is called Chair, table_top is two words,\n"
        "and --object takes either.\n"
        "\n"
        "--model views draws it as it is seen from above (top), from the front (front),\n"
        "from the right (side) and as a plane parallel to the front cuts it (section).\n"
        "Outlines come first; lines that could not be told from them are left out.\n"
        "\n"
        "The SVG has a region for each part, which a touch tablet or a screen reader\n"
        "names. -o desk.txt says where each part lies, what was done with it, and what is\n"
        "not drawn and why; -o desk.json has the same for programs, as pages with objects:\n"
        "  name, path: what it is called, and what --object takes\n"
        "  description: how it is drawn, or why it is not\n"
        "  counts: kept (where it is), straightened, folded, lying (laid down), flattened\n"
        "    (laid flat outward), wedges, doubled (sides shown twice), left_out (faces)\n"
        "  drawn: true or false; if true:\n"
        "  place: in words; x_mm, y_mm: a place well within it, from the left and the top\n"
        "    of the page; left_mm, top_mm, width_mm, height_mm: the box around it\n"
        "\n"
        "Of several ways to fold the one is drawn that shows most for what it asks of the\n"
        "reader. How hard a reader finds what is in cost-...; a file of such lines, as\n"
        "cost-fold = 0.3, is given as --reader. A terrain, one surface without a name, is\n"
        "drawn by its heights.\n"
        "\n"
        "Settings of --fold:\n";
    for (const Option& option : fold_options())
        lines += wrapped(std::string(option.name) + ": " + std::string(option.summary) + " (" + describe_range(option) + ")");
    return lines +
           "Of one object, \"Table/Top: fold=no\", there are fold, simplify, flat, slender and\n"
           "hide.\n";
}

}  // namespace

extern const Topic model_topic;
const Topic model_topic{"model", "how a model in space is drawn, and the settings of that", &text};

}  // namespace tactics
