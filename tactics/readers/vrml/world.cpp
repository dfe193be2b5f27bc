// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/vrml/world.h"

#include <algorithm>
#include <array>

#include "tactics/error.h"

namespace tactics {

namespace {

using namespace std::string_view_literals;

std::string millions(std::size_t count) { return std::to_string(count / 1'000'000) + " million"; }

}  // namespace

const WorldValue* field_of(const WorldNode& node, std::string_view name) {
    for (const WorldField& field : node.fields)
        if (field.name == name) return &field.value;
    return nullptr;
}

bool is_for_eyes(std::string_view type, std::string_view field) {
    constexpr std::array kTypes{"Normal"sv, "TextureCoordinate"sv, "TextureCoordinate2"sv,
                                "Color"sv,  "ColorRGBA"sv,         "PixelTexture"sv};
    constexpr std::array kFields{"normalIndex"sv, "texCoordIndex"sv, "textureCoordIndex"sv, "colorIndex"sv, "materialIndex"sv,
                                 "image"sv,       "key"sv,           "keyValue"sv};
    return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end() ||
           std::find(kFields.begin(), kFields.end(), field) != kFields.end();
}

void WorldBuilder::fail(int line, const Phrase& why) const {
    throw Error(Fault::failed, world_.file + ":" + std::to_string(line), why);
}

void WorldBuilder::count(int line) {
    if (++world_.items > kMostWorldItems)
        fail(line, phrase("the file has over {0} nodes, fields and texts; save a simpler model", millions(kMostWorldItems)));
}

std::uint32_t WorldBuilder::begin(std::string_view type, std::string_view name, int line) {
    count(line);
    if (open_.size() >= static_cast<std::size_t>(kMostWorldDepth))
        fail(line, phrase("nodes are nested over {0} deep; save the model with fewer groups in groups",
                          std::to_string(kMostWorldDepth)));
    const auto place = static_cast<std::uint32_t>(world_.nodes.size());
    WorldNode& made = world_.nodes.emplace_back();
    made.type = type;
    made.name = name;
    made.line = line;
    for (auto scope = scopes_.rbegin(); scope != scopes_.rend() && made.proto < 0; ++scope)
        if (const auto found = scope->protos.find(type); found != scope->protos.end())
            made.proto = static_cast<int>(found->second);
    if (!name.empty()) scopes_.back().nodes.insert_or_assign(made.name, place);
    open_.push_back(place);
    return place;
}

void WorldBuilder::end() { open_.pop_back(); }

std::uint32_t WorldBuilder::use(std::string_view name, int line) {
    count(line);
    const auto place = static_cast<std::uint32_t>(world_.nodes.size());
    WorldNode& made = world_.nodes.emplace_back();
    made.name = name;
    made.line = line;
    const auto found = scopes_.back().nodes.find(name);
    made.undefined = found == scopes_.back().nodes.end();
    if (made.undefined) return place;
    made.use = static_cast<int>(found->second);
    made.within_itself = std::find(open_.begin(), open_.end(), found->second) != open_.end();
    return place;
}

void WorldBuilder::add_number(WorldValue& value, double number) {
    if (++world_.numbers > kMostWorldNumbers)
        fail(value.line, phrase("the file has over {0} numbers; save a coarser model", millions(kMostWorldNumbers)));
    value.numbers.push_back(number);
}

void WorldBuilder::add_word(WorldValue& value, std::string word) {
    count(value.line);
    value.words.push_back(std::move(word));
}

WorldField WorldBuilder::field(std::string name, int line) {
    count(line);
    WorldField made{std::move(name), {}};
    made.value.line = line;
    return made;
}

std::uint32_t WorldBuilder::begin_proto(std::string_view name, int line) {
    count(line);
    if (scopes_.size() > static_cast<std::size_t>(kMostWorldDepth))
        fail(line, phrase("PROTOs are nested over {0} deep; save the model without them", std::to_string(kMostWorldDepth)));
    world_.protos.push_back({std::string(name), line, false, {}, {}});
    scopes_.emplace_back();
    return static_cast<std::uint32_t>(world_.protos.size() - 1);
}

void WorldBuilder::end_proto(std::uint32_t place) {
    scopes_.pop_back();
    scopes_.back().protos.insert_or_assign(world_.protos[place].name, place);
}

}  // namespace tactics
