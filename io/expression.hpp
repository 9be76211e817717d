#pragma once

#include <memory>
#include <string>

#include "core/vec3.hpp"
#include "io/input_tree.hpp"

namespace cracksim::io {

/// A number that may depend on the rest position x, y, z (m) and on the time t (s). An expression without variables is a
/// constant and costs nothing to evaluate. Evaluation does not depend on the locale, and after the first, which makes a parser, does
/// not allocate; one Expression must not be evaluated by two threads at once.
class Expression {
public:
    explicit Expression(double constant);
    /// Throws InputError that says what is wrong with the text and what is allowed; the place is the caller's to add.
    explicit Expression(std::string text);
    ~Expression();
    Expression(const Expression& other);
    Expression& operator=(const Expression& other);
    Expression(Expression&&) noexcept;
    Expression& operator=(Expression&&) noexcept;

    [[nodiscard]] double operator()(Vec3 at, double time) const;
    [[nodiscard]] bool is_constant() const { return examined_.is_constant; }
    [[nodiscard]] bool uses_time() const { return examined_.uses_time; }
    /// What reads back as the same expression.
    [[nodiscard]] const std::string& text() const { return text_; }

    /// What an expression may be made of, in words.
    [[nodiscard]] static std::string allowed();

private:
    struct Formula;
    struct Examined {
        double value{0};  ///< of a constant
        bool is_constant{true};
        bool uses_time{false};
    };
    static Examined examine(const std::string& text);

    std::string text_;
    Examined examined_;
    mutable std::unique_ptr<Formula> formula_;
};

/// The number or expression of a scene's value. Throws InputError with the value's place.
[[nodiscard]] Expression read_expression(const InputNode& node, InputNode::Infinity infinity);

}  // namespace cracksim::io
