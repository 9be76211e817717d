#include <algorithm>

#include "core/contracts.hpp"
#include "core/errors.hpp"
#include "io/input_text.hpp"
#include "io/input_tree.hpp"
#include "io/number_text.hpp"
#include "io/spelling.hpp"
#include "io/yaml_events.hpp"

namespace cracksim::io {

namespace {

using Kind = RawNode::Kind;

/// Appended to a message about a number, true or false that is a text only because it is in quotes.
constexpr const char* in_quotes = " as a text; remove the quotes";

}  // namespace

void InputNode::fail(const std::string& why) const { throw InputError{place() + why}; }

std::string InputNode::place() const {
    const bool setting_says_path = path_.empty() || raw_->place == "--set " + path_;
    return raw_->place + ": " + (setting_says_path ? "" : path_ + ": ");
}

std::string InputNode::shown() const {
    switch (raw_->kind) {
        case Kind::list: return "a list";
        case Kind::map: return "a map";
        case Kind::null: return "an empty value";
        case Kind::scalar: break;
    }
    return "'" + shortened(raw_->text) + "'";
}

bool InputNode::is_null() const { return raw_->kind == Kind::null; }
bool InputNode::is_scalar() const { return raw_->kind == Kind::scalar; }
bool InputNode::is_list() const { return raw_->kind == Kind::list; }
bool InputNode::is_map() const { return raw_->kind == Kind::map; }

double InputNode::number(Infinity infinity, const std::string& wanted) const {
    const std::string_view text = is_scalar() ? std::string_view{raw_->text} : std::string_view{};
    const bool may_be_infinite = infinity == Infinity::allowed;
    const auto value = may_be_infinite && to_infinity(text) ? to_infinity(text) : to_number(text);
    if (!value || raw_->quoted) {
        fail("needs " + wanted + ", not " + shown() + (value ? in_quotes : number_hint(text, may_be_infinite)));
    }
    return *value;
}

std::int64_t InputNode::integer(std::int64_t least, std::int64_t most) const {
    const auto value = is_scalar() ? to_integer(raw_->text) : std::nullopt;
    if (!value || *value < least || *value > most || raw_->quoted) {
        fail("needs an integer from " + std::to_string(least) + " to " + std::to_string(most) + ", not " + shown() +
             (value && raw_->quoted ? in_quotes : ""));
    }
    return *value;
}

bool InputNode::boolean() const {
    const std::string text = is_scalar() ? raw_->text : "";
    const bool is_true = text == "true" || text == "True" || text == "TRUE";
    const bool is_value = is_true || text == "false" || text == "False" || text == "FALSE";
    if (!is_value || raw_->quoted) {
        fail("needs true or false, not " + shown() + (is_value ? in_quotes : ""));
    }
    return is_true;
}

std::string InputNode::text() const {
    if (!is_scalar()) {
        fail("needs a text, not " + shown());
    }
    return raw_->text;
}

std::string InputNode::word(std::span<const std::string_view> words) const {
    if (!is_scalar()) {
        fail((words.size() > 1 ? "needs one of " : "needs ") + listed(words) + ", not " + shown());
    }
    if (std::ranges::find(words, raw_->text) == words.end()) {
        fail("does not know " + shown() + "; " +
             suggestion(raw_->text, words, words.size() > 1 ? "take one of" : "take"));
    }
    return raw_->text;
}

std::vector<InputNode> InputNode::list() const {
    if (!is_list()) {
        fail("needs a list, not " + shown());
    }
    std::vector<InputNode> items;
    for (const RawNode& child : raw_->children) {
        items.emplace_back(child, path_ + "." + std::to_string(items.size()));
    }
    return items;
}

std::vector<InputNode> InputNode::list(std::size_t size) const {
    if (!is_list() || raw_->children.size() != size) {
        const bool too_many = is_list() && raw_->children.size() > size;
        fail("needs a list of " + std::to_string(size) + " values, not " +
             (is_list() ? "of " + std::to_string(raw_->children.size()) : shown()) +
             (too_many ? "; put an expression that holds commas in quotes" : ""));
    }
    return list();
}

void InputNode::expect_keys(std::span<const std::string_view> keys) const {
    if (!is_map()) {
        fail("needs a map with keys of " + listed(keys) + ", not " + shown());
    }
    for (const RawNode& child : raw_->children) {
        if (std::ranges::find(keys, child.key) == keys.end()) {
            RawNode at_key;
            at_key.place = child.key_place;
            InputNode{at_key, (path_.empty() ? "" : path_ + ".") + shortened(child.key)}.fail(
                "unknown key; " + suggestion(child.key, keys, "known here are"));
        }
    }
}

std::optional<InputNode> InputNode::find(std::string_view key) const {
    CRACKSIM_EXPECT(is_map());
    const auto found = std::ranges::find(raw_->children, key, &RawNode::key);
    if (found == raw_->children.end()) {
        return std::nullopt;
    }
    return InputNode{*found, (path_.empty() ? "" : path_ + ".") + std::string{key}};
}

InputNode InputNode::at(std::string_view key) const {
    const auto found = find(key);
    if (!found) {
        fail("the key '" + std::string{key} + "' is missing; add it (inputs/README.md lists what it takes)");
    }
    return *found;
}

}  // namespace cracksim::io
