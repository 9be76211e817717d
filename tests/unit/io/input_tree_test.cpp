#include "io/input_tree.hpp"

#include <gtest/gtest.h>

#include <array>
#include <clocale>
#include <limits>

#include "core/errors.hpp"

namespace cracksim::io {
namespace {

using Infinity = InputNode::Infinity;

template <class Action>
std::string message(Action&& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

std::string parsing(const std::string& text) {
    return message([&] { InputTree(text, "a.yaml"); });
}

std::string setting(const std::string& text, const std::string& value) {
    return message([&] { InputTree(text, "a.yaml").set(value); });
}

template <class Getter>
std::string getting(const std::string& value, Getter&& getter) {
    const InputTree tree{"b:\n  k: " + value + "\n", "a.yaml"};
    return message([&] { getter(tree.root().at("b").at("k")); });
}

double number(const std::string& value, Infinity infinity = Infinity::refused) {
    const InputTree tree{"k: " + value, "a.yaml"};
    return tree.root().at("k").number(infinity);
}

std::int64_t integer(const std::string& value) {
    const InputTree tree{"k: " + value, "a.yaml"};
    return tree.root().at("k").integer(std::numeric_limits<std::int64_t>::min(),
                                       std::numeric_limits<std::int64_t>::max());
}

TEST(InputTree, HoldsMapsListsAndPlainValues) {
    const InputTree tree{"# a comment\na: {b: [1, two, null], c: \"x: y\"}\n", "a.yaml"};
    const InputNode a = tree.root().at("a");
    const auto items = a.at("b").list(3);
    EXPECT_EQ(items[0].integer(0, 9), 1);
    EXPECT_EQ(items[1].text(), "two");
    EXPECT_TRUE(items[2].is_null());
    EXPECT_EQ(a.at("c").text(), "x: y");
    EXPECT_EQ(items[1].path(), "a.b.1");
    EXPECT_FALSE(a.find("d").has_value());
}

TEST(InputTree, TakesWindowsLineEndsAndByteOrderMarks) {
    const InputTree tree{
        "\xEF\xBB\xBF"
        "a: 1\r\nb: 2\r\n",
        "a.yaml"};
    EXPECT_EQ(tree.root().at("b").text(), "2");
}

TEST(InputTree, KnowsAKeyAmongLookalikes) {
    const std::array<std::string_view, 3> keys{"cells", "edge", "origin"};
    const auto unknown = [&](const std::string& text) {
        return message([&] { InputTree(text, "a.yaml").root().at("block").expect_keys(keys); });
    };
    EXPECT_EQ(unknown("block:\n  edge: 1\n  cels: 2\n"), "a.yaml:3:3: block.cels: unknown key; did you mean 'cells'?");
    EXPECT_EQ(unknown("block:\n  - edge\n"),
              "a.yaml:1:1: block: needs a map with keys of cells, edge, origin, not a list");
    EXPECT_EQ(unknown("block: {threshold: 1}"),
              "a.yaml:1:9: block.threshold: unknown key; known here are cells, edge, origin");
    EXPECT_EQ(unknown("block: {edge: 1, cells: 2}"), "no error");
}

TEST(InputTree, NamesTheMissingKey) {
    EXPECT_EQ(
        message([] { static_cast<void>(InputTree("x: 1\ntime:\n  step: 1\n", "a.yaml").root().at("time").at("end")); }),
        "a.yaml:2:1: time: the key 'end' is missing; add it (inputs/README.md lists what it takes)");
}

TEST(InputTree, RefusesWhatIsNotOneYamlMap) {
    const std::string empty = "a.yaml: is empty; a scene needs at least block, material or network, and time";
    EXPECT_EQ(parsing(""), empty);
    EXPECT_EQ(parsing("# nothing\n\n"), empty);
    EXPECT_EQ(parsing("---\n"), empty);
    EXPECT_EQ(parsing("- 1\n- 2\n"), "a.yaml:1:1: a scene is a map of keys such as 'block:' and 'time:', not a list");
    EXPECT_EQ(parsing("block"), "a.yaml:1:1: a scene is a map of keys such as 'block:' and 'time:', not 'block'");
    EXPECT_EQ(parsing("a: 1\n---\nb: 2\n"),
              "a.yaml:2:1: a second document begins here; a scene is one document: remove '---' or '...'");
    EXPECT_EQ(parsing("a: 1\n...\nb: 2\n"),
              "a.yaml:3:1: a second document begins here; a scene is one document: remove '---' or '...'");
}

TEST(InputTree, RefusesDuplicateKeys) {
    EXPECT_EQ(parsing("a:\n  b: 1\n  c: 2\n  b: 3\n"),
              "a.yaml:4:3: the key 'b' was given already at a.yaml:2:3; remove one of the two");
    EXPECT_EQ(parsing("{a: 1, a: 1}"),
              "a.yaml:1:8: the key 'a' was given already at a.yaml:1:2; remove one of the two");
    EXPECT_EQ(parsing("a: {k: 1}\nb: {k: 1}\n"), "no error");
}

TEST(InputTree, RefusesAnchorsTagsAndStrangeKeys) {
    const std::string anchors =
        ": YAML anchors and aliases (&name, *name) are not taken; write the value out, and put an expression that "
        "begins with * or & "
        "in quotes";
    EXPECT_EQ(parsing("a: &x 1\n"), "a.yaml:1:4" + anchors);
    EXPECT_EQ(parsing("a: *x\n"), "a.yaml:1:4" + anchors);
    EXPECT_EQ(parsing("a: &x [1]\nb: *x\n"), "a.yaml:1:4" + anchors);
    EXPECT_EQ(parsing("a: !!float 1\n"),
              "a.yaml:1:4: YAML tags ('tag:yaml.org,2002:float') are not taken; write the value without a tag");
    EXPECT_EQ(parsing("? [a]\n: 1\n"),
              "a.yaml:1:3: a key must be plain text, not a list or a map; is a bracket open that should be closed?");
    EXPECT_EQ(parsing("null: 1\n"), "a.yaml:1:1: a key is missing before ':'");
}

TEST(InputTree, RefusesWhatIsNotText) {
    EXPECT_EQ(parsing(std::string{"a: \0 1", 6}), "a.yaml:1:4: the byte 0x00 is not text; a scene is YAML in UTF-8");
    EXPECT_EQ(parsing("a: 1\nb: \xff\n"), "a.yaml:2:4: the byte 0xFF is not text; a scene is YAML in UTF-8");
    EXPECT_EQ(parsing("a: \xc3"), "a.yaml:1:4: the byte 0xC3 is not text; a scene is YAML in UTF-8");
    EXPECT_EQ(parsing("\x89HDF\r\n\x1a\n"), "a.yaml:1:1: the byte 0x89 is not text; a scene is YAML in UTF-8");
    EXPECT_EQ(parsing("a: 1\x04"), "a.yaml:1:5: the control character 0x04 has no place in a scene; remove it");
    EXPECT_EQ(parsing("a: \xc3\xa9t\xc3\xa9"), "no error");
    EXPECT_EQ(parsing(std::string(5'000'000, '#')),
              "a.yaml: has more than 4 MiB; a scene is a short text: is this the right file?");
}

TEST(InputTree, RefusesTabsThatIndent) {
    EXPECT_EQ(parsing("a:\n\tb: 1\n"), "a.yaml:2:1: a tab indents this line; YAML takes spaces only");
    EXPECT_EQ(parsing("a:\n  \tb: 1\n"), "a.yaml:2:3: a tab indents this line; YAML takes spaces only");
    EXPECT_EQ(parsing("a:\tb\n\t\n \t\nc:\t1\t# x\n\t"), "no error");
}

TEST(InputTree, RefusesDeepNestingBeforeTheStackEnds) {
    const std::string deep = "nested deeper than 50 levels; a scene needs fewer than 10";
    for (const char* opening : {"[", "{a: ", "- ", "? ", "{", "[{", "a:\n"}) {
        std::string text;
        for (int i = 0; i < 20'000; ++i) {
            text += opening;
        }
        EXPECT_NE(parsing(text), "no error") << opening;
    }
    EXPECT_EQ(parsing("a: " + std::string(100, '[') + std::string(100, ']')), "a.yaml:1:53: " + deep);
    std::string blocks;
    for (std::size_t i = 0; i < 60; ++i) {
        blocks += std::string(i, ' ') + "a:\n";
    }
    EXPECT_EQ(parsing(blocks), "a.yaml:51:51: " + deep);
    EXPECT_EQ(parsing("a: " + std::string(40, '[') + std::string(40, ']')), "no error");
}

TEST(InputTree, SaysWhereYamlIsBroken) {
    const std::string hint =
        "; check brackets, colons and indentation here and just before, and put expressions in quotes";
    EXPECT_EQ(parsing("a: x > 0 ? 1 : 2\n"), "a.yaml:1:14: not valid YAML: illegal map value" + hint);
    EXPECT_EQ(parsing("a: 1\n b: 2\n"), "a.yaml:2:3: not valid YAML: illegal map value" + hint);
    EXPECT_EQ(
        parsing("a: \"x\nb: 1\n"),
        "a.yaml:2:5: the text ends inside a quote; close it where it should end, or remove the quote that is one too "
        "many; the quotes of line 1 do not pair");
    EXPECT_EQ(parsing("a: [1, 2\nb: 3\n"),
              "a.yaml:1:4: the bracket that opens here is not closed, or an expression in it needs quotes");
    EXPECT_EQ(parsing("a: {b: 1\n"),
              "a.yaml:1:4: the bracket that opens here is not closed, or an expression in it needs quotes");
}

TEST(InputNode, ReadsNumbersExactly) {
    EXPECT_EQ(number("0.1"), 0.1);
    EXPECT_EQ(number("-2.5e-3"), -2.5e-3);
    EXPECT_EQ(number("+.5"), 0.5);
    EXPECT_EQ(number("5."), 5.0);
    EXPECT_EQ(number("1.7976931348623157e308"), std::numeric_limits<double>::max());
    EXPECT_EQ(number(".inf", Infinity::allowed), std::numeric_limits<double>::infinity());
    EXPECT_EQ(number("-.Inf", Infinity::allowed), -std::numeric_limits<double>::infinity());
}

TEST(InputNode, SaysHowInfinityIsWrittenWhereItIsAllowed) {
    const auto get = [](const InputNode& node) { static_cast<void>(node.number(Infinity::allowed)); };
    EXPECT_EQ(getting("-inf", get), "a.yaml:2:6: b.k: needs a number, not '-inf'; infinity is written .inf");
    EXPECT_EQ(getting("\".inf\"", get), "a.yaml:2:6: b.k: needs a number, not '.inf' as a text; remove the quotes");
    EXPECT_EQ(getting("1e400", get),
              "a.yaml:2:6: b.k: needs a number, not '1e400'; it is too large to be held: numbers reach 1.7e308, and "
              "infinity is written .inf");
}

TEST(InputNode, ReadsNumbersInAnyLocale) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) {
        std::setlocale(LC_ALL, locale);
        EXPECT_EQ(number("0.25"), 0.25);
    }
    std::setlocale(LC_ALL, before.c_str());
}

TEST(InputNode, RefusesWhatIsNotANumber) {
    const auto get = [](const InputNode& node) { static_cast<void>(node.number()); };
    for (const char* text :
         {"abc", "0x10", "1_000", "infinite", "nan", ".nan", "--1", "+-1", "1 m", "2*3", "1.5.2", "e5", "."}) {
        EXPECT_EQ(getting(text, get), "a.yaml:2:6: b.k: needs a number, not '" + std::string{text} + "'");
    }
    for (const char* text : {".inf", "-.INF", "inf", "-inf", "Infinity"}) {
        EXPECT_EQ(getting(text, get),
                  "a.yaml:2:6: b.k: needs a number, not '" + std::string{text} + "'; it must be finite");
    }
    EXPECT_EQ(getting("\"7\"", get), "a.yaml:2:6: b.k: needs a number, not '7' as a text; remove the quotes");
    EXPECT_EQ(getting("1\"", get), "a.yaml:2:6: b.k: needs a number, not '1\"'; remove the quote in it");
    EXPECT_EQ(getting("1,5", get), "a.yaml:2:6: b.k: needs a number, not '1,5'; the decimal sign is a point");
    for (const char* text : {"1e999", "-1e999", "+1.5E+400", "1e99999"}) {
        EXPECT_EQ(getting(text, get), "a.yaml:2:6: b.k: needs a number, not '" + std::string{text} +
                                          "'; it is too large to be held: numbers reach 1.7e308");
    }
    for (const char* text : {"+1e-999", "1e-310", "-4.9e-324", "1e-99999"}) {
        EXPECT_EQ(getting(text, get), "a.yaml:2:6: b.k: needs a number, not '" + std::string{text} +
                                          "'; it is too near 0 to be held: numbers begin at 2.3e-308");
    }
    EXPECT_EQ(getting("", get), "a.yaml:2:3: b.k: needs a number, not an empty value");
    EXPECT_EQ(getting("[1]", get), "a.yaml:2:3: b.k: needs a number, not a list");
    EXPECT_EQ(getting("{x: 1}", get), "a.yaml:2:3: b.k: needs a number, not a map");
}

TEST(InputNode, ReadsIntegersOfTheWholeRange) {
    EXPECT_EQ(integer("70"), 70);
    EXPECT_EQ(integer("1e3"), 1000);
    EXPECT_EQ(integer("2.0"), 2);
    EXPECT_EQ(integer("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
    EXPECT_EQ(integer("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
}

TEST(InputNode, RefusesIntegersThatAreNotOrDoNotFit) {
    const auto get = [](const InputNode& node) { static_cast<void>(node.integer(1, 100)); };
    for (const char* text : {"0", "101", "1.5", "-3", "1e30", "99999999999999999999", "five", "1e-3", "0x5"}) {
        EXPECT_EQ(getting(text, get),
                  "a.yaml:2:6: b.k: needs an integer from 1 to 100, not '" + std::string{text} + "'");
    }
}

TEST(InputNode, ReadsWordsBooleansAndLists) {
    const std::array<std::string_view, 2> words{"cordis", "ab2"};
    const auto boolean = [](const InputNode& node) { static_cast<void>(node.boolean()); };
    const auto word = [&](const InputNode& node) { static_cast<void>(node.word(words)); };
    const auto three = [](const InputNode& node) { static_cast<void>(node.list(3)); };
    const auto text = [](const InputNode& node) { static_cast<void>(node.text()); };
    EXPECT_EQ(getting("true", boolean), "no error");
    EXPECT_EQ(getting("yes", boolean), "a.yaml:2:6: b.k: needs true or false, not 'yes'");
    EXPECT_EQ(getting("ab2", word), "no error");
    EXPECT_EQ(getting("cordi", word), "a.yaml:2:6: b.k: does not know 'cordi'; did you mean 'cordis'?");
    EXPECT_EQ(getting("leapfrog", word), "a.yaml:2:6: b.k: does not know 'leapfrog'; take one of cordis, ab2");
    EXPECT_EQ(getting("[ab2]", word), "a.yaml:2:3: b.k: needs one of cordis, ab2, not a list");
    EXPECT_EQ(getting("[1, 2, 3]", three), "no error");
    EXPECT_EQ(getting("[min(x,1), 0, 0]", three),
              "a.yaml:2:3: b.k: needs a list of 3 values, not of 4; put an expression that holds commas in quotes");
    EXPECT_EQ(getting("5", three), "a.yaml:2:6: b.k: needs a list of 3 values, not '5'");
    EXPECT_EQ(getting("null", text), "a.yaml:2:3: b.k: needs a text, not an empty value");
    EXPECT_EQ(getting("\"null\"", text), "no error");
}

TEST(InputTree, SettingsReplaceAndMakeValues) {
    InputTree tree{"block: {cells: [1, 2, 3]}\nlist: [{name: a}]\n", "a.yaml"};
    for (const char* value : {"block.cells.0=5", "time.end=0.5", "time.end=0.25", "title=a b", "list.0.name=b",
                              "list.1.name=c", "coat={rate: 10}", "empty="}) {
        tree.set(value);
    }
    const InputNode root = tree.root();
    EXPECT_EQ(root.at("block").at("cells").list(3)[0].integer(0, 9), 5);
    EXPECT_EQ(root.at("block").at("cells").list(3)[2].integer(0, 9), 3);
    EXPECT_EQ(root.at("time").at("end").number(), 0.25);
    EXPECT_EQ(root.at("title").text(), "a b");
    EXPECT_EQ(root.at("list").list(2)[0].at("name").text(), "b");
    EXPECT_EQ(root.at("list").list(2)[1].at("name").text(), "c");
    EXPECT_EQ(root.at("coat").at("rate").number(), 10);
    EXPECT_TRUE(root.at("empty").is_null());
}

TEST(InputTree, ErrorsInSettingsNameTheSetting) {
    const std::array<std::string_view, 1> keys{"cells"};
    const auto number_of = [](const std::string& value, std::string_view key) {
        InputTree tree{"block: {edge: 1}", "a.yaml"};
        tree.set(value);
        return message([&] { static_cast<void>(tree.root().at("block").at(key).number()); });
    };
    EXPECT_EQ(number_of("block.edge=abc", "edge"), "--set block.edge: needs a number, not 'abc'");
    EXPECT_EQ(number_of("block={edge: abc}", "edge"), "--set block: block.edge: needs a number, not 'abc'");
    InputTree tree{"block: {cells: 1}", "a.yaml"};
    tree.set("block.cels=1");
    EXPECT_EQ(message([&] { tree.root().at("block").expect_keys(keys); }),
              "--set block.cels: unknown key; did you mean 'cells'?");
}

TEST(InputTree, RefusesSettingsThatCannotBeApplied) {
    const std::string form = "--set: needs the form key.path=value, such as time.end=0.5, not ";
    EXPECT_EQ(setting("a: 1", "b"), form + "'b'");
    EXPECT_EQ(setting("a: 1", "=1"), form + "'=1'");
    EXPECT_EQ(setting("a: 1", "a..b=1"), form + "'a..b=1'");
    EXPECT_EQ(setting("a: 1", std::string(100, '\x91')), form + "'" + std::string(60, '?') + "...'");
    EXPECT_EQ(setting("a: 1", "a=\xff"), "--set a: the byte 0xFF is not text; a scene is YAML in UTF-8");
    EXPECT_EQ(setting("a: 1", "a.b=1"),
              "--set a.b: there is no 'b' to set in the plain value '1'; set the whole value");
    EXPECT_EQ(setting("a: [1, 2]", "a.3=1"),
              "--set a.3: '3' is not an item of a list of 2; items count from 0, and 2 appends one");
    EXPECT_EQ(setting("a: [1, 2]", "a.x=1"),
              "--set a.x: 'x' is not an item of a list of 2; items count from 0, and 2 appends one");
    EXPECT_EQ(setting("a: 1", "a={b: 1"),
              "--set a: a key must be plain text, not a list or a map; is a bracket open that should be closed?");
    EXPECT_EQ(setting("a: 1", "a=*x").substr(0, 35), "--set a: YAML anchors and aliases (");
}

}  // namespace
}  // namespace cracksim::io
