// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/devices/inverse3_messages.h"

#include <rapidjson/document.h>

#include <algorithm>
#include <cmath>

#include "tactics/text/json.h"
#include "tactics/text/number.h"

namespace tactics {

namespace {

using rapidjson::Value;

constexpr double kMostReach = 1000;  // mm; the arm reaches a third of it
constexpr std::size_t kMostId = 64;

// Without recursion: brackets in brackets would fill the stack otherwise. Its values stay in one pool and are dropped as one.
bool parse(rapidjson::Document& document, std::string_view message) {
    if (message.size() > kMostInverseMessage) return false;
    document.Parse<rapidjson::kParseIterativeFlag | rapidjson::kParseValidateEncodingFlag>(message.data(), message.size());
    return !document.HasParseError() && document.IsObject();
}

const Value* member(const Value* of, const char* name) {
    if (of == nullptr || !of->IsObject()) return nullptr;
    const auto found = of->FindMember(name);
    return found == of->MemberEnd() ? nullptr : &found->value;
}

bool is_said(const Value* of, const char* name, bool unsaid) {
    const Value* value = member(of, name);
    return value != nullptr && value->IsBool() ? value->GetBool() : unsaid;
}

std::string_view text_of(const Value* value) {
    return value != nullptr && value->IsString() ? std::string_view(value->GetString(), value->GetStringLength())
                                                 : std::string_view();
}

bool is_id(std::string_view text) {
    return !text.empty() && text.size() <= kMostId && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_';
    });
}

std::optional<double> millimetres(const Value* place, const char* axis) {
    const Value* value = member(place, axis);
    if (value == nullptr || !value->IsNumber()) return std::nullopt;
    const double mm = 1000 * value->GetDouble();
    return std::abs(mm) <= kMostReach ? std::optional(mm) : std::nullopt;
}

std::optional<unsigned> keys_of(const Value* state) {
    if (state == nullptr) return std::nullopt;
    if (const Value* buttons = member(state, "buttons"); buttons != nullptr && buttons->IsObject()) {
        constexpr const char* kLetters[] = {"a", "b", "c"};
        constexpr const char* kNumbers[] = {"button_0", "button_1", "button_2", "button_3"};
        unsigned keys = 0;
        for (unsigned i = 0; i < std::size(kLetters); ++i) keys |= is_said(buttons, kLetters[i], false) ? 1u << i : 0;
        for (unsigned i = 0; i < std::size(kNumbers); ++i) keys |= is_said(buttons, kNumbers[i], false) ? 1u << i : 0;
        return keys;
    }
    if (member(state, "button") != nullptr) return is_said(state, "button", false) ? 1u : 0u;
    return std::nullopt;
}

unsigned keys_of_grips(const Value& message) {
    for (const char* kind : {"wireless_verse_grip", "verse_grip", "custom_verse_grip"}) {
        const Value* grips = member(&message, kind);
        if (grips == nullptr || !grips->IsArray()) continue;
        for (const Value& grip : grips->GetArray())
            if (const auto keys = keys_of(member(&grip, "state"))) return *keys;
    }
    return 0;
}

}  // namespace

std::optional<std::vector<std::string>> inverse3_ids(std::string_view message) {
    rapidjson::Document document;
    if (!parse(document, message)) return std::nullopt;
    std::vector<std::string> ids;
    const Value* devices = member(&document, "inverse3");
    if (devices == nullptr || !devices->IsArray()) return ids;
    for (const Value& device : devices->GetArray())
        if (const std::string_view id = text_of(member(&device, "device_id")); is_id(id)) ids.emplace_back(id);
    return ids;
}

std::optional<ArmWord> inverse3_word(std::string_view message, std::string_view id) {
    rapidjson::Document document;
    if (!parse(document, message)) return std::nullopt;
    const Value* devices = member(&document, "inverse3");
    if (devices == nullptr || !devices->IsArray()) return std::nullopt;
    for (const Value& device : devices->GetArray()) {
        if (text_of(member(&device, "device_id")) != id) continue;
        const Value* place = member(member(&device, "state"), "cursor_position");
        const auto x = millimetres(place, "x"), y = millimetres(place, "y"), z = millimetres(place, "z");
        if (!x || !y || !z) return std::nullopt;
        const Value* status = member(&device, "status");
        const bool well =
            is_said(status, "ready", true) && is_said(status, "calibrated", true) && is_said(status, "power_supply", true);
        return ArmWord{{*x, *z, -*y}, keys_of_grips(document), !well};
    }
    return std::nullopt;
}

std::string inverse3_request(std::string_view id, const Point3& force, bool first) {
    const auto number = [](double value) { return to_text(std::isfinite(value) ? value : 0); };
    std::string text = "{";
    if (first) text += R"("session":{"configure":{"profile":{"name":"tactics"}}},)";
    text += R"("inverse3":[{"device_id":)" + json_text(id) + ",";
    if (first) text += R"("configure":{"preset":{"preset":"arm_front_centered"}},)";
    return text + R"("commands":{"set_cursor_force":{"values":{"x":)" + number(force.x) + R"(,"y":)" + number(-force.z) +
           R"(,"z":)" + number(force.y) + "}}}}]}";
}

}  // namespace tactics
