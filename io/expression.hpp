#pragma once

#include <memory>
#include <string>

#include "core/vec3.hpp"
#include "io/input_tree.hpp"

namespace cracksim::io {

/// A number that may depend on the rest position x, y, z (m) and on the time t (s). An expression without variables is
/// a constant and costs nothing to evaluate. Evaluation does not depend on the locale. Only the first evaluation
/// allocates memory, because it creates a parser. Two threads must not evaluate one Expression at the same time.
class Expression {
public:
    explicit Expression(double constant);
    /// Throws InputError, whose text states the error and the allowed syntax; the caller adds the place.
    explicit Expression(std::string text);
    ~Expression();
    Expression(const Expression& other);
    Expression& operator=(const Expression& other);
    Expression(Expression&&) noexcept;
    Expression& operator=(Expression&&) noexcept;

    [[nodiscard]] double operator()(Vec3 at, double time) const;
    [[nodiscard]] bool is_constant() const { return examined_.is_constant; }
    [[nodiscard]] bool uses_time() const { return examined_.uses_time; }
    /// Text from which the same expression can be read.
    [[nodiscard]] const std::string& text() const { return text_; }

    /// The allowed syntax, for error messages.
    [[nodiscard]] static std::string allowed();

private:
    struct Formula;
    struct Examined {
        double value{0};  ///< value of a constant
        bool is_constant{true};
        bool uses_time{false};
    };
    static Examined examine(const std::string& text);

    std::string text_;
    Examined examined_;
    mutable std::unique_ptr<Formula> formula_;
};

/// Reads a number or an expression from a scene's value. Throws InputError with the value's place.
[[nodiscard]] Expression read_expression(const InputNode& node, InputNode::Infinity infinity);

}  // namespace cracksim::io
