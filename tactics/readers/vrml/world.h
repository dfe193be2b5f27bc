// SPDX-License-Identifier: Apache-2.0
// A VRML or X3D file ("world") as its nodes, whatever its syntax, before anything is made of them.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/text/phrase.h"

namespace tactics {

// Limits of a file. Each node, each field and each word of text is an item.
inline constexpr std::size_t kMostWorldBytes = 256u << 20;  ///< unpacked
inline constexpr std::size_t kMostWorldItems = 2'000'000;
inline constexpr std::size_t kMostWorldNumbers = 50'000'000;
inline constexpr int kMostWorldDepth = 256;  ///< of nodes in nodes

struct WorldValue {
    int line = 0;
    std::vector<double> numbers;  ///< finite; TRUE is 1, FALSE 0
    std::vector<std::string> words;
    std::vector<std::uint32_t> nodes;  ///< places in World::nodes
    std::string is;                    ///< the value is that of this field of the PROTO around it
};

struct WorldField {
    std::string name;
    WorldValue value;
};

struct WorldNode {
    std::string type;
    std::string name;  ///< by DEF; bytes of the file
    int line = 0;
    std::vector<WorldField> fields;
    std::vector<std::uint32_t> children;  ///< those that stand in no field, as all do in VRML 1.0
    int use = -1;                         ///< place of the node that stands here again; then this one has nothing of its own
    int proto = -1;                       ///< place in World::protos of what it is made after
    bool within_itself = false;           ///< a USE in the very node that it names
    bool undefined = false;               ///< a USE of nothing
};

/// PROTO, or EXTERNPROTO, whose body is in another file.
struct WorldProto {
    std::string name;
    int line = 0;
    bool external = false;
    std::vector<WorldField> defaults;
    std::vector<std::uint32_t> body;  ///< the first represents the whole
};

struct World {
    enum class Dialect : std::uint8_t { vrml1, vrml97 };  ///< X3D is as VRML97
    Dialect dialect = Dialect::vrml97;
    std::string file;  ///< for messages
    std::vector<WorldNode> nodes;
    std::vector<WorldProto> protos;
    std::vector<std::uint32_t> roots;
    double metre = 1;       ///< a unit of length, in metres
    double radian = 1;      ///< a unit of angles, in radians
    std::size_t items = 0;  ///< so far
    std::size_t numbers = 0;
};

/// Nothing: the node has no such field of its own.
const WorldValue* field_of(const WorldNode& node, std::string_view name);

/// Numbers that no surface depends on (colours, normals, places in pictures, movements) need not be kept.
bool is_for_eyes(std::string_view type, std::string_view field);

/// Fills a World within its limits, for every reader. Throws Error(failed) at FILE:LINE if one is passed.
class WorldBuilder {
public:
    explicit WorldBuilder(World& world) : world_(world), scopes_(1) {}

    /// A node within those that were begun and not ended. Its name is known from here on.
    std::uint32_t begin(std::string_view type, std::string_view name, int line);
    void end();
    /// Adds a reference that uses a named node again.
    std::uint32_t use(std::string_view name, int line);
    WorldNode& node(std::uint32_t place) { return world_.nodes[place]; }

    void add_number(WorldValue& value, double number);
    void add_word(WorldValue& value, std::string word);
    WorldField field(std::string name, int line);

    /// A PROTO sees the PROTOs around it and names of its own; it is itself seen from its end on.
    std::uint32_t begin_proto(std::string_view name, int line);
    void end_proto(std::uint32_t place);

    [[noreturn]] void fail(int line, const Phrase& why) const;

private:
    struct Scope {
        std::map<std::string, std::uint32_t, std::less<>> nodes, protos;
    };
    void count(int line);

    World& world_;
    std::vector<Scope> scopes_;
    std::vector<std::uint32_t> open_;
};

}  // namespace tactics
