#pragma once

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/mark.h>

#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/errors.hpp"
#include "io/input_text.hpp"

namespace cracksim::io {

/// A value as it is written in the text. Maps and lists have children; the children of a map have keys.
struct RawNode {
    enum class Kind { null, scalar, list, map };

    Kind kind{Kind::null};
    std::string place;
    std::string key;
    std::string key_place;
    std::string text;
    bool quoted{false};
    std::vector<RawNode> children;
};

/// Builds a tree from the parser's events and refuses YAML features that a scene does not use. yaml-cpp's own nodes are
/// not used, because they lose duplicate keys and the places of empty values, and because nesting is limited here
/// before it can overflow the stack.
class InputBuilder : public YAML::EventHandler {
public:
    static constexpr std::size_t deepest = 50;

    InputBuilder(RawNode& root, TextSource source) : root_{&root}, source_{std::move(source)} {}

    [[nodiscard]] std::string at(const YAML::Mark& mark) const {
        const auto counted = [](int from_0) { return static_cast<std::size_t>(from_0) + 1; };
        return mark.is_null() ? source_.name : source_.at(counted(mark.line), counted(mark.column));
    }

    void OnDocumentStart(const YAML::Mark& mark) override {
        if (documents_++ > 0) {
            throw InputError{at(mark) +
                             (source_.has_lines
                                  ? ": a second document begins here; a scene is one document: remove '---' or '...'"
                                  : ": the value ends and something follows; remove a quote or bracket that is one "
                                    "too many, or put the whole value in quotes")};
        }
    }
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        scalar(mark, "", anchor, RawNode::Kind::null, "");
    }
    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& value) override {
        scalar(mark, tag, anchor, RawNode::Kind::scalar, value);
    }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t /*anchor*/) override { refuse_anchor(mark); }
    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value /*style*/) override {
        open(mark, tag, anchor, RawNode::Kind::list);
    }
    void OnSequenceEnd() override { open_.pop_back(); }
    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value /*style*/) override {
        open(mark, tag, anchor, RawNode::Kind::map);
    }
    void OnMapEnd() override { open_.pop_back(); }

    [[noreturn]] void refuse_anchor(const YAML::Mark& mark) const {
        throw InputError{
            at(mark) +
            ": YAML anchors and aliases (&name, *name) are not taken; write the value out, and put an expression "
            "that begins with * or & in quotes"};
    }

    /// Reports an unclosed bracket at the place where it opens: the parser's mark is not the place where the user must
    /// look.
    [[noreturn]] void refuse_open_bracket() const {
        throw InputError{(open_.empty() ? source_.name : open_.back().place) +
                         ": the bracket that opens here is not closed, or an expression in it needs quotes"};
    }

private:
    struct Open {
        RawNode* node;
        std::string place;
        bool has_key{false};
        std::string key;
        std::string key_place;
        std::unordered_map<std::string, std::string> places_of_keys;
    };

    [[nodiscard]] bool expects_key() const {
        return !open_.empty() && open_.back().node->kind == RawNode::Kind::map && !open_.back().has_key;
    }

    void check(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) const {
        if (anchor != 0) {
            refuse_anchor(mark);
        }
        if (!tag.empty() && tag != "?" && tag != "!") {
            throw InputError{at(mark) + ": YAML tags ('" + shortened(tag) +
                             "') are not taken; write the value without a tag"};
        }
    }

    void scalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, RawNode::Kind kind,
                const std::string& text) {
        check(mark, tag, anchor);
        if (!expects_key()) {
            RawNode& node = add(mark, kind);
            node.text = text;
            node.quoted = tag == "!";
        } else if (kind == RawNode::Kind::null) {
            throw InputError{at(mark) + ": a key is missing before ':'"};
        } else {
            set_key(mark, text);
        }
    }

    void set_key(const YAML::Mark& mark, const std::string& key) {
        Open& map = open_.back();
        const auto [first, is_new] = map.places_of_keys.try_emplace(key, at(mark));
        if (!is_new) {
            throw InputError{at(mark) + ": the key '" + shortened(key) + "' was given already at " + first->second +
                             "; remove one of the two"};
        }
        map.has_key = true;
        map.key = key;
        map.key_place = at(mark);
    }

    RawNode& add(const YAML::Mark& mark, RawNode::Kind kind) {
        RawNode node;
        node.kind = kind;
        node.place = at(mark);
        if (open_.empty()) {
            *root_ = std::move(node);
            return *root_;
        }
        Open& parent = open_.back();
        if (parent.node->kind == RawNode::Kind::map) {
            node.key = std::move(parent.key);
            node.key_place = std::move(parent.key_place);
            parent.has_key = false;
            // An empty value, or a map that begins on the next line, is easiest to find at its key.
            node.place = kind == RawNode::Kind::scalar ? node.place : node.key_place;
        }
        parent.node->children.push_back(std::move(node));
        return parent.node->children.back();
    }

    void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, RawNode::Kind kind) {
        check(mark, tag, anchor);
        if (expects_key()) {
            throw InputError{
                at(mark) + ": a key must be plain text, not a list or a map; is a bracket open that should be closed?"};
        }
        if (open_.size() >= deepest) {
            throw InputError{at(mark) + ": nested deeper than " + std::to_string(deepest) +
                             " levels; a scene needs fewer than 10"};
        }
        RawNode& node = add(mark, kind);
        open_.push_back(Open{&node, at(mark), false, "", "", {}});
    }

    RawNode* root_;
    TextSource source_;
    int documents_{0};
    std::vector<Open> open_;
};

}  // namespace cracksim::io
