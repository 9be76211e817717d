#include "io/expression.hpp"

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "core/errors.hpp"
#include "io/expression_error.hpp"
#include "io/input_text.hpp"
#include "io/number_text.hpp"
#include "io/text_file.hpp"

namespace cracksim::io {

namespace {

struct Function {
    std::string_view name;
    double (*value)(double);
};

constexpr std::array functions{Function{"abs", [](double v) { return std::abs(v); }},
                               Function{"sqrt", [](double v) { return std::sqrt(v); }},
                               Function{"exp", [](double v) { return std::exp(v); }},
                               Function{"log", [](double v) { return std::log(v); }},
                               Function{"log10", [](double v) { return std::log10(v); }},
                               Function{"sin", [](double v) { return std::sin(v); }},
                               Function{"cos", [](double v) { return std::cos(v); }},
                               Function{"tan", [](double v) { return std::tan(v); }},
                               Function{"asin", [](double v) { return std::asin(v); }},
                               Function{"acos", [](double v) { return std::acos(v); }},
                               Function{"atan", [](double v) { return std::atan(v); }},
                               Function{"sinh", [](double v) { return std::sinh(v); }},
                               Function{"cosh", [](double v) { return std::cosh(v); }},
                               Function{"tanh", [](double v) { return std::tanh(v); }},
                               Function{"floor", [](double v) { return std::floor(v); }},
                               Function{"ceil", [](double v) { return std::ceil(v); }},
                               Function{"sign", [](double v) { return v > 0   ? 1.0
                                                                      : v < 0 ? -1.0
                                                                              : 0.0; }}};

double atan2_of(double y, double x) { return std::atan2(y, x); }

double min_of(const double* values, int count) {
    double least = values[0];
    for (int i = 1; i < count; ++i) {
        least = values[i] < least ? values[i] : least;
    }
    return least;
}

double max_of(const double* values, int count) {
    double most = values[0];
    for (int i = 1; i < count; ++i) {
        most = values[i] > most ? values[i] : most;
    }
    return most;
}

/// muParser reads a single '=' as an assignment to a variable.
bool assigns(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text.substr(i, 2) == "==") {
            ++i;
        } else if (text[i] == '=' && (i == 0 || std::string_view{"<>!"}.find(text[i - 1]) == std::string_view::npos)) {
            return true;
        }
    }
    return false;
}

void check_text(std::string_view text) {
    constexpr std::string_view characters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.+-*/^(),<>=!&|?: \n";
    if (const std::size_t i = text.find_first_not_of(characters); i != std::string_view::npos) {
        const auto control = control_character(text.substr(i));
        const std::size_t length = std::max(utf8_length(text.substr(i)), std::size_t{1});
        const std::string shown =
            control ? "the control character " + hexadecimal(*control) : "'" + shortened(text.substr(i, length)) + "'";
        throw InputError{shown + " at character " + std::to_string(i + 1) + " has no meaning in an expression"};
    }
    if (assigns(text)) {
        throw InputError{"'=' does not compare; write '=='"};
    }
}

}  // namespace

struct Expression::Formula {
    Formula() {
        parser.ClearFun();
        parser.ClearConst();
        for (const Function& function : functions) {
            parser.DefineFun(std::string{function.name}, function.value);
        }
        parser.DefineFun("atan2", atan2_of);
        parser.DefineFun("min", min_of);
        parser.DefineFun("max", max_of);
        parser.DefineConst("pi", std::numbers::pi);
        parser.DefineConst("e", std::numbers::e);
        for (std::size_t i = 0; i < names.size(); ++i) {
            parser.DefineVar(names[i], &variables[i]);
        }
    }

    explicit Formula(const std::string& text) : Formula{} { parser.SetExpr(text); }

    static constexpr std::array<const char*, 4> names{"x", "y", "z", "t"};
    std::array<double, 4> variables{};
    mu::Parser parser;
};

// A parser takes kilobytes, and creating one takes longer than reading a formula. A scene may hold 90,000 expressions,
// of which a run evaluates few, so one parser examines them all.
Expression::Examined Expression::examine(const std::string& text) {
    thread_local Formula formula;
    formula.variables = {};
    formula.parser.SetExpr(text);
    int results = 0;
    const double value = *formula.parser.Eval(results);
    if (results != 1) {
        throw InputError{"a comma separates arguments of functions only; the decimal sign is a point"};
    }
    // GetUsedVar() comes last because it discards muParser's compiled form.
    const mu::varmap_type& used = formula.parser.GetUsedVar();
    return {value, used.empty(), used.contains("t")};
}

Expression::Expression(double constant)
    : text_{std::isinf(constant) ? (constant > 0 ? ".inf" : "-.inf") : exact(constant)},
      examined_{constant, true, false} {}

Expression::Expression(std::string text) : text_{std::move(text)} {
    if (const auto number = to_number(text_)) {
        *this = Expression{*number};
        return;
    }
    const auto explain = [&](const std::string& why) {
        throw InputError{"'" + shortened(text_) + "' is not a number or an expression: " + why + "; allowed are " +
                         allowed()};
    };
    try {
        check_text(text_);
        examined_ = examine(text_);
    } catch (const mu::ParserError& error) {
        explain(explanation(error));
    } catch (const InputError& error) {
        explain(error.what());
    }
}

Expression::~Expression() = default;
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;

Expression::Expression(const Expression& other) : text_{other.text_}, examined_{other.examined_} {}

Expression& Expression::operator=(const Expression& other) {
    Expression copy{other};
    return *this = std::move(copy);
}

double Expression::operator()(Vec3 at, double time) const {
    if (examined_.is_constant) {
        return examined_.value;
    }
    if (!formula_) {
        formula_ = std::make_unique<Formula>(text_);
    }
    formula_->variables = {at.x, at.y, at.z, time};
    return formula_->parser.Eval();
}

std::string Expression::allowed() {
    std::string names;
    for (const Function& function : functions) {
        names += std::string{function.name} + ", ";
    }
    return "numbers, x, y, z (m), t (s), pi, e, + - * / ^, < <= > >= == !=, && ||, a ? b : c, and the functions " +
           names + "atan2, min, max";
}

Expression read_expression(const InputNode& node, InputNode::Infinity infinity) {
    const bool may_be_infinite = infinity == InputNode::Infinity::allowed;
    if (!node.is_scalar()) {
        node.fail("needs a number or an expression, not " + node.shown() +
                  (node.is_map() ? "; put an expression that holds ': ' in quotes" : ""));
    }
    const std::string text = node.text();
    if (const auto infinite = to_infinity(text); infinite && may_be_infinite) {
        return Expression{*infinite};
    }
    if (to_infinity(text) || names_infinity(text) || is_beyond_range(text)) {
        node.fail("needs a number or an expression, not " + node.shown() + number_hint(text, may_be_infinite));
    }
    try {
        return Expression{text};
    } catch (const InputError& error) {
        node.fail(error.what());
    }
}

}  // namespace cracksim::io
