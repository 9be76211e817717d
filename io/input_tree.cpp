#include "io/input_tree.hpp"

#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "core/errors.hpp"
#include "io/input_text.hpp"
#include "io/number_text.hpp"
#include "io/yaml_events.hpp"

namespace cracksim::io {

namespace {

using Kind = RawNode::Kind;

/// Names the first line with an odd number of quotes, where the user may find a quote that is not closed.
std::string where_quotes_are_odd(std::string_view text, const TextSource& source) {
    std::size_t line = 1;
    bool odd = false;
    for (std::size_t i = 0; i < text.size() && !(odd && text[i] == '\n'); ++i) {
        line += text[i] == '\n' ? 1U : 0U;
        odd ^= text[i] == '"';
    }
    return odd && source.has_lines ? "; the quotes of line " + std::to_string(line) + " do not pair" : "";
}

/// Explains a parser error to a user who does not know yaml-cpp.
[[noreturn]] void refuse(const YAML::Exception& error, const InputBuilder& builder, const std::string& about_quotes) {
    if (error.msg == YAML::ErrorMsg::UNKNOWN_ANCHOR) {
        builder.refuse_anchor(error.mark);
    }
    if (error.msg == YAML::ErrorMsg::END_OF_SEQ_FLOW || error.msg == YAML::ErrorMsg::END_OF_MAP_FLOW) {
        builder.refuse_open_bracket();
    }
    if (error.msg == YAML::ErrorMsg::EOF_IN_SCALAR) {
        throw InputError{
            builder.at(error.mark) +
            ": the text ends inside a quote; close it where it should end, or remove the quote that is one "
            "too many" +
            about_quotes};
    }
    if (error.msg == YAML::ErrorMsg::FLOW_END) {
        throw InputError{builder.at(error.mark) +
                         ": this closing bracket is one too many, or one before it is missing or of the other kind"};
    }
    throw InputError{builder.at(error.mark) + ": not valid YAML: " + shortened(error.msg) +
                     "; check brackets, colons and indentation here and just before, and put expressions in quotes"};
}

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
        refuse(error, builder, where_quotes_are_odd(text, source));
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
