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

std::string model_text() {
    std::string lines =
        "A model (VRML, X3D, COLLADA, OBJ, PLY, glTF, STL) is drawn as blind people draw\n"
        "(M. Kurze, 1997): without perspective and with each face in its true shape;\n"
        "parts that cannot be seen from above are folded out beside those that can.\n"
        "Slender parts become lines, laid flat from the place where they are held; flat\n"
        "parts become faces. Anything hidden below a face, as a table top hides its\n"
        "column and foot, hangs from the nearest side of that face. Things that lie on\n"
        "others have thicker lines. A dashed side is shown twice, because the two faces\n"
        "that meet there were folded to different places. A wedge is a line towards you,\n"
        "thick where it is near.\n"
        "\n"
        "Round things are found in meshes, too. They are drawn cut through along their\n"
        "axis; for a cup with a handle, through the handle. A vessel has its opening at\n"
        "one end of this section, a circle, and its bottom at the other, a dashed\n"
        "circle; up to three vessels have braille that says so.\n"
        "\n"
        "The plane of the drawing is that seen from above, unless one seen from the\n"
        "front or, for things that lean, one facing the largest face shows much more.\n"
        "--fold plane=... sets it; the description says which it is.\n"
        "\n"
        "Only faces that a hand can reach are folded: a stove between cupboards shows its\n"
        "top and its front. Parts too small to be felt are hidden and reported; draw\n"
        "such a part alone to feel it: --object Table/Top. Names come from the model,\n"
        "without the additions of exporters: OB_Chair_001/ME_Chair becomes Chair, and\n"
        "table_top becomes two words. --object takes either form.\n"
        "\n"
        "--model views draws the model as seen from above (top), from the front (front),\n"
        "from the right (side) and cut by a plane parallel to the front (section).\n"
        "Outlines have priority; lines that could not be told apart from them are left\n"
        "out.\n"
        "\n"
        "The SVG has a region for each part, which a touch tablet or a screen reader can\n"
        "name. -o desk.txt says where each part lies, what was done with it, and which\n"
        "parts are not drawn and why; -o desk.json has the same for programs, as pages\n"
        "with objects:\n"
        "  name, path: its name, and the form that --object takes\n"
        "  description: how it is drawn, or why it is not drawn\n"
        "  counts: kept (where it is), straightened, folded, lying (laid down), hanging\n"
        "    (from a side, beside what hides it), flattened (laid flat outward), wedges,\n"
        "    doubled (sides shown twice), left_out (faces)\n"
        "  drawn: true or false; if true:\n"
        "  place: in words; x_mm, y_mm: a place well within it, from the left and the top\n"
        "    of the page; left_mm, top_mm, width_mm, height_mm: the box around it\n"
        "\n"
        "Of several ways to fold, tactics draws the one that shows most for the effort\n"
        "it asks of the reader. The cost-... settings say how hard a reader finds each\n"
        "thing; --reader takes a file of such lines, as cost-fold = 0.3. A terrain, one\n"
        "surface without a name, is drawn by its heights; a smooth one in levels\n"
        "(recipe regions).\n"
        "\n"
        "Settings of --fold:\n";
    for (const Option& option : fold_options())
        lines += wrapped(std::string(option.name) + ": " + std::string(option.summary) + " (" + describe_range(option) + ")");
    return lines + "One object takes fold, simplify, flat, slender and hide: \"Table/Top: fold=no\".\n";
}

}  // namespace

extern const Topic model_topic;
const Topic model_topic{"model", "how a 3-D model is drawn, and the settings for it", &model_text};

}  // namespace tactics
