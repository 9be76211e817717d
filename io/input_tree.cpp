#include "io/input_tree.hpp"

#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "core/contracts.hpp"
#include "core/errors.hpp"
#include "io/input_builder.hpp"
#include "io/input_text.hpp"
#include "io/nearest.hpp"
#include "io/number_text.hpp"

namespace cracksim::io {

namespace {

using Kind = RawNode::Kind;

RawNode parse_yaml(std::string_view bytes, const TextSource& source) {
    const std::string text = checked_text(bytes, source);
    RawNode root;
    InputBuilder builder{root, source};
    std::istringstream stream{text};
    try {
        YAML::Parser parser{stream};
        while (parser.HandleNextDocument(builder)) {
        }
    } catch (const YAML::Exception& error) {
        if (error.msg == YAML::ErrorMsg::UNKNOWN_ANCHOR) {
            builder.refuse_anchor(error.mark);
        }
        if (error.msg == YAML::ErrorMsg::END_OF_SEQ_FLOW || error.msg == YAML::ErrorMsg::END_OF_MAP_FLOW) {
            builder.refuse_open_bracket();
        }
        if (error.msg == YAML::ErrorMsg::EOF_IN_SCALAR) {
            throw InputError{builder.at(error.mark) + ": the text ends inside a quote; close it where it should end"};
        }
        throw InputError{
            builder.at(error.mark) + ": not valid YAML: " + shortened(error.msg) +
            "; check brackets, colons and indentation here and just before, and put expressions in quotes"};
    }
    return root;
}

RawNode make_child(std::string key, const std::string& place) {
    RawNode child;
    child.place = place;
    child.key = std::move(key);
    child.key_place = place;
    return child;
}

RawNode& item_of_list(RawNode& list, const std::string& index, const std::string& place) {
    const auto i = to_integer(index);
    const auto size = static_cast<std::int64_t>(list.children.size());
    if (!i || *i < 0 || *i > size) {
        throw InputError{place + ": '" + shortened(index) + "' is not an item of a list of " + std::to_string(size) +
                         "; items count from 0, and " + std::to_string(size) + " appends one"};
    }
    if (*i == size) {
        list.children.push_back(make_child("", place));
    }
    return list.children[static_cast<std::size_t>(*i)];
}

RawNode& child_for(RawNode& node, const std::string& key, const std::string& place) {
    if (node.kind == Kind::scalar) {
        throw InputError{place + ": there is no '" + shortened(key) + "' to set in the plain value '" +
                         shortened(node.text) + "'; set the whole value"};
    }
    if (node.kind == Kind::list) {
        return item_of_list(node, key, place);
    }
    node.kind = Kind::map;
    const auto found = std::ranges::find(node.children, key, &RawNode::key);
    return found != node.children.end() ? *found : node.children.emplace_back(make_child(key, place));
}

std::vector<std::string> split_path(std::string_view path) {
    std::vector<std::string> keys;
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('.', begin), path.size());
        keys.emplace_back(path.substr(begin, end - begin));
        begin = end + 1;
    }
    return keys;
}

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
    if (const auto value = to_number(text)) {
        return *value;
    }
    const auto infinite = to_infinity(text);
    if (infinite && infinity == Infinity::allowed) {
        return *infinite;
    }
    const char* hint = infinite                                   ? "; it must be finite"
                       : is_beyond_range(text)                    ? "; numbers reach from 2.3e-308 to 1.7e308"
                       : text.find(',') != std::string_view::npos ? "; the decimal sign is a point"
                                                                  : "";
    fail("needs " + wanted + ", not " + shown() + hint);
}

std::int64_t InputNode::integer(std::int64_t least, std::int64_t most) const {
    const auto value = is_scalar() ? to_integer(raw_->text) : std::nullopt;
    if (!value || *value < least || *value > most) {
        fail("needs an integer from " + std::to_string(least) + " to " + std::to_string(most) + ", not " + shown());
    }
    return *value;
}

bool InputNode::boolean() const {
    if (!is_scalar() || (raw_->text != "true" && raw_->text != "false")) {
        fail("needs true or false, not " + shown());
    }
    return raw_->text == "true";
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

InputTree::InputTree(std::string_view text, std::string file) : file_{std::move(file)} {
    root_ = std::make_unique<RawNode>(parse_yaml(text, {file_, true}));
    if (root_->kind == Kind::null) {
        throw InputError{file_ + ": is empty; a scene needs at least block, material or network, and time"};
    }
    if (root_->kind != Kind::map) {
        root().fail("a scene is a map of keys such as 'block:' and 'time:', not " + root().shown());
    }
}

InputTree::~InputTree() = default;
InputTree::InputTree(InputTree&&) noexcept = default;
InputTree& InputTree::operator=(InputTree&&) noexcept = default;

void InputTree::set(std::string_view setting) {
    const std::size_t equals = setting.find('=');
    const std::string path{setting.substr(0, equals)};
    const std::string place = "--set " + shortened(path);
    const auto keys = split_path(path);
    if (equals == std::string_view::npos || std::ranges::find(keys, "") != keys.end()) {
        throw InputError{"--set: needs the form key.path=value, such as time.end=0.5, not '" + shortened(setting) +
                         "'"};
    }
    if (keys.size() > InputBuilder::deepest) {
        throw InputError{place + ": no key of a scene is that deep"};
    }
    RawNode value = parse_yaml(setting.substr(equals + 1), {place, false});
    RawNode* node = root_.get();
    for (const std::string& key : keys) {
        node = &child_for(*node, key, place);
    }
    value.key = std::move(node->key);
    value.key_place = place;
    value.place = place;
    *node = std::move(value);
}

InputNode InputTree::root() const { return {*root_, ""}; }

}  // namespace cracksim::io
