// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/vrml/model_maker.h"

#include <algorithm>
#include <utility>

#include "tactics/error.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr std::size_t kMostSteps = 1'000'000'000;  // some seconds
constexpr std::size_t kMostKinds = 20;             // of what is left out

bool is_utf8(std::string_view bytes) {
    while (!bytes.empty())
        if (take_letter(bytes) == kNoLetter) return false;
    return true;
}

// Writers of old times had the letters of western Europe.
std::string from_latin1(std::string_view bytes) {
    std::string text;
    for (const char byte : bytes) append_letter(text, static_cast<unsigned char>(byte));
    return text;
}

std::string cut_to(std::string text, std::size_t most) {
    if (text.size() <= most) return text;
    while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
    text.resize(most);
    return text;
}

}  // namespace

void ModelMaker::fail(int line, const Phrase& why) const { throw Error(Fault::failed, file_ + ":" + std::to_string(line), why); }

void ModelMaker::spend(std::size_t steps, int line) {
    steps_ += steps;
    if (steps_ > kMostSteps)
        fail(line, phrase("what is used again and again (USE, PROTO) grows beyond all bounds; save the model with less of it"));
}

void ModelMaker::leave_out(const std::string& what, int line, std::size_t times) {
    const auto known = std::find_if(left_.begin(), left_.end(), [&](const Left& left) { return left.what == what; });
    if (known != left_.end())
        known->times += times;
    else if (left_.size() < kMostKinds)
        left_.push_back({what, line, times});
    else
        others_ += times;
}

bool ModelMaker::has_size(std::string_view type, int line, std::initializer_list<double> lengths) {
    const bool all = std::all_of(lengths.begin(), lengths.end(), [](double length) { return length > 0; });
    if (!all) leave_out(std::string(type) + " with a size that is not over 0", line);
    return all;
}

bool ModelMaker::has_sides(std::string_view type, int line, const Point3& size) {
    const bool below = size.x < 0 || size.y < 0 || size.z < 0;
    return has_size(type, line, {below ? -1 : size.x + size.y, size.y + size.z, size.z + size.x});
}

std::string ModelMaker::name_of(std::string_view bytes, int line) {
    std::string name(bytes);
    if (!is_utf8(bytes)) {
        if (latin1_ == 0) latin1_ = line;
        name = from_latin1(bytes);
    }
    return cut_to(to_line(name), kMostModelName);
}

ModelObject& ModelMaker::add_object(std::string name, int line) {
    if (model_.objects.size() >= kMostModelObjects)
        fail(line, phrase("the model has over {0} parts; join some, or save a part of it", std::to_string(kMostModelObjects)));
    ModelObject& object = model_.objects.emplace_back();
    object.name = std::move(name);
    object.line = line;
    object.parent = open_.empty() ? -1 : open_.back();
    object.first = static_cast<std::uint32_t>(model_.faces.size());
    weak_.push_back(false);
    return object;
}

void ModelMaker::set_title(std::string_view title, int line) {
    if (model_.title.empty()) model_.title = name_of(title, line);
}

void ModelMaker::set_viewed_from(const Point3& direction) {
    if (model_.viewed_from == Point3{} && is_finite(direction)) model_.viewed_from = unit(direction);
}

void ModelMaker::begin_object(std::string_view name, int line) {
    add_object(name_of(name, line), line);
    open_.push_back(static_cast<int>(model_.objects.size() - 1));
}

// An empty group is no object. An unnamed thing alone in its group is the same object as the group.
void ModelMaker::end_object() {
    const auto place = static_cast<std::size_t>(open_.back());
    open_.pop_back();
    if (place + 1 == model_.objects.size()) {
        model_.objects.pop_back();
        weak_.pop_back();
    } else if (place + 2 == model_.objects.size() && (model_.objects.back().name.empty() || weak_.back())) {
        ModelObject& group = model_.objects[place];
        ModelObject alone = std::move(model_.objects.back());
        alone.name = std::move(group.name);
        alone.parent = group.parent;
        group = std::move(alone);
        model_.objects.pop_back();
        weak_.pop_back();
    }
}

void ModelMaker::add_shape(const WorldShape& shape, const Placing& placing, std::string_view name, bool weak, int line) {
    constexpr std::size_t kPlacing = 10;  // steps
    spend(kPlacing * (shape.corners.size() + shape.vertices.size()), line);
    if (shape.bad_faces > 0)
        leave_out("faces without area, with fewer than 3 corners or with a corner that is not there", line, shape.bad_faces);
    if (shape.faces.empty()) return;
    if (model_.corners.size() + shape.corners.size() > kMostModelCorners ||
        model_.vertices.size() + shape.vertices.size() > kMostModelCorners)
        fail(line, phrase("the model has over {0} corners of faces; save a coarser one", std::to_string(kMostModelCorners)));
    ModelObject& object = add_object(name_of(name, line), line);
    weak_.back() = weak;
    const auto first_vertex = static_cast<std::uint32_t>(model_.vertices.size()),
               first_corner = static_cast<std::uint32_t>(model_.corners.size());
    for (const Point3& vertex : shape.vertices) {
        model_.vertices.push_back(placing(vertex));
        if (!is_finite(model_.vertices.back()))
            fail(line, phrase("a corner is too far away to be a number; save the model again"));
    }
    for (const std::uint32_t corner : shape.corners) model_.corners.push_back(first_vertex + corner);
    for (const ModelFace& face : shape.faces) {
        model_.faces.push_back({first_corner + face.first, face.count});
        // Else a mirrored shape would look inwards.
        if (placing.mirrors()) {
            const auto corner = model_.corners.begin() + model_.faces.back().first;
            std::reverse(corner, corner + face.count);
        }
    }
    object.count = static_cast<std::uint32_t>(shape.faces.size());
    object.primitive = shape.primitive;
    object.one_sided = shape.one_sided;
    if (shape.primitive != Primitive::none)
        object.frame = {placing(shape.frame.middle), placing.direction(shape.frame.a), placing.direction(shape.frame.b),
                        placing.direction(shape.frame.c)};
}

Model ModelMaker::finish(std::vector<Phrase>& notes) {
    model_.up = UpAxis::y;
    Phrase all;
    for (const Left& left : left_) {
        const Phrase where = phrase("line {0}", std::to_string(left.line));
        notes.push_back(phrases(left.times, "left out: {1} ({2})", "left out: {1} ({0} times, first in {2})", left.what, where));
        all = all.empty() ? notes.back() : phrase("{0}; {1}", std::move(all), notes.back());
    }
    if (others_ > 0) notes.push_back(phrase("left out: {0} more of other kinds", std::to_string(others_)));
    if (latin1_ > 0) notes.push_back(phrase("names that are not UTF-8 are taken as Latin-1 (line {0})", std::to_string(latin1_)));
    if (model_.faces.empty())
        throw Error(Fault::failed, file_,
                    all.empty() ? phrase("has no faces; save the model again with its surface")
                                : phrase("has no faces; save the model again with its surface; {0}", all));
    return std::move(model_);
}

}  // namespace tactics
