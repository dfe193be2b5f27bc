// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/vrml/classic.h"

#include <algorithm>
#include <array>
#include <utility>

#include "tactics/readers/vrml/lexer.h"
#include "tactics/text/utf8.h"

namespace tactics {

namespace {

using namespace std::string_view_literals;
using Kind = WorldToken::Kind;

bool is_access(std::string_view word) {
    constexpr std::array kWords{"field"sv,          "exposedField"sv, "eventIn"sv,   "eventOut"sv,
                                "initializeOnly"sv, "inputOutput"sv,  "inputOnly"sv, "outputOnly"sv};
    return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

bool has_value(std::string_view access) {
    return access == "field" || access == "exposedField" || access == "initializeOnly" || access == "inputOutput";
}

class ClassicReader {
public:
    ClassicReader(std::string_view bytes, World& world)
        : lexer_(bytes, world.dialect == World::Dialect::vrml1, world.file), world_(world), builder_(world) {}

    void read() {
        while (lexer_.peek().kind != Kind::end) statement(world_.roots);
    }

private:
    bool is_vrml1() const { return world_.dialect == World::Dialect::vrml1; }

    [[noreturn]] void unexpected(const WorldToken& token, const std::string& wanted) const {
        if (token.kind == Kind::end)
            lexer_.fail(token.line, phrase("the file ends where {0} should stand; get a complete copy of it", wanted));
        lexer_.fail(token.line, phrase("\"{0}\" stands where {1} should; save the model again, or take this out",
                                       beginning_of(to_line(token.text)), wanted));
    }
    void expect(char mark) {
        const WorldToken token = lexer_.next();
        if (!token.is(mark)) unexpected(token, std::string("\"") + mark + '"');
    }
    // Names of things: some writers have numbers there.
    std::string_view name() {
        const WorldToken token = lexer_.next();
        if (token.kind != Kind::word && token.kind != Kind::number) unexpected(token, "a name");
        return token.text;
    }

    // A node into `nodes`, or a statement that is none.
    void statement(std::vector<std::uint32_t>& nodes) {
        const WorldToken token = lexer_.next();
        if (token.kind != Kind::word) unexpected(token, "a node");
        if (other_statement(token)) return;
        // Read first: what `nodes` belongs to may move.
        const std::uint32_t made = node(token);
        nodes.push_back(made);
    }

    bool other_statement(const WorldToken& token) {
        if (is_vrml1()) return false;
        if (token.text == "PROTO" || token.text == "EXTERNPROTO") {
            proto(token.text == "EXTERNPROTO");
        } else if (token.text == "ROUTE") {
            for (int i = 0; i < 3; ++i) name();  // FROM.field TO NODE.field
        } else if (lexer_.peek().is('{')) {
            return false;
        } else if (token.text == "PROFILE") {
            name();
        } else if (token.text == "COMPONENT") {  // NAME:LEVEL, with blanks perhaps
            while (lexer_.peek().line == token.line && lexer_.peek().kind != Kind::end) lexer_.next();
        } else if (token.text == "META") {
            for (int i = 0; i < 2; ++i) lexer_.next();
        } else if (token.text == "UNIT") {
            unit();
        } else if (token.text == "IMPORT" || token.text == "EXPORT") {
            name();
            if (!lexer_.peek().is_word("AS")) return true;
            for (int i = 0; i < 2; ++i) name();
        } else {
            return false;
        }
        return true;
    }

    // UNIT length inch 0.0254: ISO/IEC 19775-1, 7.2.5.3.
    void unit() {
        const std::string category(name());
        name();
        const WorldToken factor = lexer_.next();
        if (factor.kind != Kind::number || !(factor.number > 0)) unexpected(factor, "how large the unit is");
        if (category == "length") world_.metre = factor.number;
        if (category == "angle") world_.radian = factor.number;
    }

    std::uint32_t node(WorldToken type) {
        if (type.text == "USE") return builder_.use(name(), type.line);
        std::string_view own_name;
        if (type.text == "DEF") {
            own_name = name();
            type = lexer_.next();
        }
        if (type.kind != Kind::word) unexpected(type, "the kind of a node");
        expect('{');
        const std::uint32_t place = builder_.begin(type.text, own_name, type.line);
        while (!lexer_.peek().is('}')) member(place);
        lexer_.next();
        builder_.end();
        return place;
    }

    // A field of the node, or a node in it.
    void member(std::uint32_t place) {
        const WorldToken token = lexer_.next();
        if (token.kind != Kind::word) unexpected(token, "a field of " + builder_.node(place).type);
        const WorldToken after = lexer_.peek();
        const bool is_node = token.text == "DEF" || token.text == "USE" || after.is('{');
        if (is_node) {
            const std::uint32_t child = node(token);
            builder_.node(place).children.push_back(child);
        } else if (is_access(token.text) && (after.text.starts_with("SF") || after.text.starts_with("MF"))) {
            own_field(token.text);
        } else if (!other_statement(token)) {
            WorldField made = builder_.field(std::string(token.text), token.line);
            value(made.value, !is_for_eyes(builder_.node(place).type, token.text));
            builder_.node(place).fields.push_back(std::move(made));
        }
    }

    // The declarations of a script, all ignored.
    void own_field(std::string_view access) {
        name();
        name();
        if (!has_value(access) && !lexer_.peek().is_word("IS")) return;
        WorldValue unwanted;
        unwanted.line = lexer_.peek().line;
        value(unwanted, false);
    }

    // Without the types of fields, what stands there tells how far a value goes: "[" to "]", or all numbers in a row, or one
    // thing.
    void value(WorldValue& to, bool kept) {
        const WorldToken first = lexer_.next();
        if (first.is('[')) {
            while (!lexer_.peek().is(']')) {
                const WorldToken token = lexer_.next();
                if (token.kind == Kind::end)
                    lexer_.fail(first.line, phrase("\"[\" is never closed; get a complete copy of the file"));
                element(to, token, kept);
            }
            lexer_.next();
        } else if (is_vrml1() && first.is('(')) {
            for (WorldToken token = lexer_.next(); !token.is(')'); token = lexer_.next()) {
                if (token.is('|')) continue;
                if (token.kind != Kind::word) unexpected(token, "a word or \")\"");
                builder_.add_word(to, std::string(token.text));
            }
        } else if (first.is_word("IS") && !is_vrml1()) {
            to.is = name();
        } else {
            element(to, first, kept);
            while (first.kind == Kind::number && lexer_.peek().kind == Kind::number) element(to, lexer_.next(), kept);
        }
    }

    void element(WorldValue& to, const WorldToken& token, bool kept) {
        if (token.kind == Kind::number) {
            if (kept) builder_.add_number(to, token.number);
        } else if (token.kind == Kind::text) {
            if (kept) builder_.add_word(to, unquoted(token.text));
        } else if (token.kind != Kind::word) {
            unexpected(token, "a value");
        } else if (!is_vrml1() && (token.text == "PROTO" || token.text == "EXTERNPROTO" || token.text == "ROUTE")) {
            other_statement(token);  // among nodes
        } else if (token.text == "TRUE" || token.text == "true") {
            builder_.add_number(to, 1);
        } else if (token.text == "FALSE" || token.text == "false") {
            builder_.add_number(to, 0);
        } else if (token.text == "DEF" || token.text == "USE" || lexer_.peek().is('{')) {
            to.nodes.push_back(node(token));
        } else if (token.text != "NULL") {
            builder_.add_word(to, std::string(token.text));
        }
    }

    void proto(bool external) {
        const int line = lexer_.peek().line;
        const std::uint32_t place = builder_.begin_proto(name(), line);
        world_.protos[place].external = external;
        expect('[');
        while (!lexer_.peek().is(']')) interface_field(place);
        lexer_.next();
        if (external) {
            WorldValue elsewhere;
            value(elsewhere, false);
        } else {
            expect('{');
            std::vector<std::uint32_t> body;
            while (!lexer_.peek().is('}')) statement(body);
            lexer_.next();
            world_.protos[place].body = std::move(body);
        }
        builder_.end_proto(place);
    }

    void interface_field(std::uint32_t place) {
        const WorldToken access = lexer_.next();
        if (access.kind != Kind::word || !is_access(access.text)) unexpected(access, "a field of the PROTO");
        name();
        WorldField made = builder_.field(std::string(name()), access.line);
        if (!has_value(access.text) || world_.protos[place].external) return;
        value(made.value, true);
        world_.protos[place].defaults.push_back(std::move(made));
    }

    WorldLexer lexer_;
    World& world_;
    WorldBuilder builder_;
};

}  // namespace

World read_classic_world(std::string_view bytes, const std::string& file) {
    if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
    World world;
    world.file = file;
    const std::string_view head = bytes.substr(std::min(bytes.find('#'), bytes.size()));
    const bool old = head.starts_with("#VRML V1") || head.starts_with("#Inventor");
    world.dialect = old ? World::Dialect::vrml1 : World::Dialect::vrml97;
    ClassicReader(bytes, world).read();
    return world;
}

}  // namespace tactics
