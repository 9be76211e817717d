#include "io/expression.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/errors.hpp"

namespace cracksim::io {
namespace {

constexpr Vec3 here{2.0, 3.0, 5.0};
constexpr double now = 7.0;

double value(const std::string& text) { return Expression{text}(here, now); }

std::string error_of(const std::string& text) {
    try {
        Expression{text};
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

std::string explained(const std::string& text, const std::string& why) {
    return "'" + text + "' is not a number or an expression: " + why + "; allowed are " + Expression::allowed();
}

Expression read(const std::string& yaml, InputNode::Infinity infinity = InputNode::Infinity::allowed) {
    const InputTree tree{"k: " + yaml, "a.yaml"};
    return read_expression(tree.root().at("k"), infinity);
}

TEST(Expression, KnowsPositionAndTime) {
    EXPECT_EQ(value("x"), 2.0);
    EXPECT_EQ(value("y"), 3.0);
    EXPECT_EQ(value("z"), 5.0);
    EXPECT_EQ(value("t"), 7.0);
    EXPECT_EQ(value("x + 10*y + 100*z + 1000*t"), 7532.0);
}

TEST(Expression, FollowsTheUsualOrderOfOperators) {
    EXPECT_EQ(value("-x^2"), -4.0);
    EXPECT_EQ(value("2^y^2"), 512.0);
    EXPECT_EQ(value("1 - 2 - 3*x/4"), -2.5);
    EXPECT_EQ(value("2--x"), 4.0);
    EXPECT_EQ(value("x > 1 && y < 1 || z == 5"), 1.0);
    EXPECT_EQ(value("x != 2 ? 10 : y >= 3 ? 20 : 30"), 20.0);
    EXPECT_EQ(value("x <= 1 ? 10 : 30"), 30.0);
}

TEST(Expression, HasTheFunctionsThatItSays) {
    const std::pair<const char*, double> cases[]{{"abs(-x)", 2},
                                                 {"sqrt(x+2)", 2},
                                                 {"exp(x)", std::exp(2)},
                                                 {"log(x)", std::log(2)},
                                                 {"log10(x*50)", 2},
                                                 {"sin(x)", std::sin(2)},
                                                 {"cos(x)", std::cos(2)},
                                                 {"tan(x)", std::tan(2)},
                                                 {"asin(x/4)", std::asin(0.5)},
                                                 {"acos(x/4)", std::acos(0.5)},
                                                 {"atan(x)", std::atan(2)},
                                                 {"sinh(x)", std::sinh(2)},
                                                 {"cosh(x)", std::cosh(2)},
                                                 {"tanh(x)", std::tanh(2)},
                                                 {"floor(x/3)", 0},
                                                 {"ceil(x/3)", 1},
                                                 {"sign(-x)", -1},
                                                 {"sign(x-2)", 0},
                                                 {"atan2(x,y)", std::atan2(2, 3)},
                                                 {"min(x,y,z)", 2},
                                                 {"max(x,y,z,6)", 6},
                                                 {"min(x)", 2},
                                                 {"pi*x", 2 * std::numbers::pi},
                                                 {"e*x", 2 * std::numbers::e}};
    for (const auto& [text, expected] : cases) {
        EXPECT_DOUBLE_EQ(value(text), expected) << text;
        const std::string name{text, std::string{text}.find_first_of("(*")};
        EXPECT_NE(Expression::allowed().find(name), std::string::npos) << name;
    }
}

TEST(Expression, IsConstantWithoutVariables) {
    for (const char* text : {"5", "-0.25", "1e3", ".5", "2*pi", "sqrt(4)^2", "max(1, 2)"}) {
        EXPECT_TRUE(Expression{std::string{text}}.is_constant()) << text;
    }
    EXPECT_FALSE(Expression{std::string{"0*x"}}.is_constant());
    EXPECT_EQ(value("2*pi"), 2 * std::numbers::pi);
    EXPECT_EQ(Expression{0.1}(here, now), 0.1);
}

TEST(Expression, KnowsWhetherItUsesTime) {
    EXPECT_TRUE(Expression{std::string{"sin(2*pi*t)"}}.uses_time());
    EXPECT_FALSE(Expression{std::string{"tan(x)"}}.uses_time());
    EXPECT_FALSE(Expression{std::string{"3"}}.uses_time());
}

TEST(Expression, CopiesAndMovesAreIndependent) {
    Expression first{std::string{"x*t"}};
    Expression copy = first;
    EXPECT_EQ(first({1, 0, 0}, 2), 2);
    EXPECT_EQ(copy({10, 0, 0}, 2), 20);
    const Expression moved = std::move(first);
    EXPECT_EQ(moved({3, 0, 0}, 3), 9);
    copy = Expression{4.0};
    EXPECT_EQ(copy(here, now), 4);
    copy = moved;
    EXPECT_EQ(copy({2, 0, 0}, 2), 4);
}

TEST(Expression, TextReadsBackAsTheSameExpression) {
    for (const double number : {0.1, -1e-300, 12345678.9, std::numeric_limits<double>::max(), 1.0 / 3.0}) {
        EXPECT_EQ(Expression{Expression{number}.text()}(here, now), number);
    }
    EXPECT_EQ(Expression{std::string{"x + 1"}}.text(), "x + 1");
    EXPECT_EQ(Expression{std::string{"2.50e-1"}}.text(), "0.25");
    EXPECT_EQ(Expression{std::numeric_limits<double>::infinity()}.text(), ".inf");
}

TEST(Expression, DoesNotDependOnTheLocale) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) {
        std::setlocale(LC_ALL, locale);
        EXPECT_EQ(value("0.5*x + min(1.5,2)"), 2.5);
    }
    std::setlocale(LC_ALL, before.c_str());
}

TEST(Expression, SaysWhatIsWrongAndWhatIsAllowed) {
    EXPECT_EQ(error_of("foo(x)"), explained("foo(x)", "'foo' at character 1 is not known"));
    EXPECT_EQ(error_of("2*w"), explained("2*w", "'w' at character 3 is not known"));
    EXPECT_EQ(error_of("(x"), explained("(x", "a bracket is not closed"));
    EXPECT_EQ(error_of("x=2"), explained("x=2", "'=' does not compare; write '=='"));
    EXPECT_EQ(error_of("x ? 1 = 2 : 3"), explained("x ? 1 = 2 : 3", "'=' does not compare; write '=='"));
    EXPECT_EQ(error_of("1,5"),
              explained("1,5", "a comma separates arguments of functions only; the decimal sign is a point"));
    EXPECT_EQ(error_of("\"x\""), explained("\"x\"", "'\"' at character 1 has no meaning in an expression"));
    EXPECT_EQ(error_of("x\xc2\xb2"),
              explained("x\xc2\xb2", "'\xc2\xb2' at character 2 has no meaning in an expression"));
    EXPECT_EQ(error_of("x y"), explained("x y", "'y' at character 3 is out of place"));
    EXPECT_EQ(error_of("2*"), explained("2*", "it ends too early"));
    EXPECT_EQ(error_of("sin(x,y)"), explained("sin(x,y)", "a function has too many arguments at character 8"));
    EXPECT_EQ(error_of("atan2(x)"), explained("atan2(x)", "a function has too few arguments at character 8"));
    EXPECT_EQ(error_of("x ? 1"), explained("x ? 1", "'?' without ':'"));
    EXPECT_EQ(error_of("x : 1"), explained("x : 1", "':' without '?'"));
    EXPECT_EQ(error_of(""), explained("", "it is empty"));
    for (const char* text : {"", " ", "x y", "sin", "sin()", "sin(x,y)", "min()", "1e999", "inf", "nan", "0x10",
                             "x ? 1", "x)", "()", "2e", "_pi", "rnd", "sum(1,2)", "x > = 1"}) {
        EXPECT_NE(error_of(text), "no error") << text;
    }
}

TEST(ReadExpression, TakesNumbersTextsAndInfinity) {
    EXPECT_EQ(read("0.02")(here, now), 0.02);
    EXPECT_EQ(read("0.02*x")(here, now), 0.04);
    EXPECT_EQ(read("\"x > 1 ? 1 : 2\"")(here, now), 1);
    EXPECT_EQ(read(".inf")(here, now), std::numeric_limits<double>::infinity());
}

TEST(ReadExpression, ErrorsNameThePlace) {
    const auto error = [](const std::string& yaml) -> std::string {
        try {
            read(yaml);
        } catch (const InputError& e) {
            return e.what();
        }
        return "no error";
    };
    EXPECT_EQ(error("2*w"), "a.yaml:1:4: k: " + explained("2*w", "'w' at character 3 is not known"));
    const auto refused = [](const std::string& yaml) -> std::string {
        try {
            read(yaml, InputNode::Infinity::refused);
        } catch (const InputError& e) {
            return e.what();
        }
        return "no error";
    };
    EXPECT_EQ(refused(".inf"), "a.yaml:1:4: k: needs a number or an expression, not '.inf'; it must be finite");
    EXPECT_EQ(error("1e400*x"), "a.yaml:1:4: k: " + explained("1e400*x",
                                                              "'1e400' at character 1 is too large; numbers reach "
                                                              "up to 1.7e308"));
    EXPECT_EQ(error("{a: 1}"),
              "a.yaml:1:1: k: needs a number or an expression, not a map; put an expression that holds ': ' in quotes");
}

}  // namespace
}  // namespace cracksim::io
