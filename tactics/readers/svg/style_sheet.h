// SPDX-License-Identifier: Apache-2.0
// The style of each element of an SVG: its attributes, style sheets and gradients.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/readers/svg/svg_style.h"
#include "tactics/readers/xml.h"

namespace tactics {

/// Selectors of tags, classes and ids, alone, together, and one within another ("g.axis > text"); others are counted as missed.
class StyleSheet {
public:
    /// All style elements and gradients of a drawing.
    void know(const Element& root, Missed& missed);
    void add(std::string_view text, Missed& missed);

    /// `parent` must outlive what is given.
    Style style_of(const Element& element, const Style& parent, Missed& missed) const;

private:
    /// "path.thin#main"
    struct Simple {
        std::string tag, id;
        std::vector<std::string> classes;
        bool child = false;  ///< of the element that is told before it; else anywhere within that
        bool fits(const Element& element) const;
    };
    struct Rule {
        std::vector<Simple> parts;  ///< from the outermost
        Declarations declarations;
        int rank = 0;
        std::size_t number = 0;
        bool fits(const Element& element, const Style& parent) const;
    };

    static bool parse(std::string_view selector, Rule& rule);
    void know_styles(const Element& element, Missed& missed);
    void know_gradients(const Element& element);
    std::vector<const Rule*> rules_for(const Element& element, const Style& parent) const;

    std::map<std::string, std::vector<Rule>, std::less<>> rules_;  ///< by what is most particular in their last part
    std::size_t count_ = 0;
    MeanPaints gradients_;
    std::map<std::string, const Element*, std::less<>> gradient_elements_;
};

}  // namespace tactics
