#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cracksim::io {

struct RawNode;

/// A value of the input with its place in the file. It is valid until its tree is changed or destroyed.
/// Every getter throws InputError "file:line:column: key.path: reason" if the value does not fit the request.
class InputNode {
public:
    enum class Infinity { refused, allowed };

    InputNode(const RawNode& raw, std::string path) : raw_{&raw}, path_{std::move(path)} {}

    /// Throws InputError with place() in front of the text.
    [[noreturn]] void fail(const std::string& why) const;
    /// The start of every message about this value: "file:line:column: key.path: ".
    [[nodiscard]] std::string place() const;

    /// The value as an error message shows it: 'text', "a list", "a map", or "an empty value".
    [[nodiscard]] std::string shown() const;
    /// Key path with dots, list items by index: "supports.0.name"; empty for the root.
    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] bool is_null() const;
    [[nodiscard]] bool is_scalar() const;
    [[nodiscard]] bool is_list() const;
    [[nodiscard]] bool is_map() const;

    /// wanted: the expected value, as an error message names it.
    [[nodiscard]] double number(Infinity infinity = Infinity::refused, const std::string& wanted = "a number") const;
    /// 1e3 is an integer, 1.5 is not.
    [[nodiscard]] std::int64_t integer(std::int64_t least, std::int64_t most) const;
    [[nodiscard]] bool boolean() const;
    [[nodiscard]] std::string text() const;
    /// The text, which must be one of the words.
    [[nodiscard]] std::string word(std::span<const std::string_view> words) const;
    [[nodiscard]] std::vector<InputNode> list() const;
    [[nodiscard]] std::vector<InputNode> list(std::size_t size) const;

    /// Throws InputError unless this value is a map that has no keys other than these.
    void expect_keys(std::span<const std::string_view> keys) const;
    /// The value of a key of this map, if the map has the key.
    [[nodiscard]] std::optional<InputNode> find(std::string_view key) const;
    /// The value of a key of this map. Throws InputError if the key is missing.
    [[nodiscard]] InputNode at(std::string_view key) const;

private:
    const RawNode* raw_;
    std::string path_;
};

/// A scene file as a tree of values. The file is one document of YAML 1.2, of at most 4 MiB of UTF-8, without anchors,
/// aliases, tags and complex keys. The root is a map, keys are unique in their map, values are nested at most 50 deep,
/// and no line is indented by tabs.
class InputTree {
public:
    /// file: the name of the file in messages. Throws InputError.
    InputTree(std::string_view text, std::string file);
    ~InputTree();
    InputTree(InputTree&&) noexcept;
    InputTree& operator=(InputTree&&) noexcept;
    InputTree(const InputTree&) = delete;
    InputTree& operator=(const InputTree&) = delete;

    /// Applies "key.path=value". The value is YAML; an index in the path names a list item: "block.cells.0=5". Missing
    /// keys are created; an index one past the end appends an item. Messages about such a value begin with "--set
    /// key.path". Throws InputError.
    void set(std::string_view setting);

    [[nodiscard]] InputNode root() const;

private:
    std::string file_;
    std::unique_ptr<RawNode> root_;
};

}  // namespace cracksim::io
