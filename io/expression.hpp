#pragma once

#include <memory>
#include <string>

#include "core/vec3.hpp"
#include "io/input_tree.hpp"

namespace cracksim::io {

/// A number that may depend on the rest position x, y, z (m) and on the time t (s). An expression without variables is a
/// constant and costs nothing to evaluate. Evaluation neither allocates nor depends on the locale, but one Expression must not
/// be evaluated by two threads at once.
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
    [[nodiscard]] bool is_constant() const { return formula_ == nullptr; }
    [[nodiscard]] bool uses_time() const;
    /// What reads back as the same expression.
    [[nodiscard]] const std::string& text() const { return text_; }

    /// What an expression may be made of, in words.
    [[nodiscard]] static std::string allowed();

private:
    struct Formula;

    std::string text_;
    double constant_{0};
    std::unique_ptr<Formula> formula_;
};

/// The number or expression of a scene's value, .inf included. Throws InputError with the value's place.
[[nodiscard]] Expression read_expression(const InputNode& node);

}  // namespace cracksim::io
