// SPDX-License-Identifier: Apache-2.0
// A Model that grows while a world is walked through, within its limits.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/model.h"
#include "tactics/readers/vrml/placing.h"
#include "tactics/readers/vrml/shape.h"
#include "tactics/text/phrase.h"

namespace tactics {

class ModelMaker {
public:
    explicit ModelMaker(std::string file) : file_(std::move(file)) {}

    /// Everything made before its end is part of it. `name`: bytes of the file.
    void begin_object(std::string_view name, int line);
    void end_object();
    bool in_object() const { return !open_.empty(); }

    /// Title of the whole model; the first one counts.
    void set_title(std::string_view title, int line);
    /// The direction to a viewpoint; the first one counts.
    void set_viewed_from(const Point3& direction);

    /// `weak`: the name is one for want of a better.
    void add_shape(const WorldShape& shape, const Placing& placing, std::string_view name, bool weak, int line);

    /// Told once for all of the same words: "3 times, first in line 7".
    void leave_out(const std::string& what, int line, std::size_t times = 1);

    /// Lengths that must be over 0. If one is not, that is noted of the node.
    bool has_size(std::string_view type, int line, std::initializer_list<double> lengths);
    /// For a box, of which one length may be 0.
    bool has_sides(std::string_view type, int line, const Point3& size);

    /// Each step costs; a small file may ask for endless ones. Throws Error(failed) when they are too many.
    void spend(std::size_t steps, int line);
    [[noreturn]] void fail(int line, const Phrase& why) const;

    /// Throws Error(failed) if nothing was made.
    Model finish(std::vector<Phrase>& notes);

private:
    struct Left {
        std::string what;
        int line = 0;
        std::size_t times = 0;
    };
    std::string name_of(std::string_view bytes, int line);
    ModelObject& add_object(std::string name, int line);

    std::string file_;
    Model model_;
    std::vector<int> open_;
    std::vector<bool> weak_;  // as many as there are objects
    std::vector<Left> left_;
    std::size_t others_ = 0;  // beyond what `left_` may have
    int latin1_ = 0;          // line of the first name that is not UTF-8
    std::size_t steps_ = 0;
};

}  // namespace tactics
