// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/vrml/x3d_xml.h"

#include <algorithm>
#include <array>
#include <utility>

#include "tactics/error.h"
#include "tactics/readers/xml.h"
#include "tactics/text/number.h"

namespace tactics {

namespace {

using namespace std::string_view_literals;

template <std::size_t N>
bool is_one_of(const std::array<std::string_view, N>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

// The field of the node around it in which a node stands that does not say: the standard has one for each kind.
std::string_view field_for(std::string_view type, std::string_view around) {
    if (type == "Coordinate" || type == "CoordinateDouble" || type == "GeoCoordinate") return "coord";
    if (type == "Appearance") return "appearance";
    if (type.starts_with("Metadata")) return "metadata";
    if (around == "Shape") return "geometry";
    return "children";
}

class XmlReader {
public:
    explicit XmlReader(World& world) : world_(world), builder_(world) {}

    void read(const Element& x3d) {
        for (const Element& part : x3d.children) {
            if (part.name == "head")
                for (const Element& one : part.children) unit(one);
            if (part.name == "Scene")
                for (const Element& one : part.children) statement(one, world_.roots);
        }
    }

private:
    void unit(const Element& element) {
        if (element.name != "unit") return;
        const auto factor = parse_number(element.attribute("conversionFactor"));
        if (!factor || !(*factor > 0)) fail(element, phrase("a unit has no conversionFactor over 0; say how many metres it is"));
        if (element.attribute("category") == "length") world_.metre = *factor;
        if (element.attribute("category") == "angle") world_.radian = *factor;
    }

    [[noreturn]] void fail(const Element& element, const Phrase& why) const {
        builder_.fail(static_cast<int>(element.line), why);
    }

    // Nothing: it is no node.
    bool other_statement(const Element& element) {
        constexpr std::array kOthers{"ROUTE"sv, "IMPORT"sv,     "EXPORT"sv,    "IS"sv,
                                     "field"sv, "fieldValue"sv, "component"sv, "meta"sv};
        const bool external = element.name == "ExternProtoDeclare";
        if (external || element.name == "ProtoDeclare") proto(element, external);
        return external || element.name == "ProtoDeclare" || is_one_of(kOthers, element.name);
    }
    void statement(const Element& element, std::vector<std::uint32_t>& nodes) {
        if (other_statement(element)) return;
        const std::uint32_t made = node(element);  // first: what `nodes` belongs to may move
        nodes.push_back(made);
    }

    std::uint32_t node(const Element& element) {
        const int line = static_cast<int>(element.line);
        if (const std::string_view used = element.attribute("USE"); !used.empty()) return builder_.use(used, line);
        const bool instance = element.name == "ProtoInstance";
        const std::string_view type = instance ? element.attribute("name") : std::string_view(element.name);
        const std::uint32_t place = builder_.begin(type, element.attribute("DEF"), line);
        constexpr std::array kNoFields{"DEF"sv, "USE"sv, "containerField"sv, "class"sv, "id"sv, "style"sv};
        for (const auto& [name, text] : element.attributes)
            if (!is_one_of(kNoFields, name) && !(instance && name == "name") && !is_for_eyes(type, name)) {
                WorldField made = builder_.field(name, line);
                const bool words = name == "name" || name == "description" || name == "url" || name == "title" ||
                                   (name == "value" && type.starts_with("Metadata"));
                value(made.value, text, words);
                builder_.node(place).fields.push_back(std::move(made));
            }
        for (const Element& child : element.children) member(place, child);
        builder_.end();
        return place;
    }

    void member(std::uint32_t place, const Element& child) {
        const int line = static_cast<int>(child.line);
        if (child.name == "IS") {
            for (const Element& connect : child.children) {
                WorldField made = builder_.field(std::string(connect.attribute("nodeField")), line);
                made.value.is = connect.attribute("protoField");
                if (!made.value.is.empty()) builder_.node(place).fields.push_back(std::move(made));
            }
        } else if (child.name == "fieldValue") {
            WorldField made = builder_.field(std::string(child.attribute("name")), line);
            given(made.value, child, "");
            builder_.node(place).fields.push_back(std::move(made));
        } else if (!other_statement(child)) {
            const std::uint32_t made = node(child);
            const std::string_view told = child.attribute("containerField");
            const std::string_view name = told.empty() ? field_for(child.name, builder_.node(place).type) : told;
            constexpr std::array kUsed{"children"sv, "geometry"sv, "coord"sv, "metadata"sv, "choice"sv,
                                       "level"sv,    "skeleton"sv, "shape"sv, "layers"sv};
            if (is_one_of(kUsed, name)) field_in(place, name, line).nodes.push_back(made);
        }
    }

    WorldValue& field_in(std::uint32_t place, std::string_view name, int line) {
        auto& fields = builder_.node(place).fields;
        // Nodes follow attributes and occur in few fields.
        const auto known = std::find_if(fields.rbegin(), fields.rend(), [&](const WorldField& one) { return one.name == name; });
        return known != fields.rend() ? known->value : fields.emplace_back(builder_.field(std::string(name), line)).value;
    }

    // The value of a field of a PROTO: in an attribute, or nodes.
    void given(WorldValue& to, const Element& element, std::string_view type) {
        value(to, element.attribute("value"), type.ends_with("String"));
        for (const Element& child : element.children) statement(child, to.nodes);
    }

    void proto(const Element& element, bool external) {
        const std::uint32_t place = builder_.begin_proto(element.attribute("name"), static_cast<int>(element.line));
        world_.protos[place].external = external;
        for (const Element& part : element.children) {
            if (part.name == "ProtoInterface" && !external)
                for (const Element& field : part.children) {
                    WorldField made = builder_.field(std::string(field.attribute("name")), static_cast<int>(field.line));
                    const bool has_value = field.attribute("value").data() != nullptr || !field.children.empty();
                    given(made.value, field, field.attribute("type"));
                    if (has_value) world_.protos[place].defaults.push_back(std::move(made));
                }
            if (part.name == "ProtoBody") {
                std::vector<std::uint32_t> body;
                for (const Element& one : part.children) statement(one, body);
                world_.protos[place].body = std::move(body);
            }
        }
        builder_.end_proto(place);
    }

    // Numbers and truths if all of it is, else texts: each in quotes, or all as one.
    void value(WorldValue& to, std::string_view text, bool words) {
        constexpr std::string_view kBlanks = " \t\r\n,";
        const std::size_t first = text.find_first_not_of(kBlanks);
        if (first == std::string_view::npos) return;
        if (text[first] == '"') return texts(to, text.substr(first));
        for (std::string_view rest = words ? std::string_view() : text.substr(first); !rest.empty();) {
            const std::string_view one = rest.substr(0, rest.find_first_of(kBlanks));
            const bool yes = one == "true" || one == "TRUE", no = one == "false" || one == "FALSE";
            const auto number = yes || no ? std::optional<double>(yes ? 1 : 0) : parse_number(one);
            if (!number) {
                const bool in_row = !to.numbers.empty();
                world_.numbers -= to.numbers.size();
                to.numbers.clear();
                return builder_.add_word(to, std::string(in_row ? one : text));
            }
            builder_.add_number(to, *number);
            rest.remove_prefix(one.size());
            rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
        }
        if (words) builder_.add_word(to, std::string(text));
    }
    void texts(WorldValue& to, std::string_view text) {
        std::string one;
        bool open = false;
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] == '"') {
                if (open) builder_.add_word(to, std::exchange(one, {}));
                open = !open;
            } else if (open) {
                if (text[i] == '\\' && i + 1 < text.size()) ++i;
                one += text[i];
            }
        }
    }

    World& world_;
    WorldBuilder builder_;
};

}  // namespace

World read_xml_world(std::string_view bytes, const std::string& file) {
    const Element root = parse_xml(bytes, file);
    if (root.name != "X3D") throw Error(Fault::failed, file, phrase("is XML, and no X3D; save the model as X3D or VRML97"));
    World world;
    world.file = file;
    XmlReader(world).read(root);
    return world;
}

}  // namespace tactics
