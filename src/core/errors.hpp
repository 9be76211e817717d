#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "core/ids.hpp"

namespace cracksim {

/// Wrong command line or scene, found before the first step (exit code 2). The text says where, what, why and what to do.
/// Thrown on all ranks alike.
class InputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Something else that ends a run (exit code 1): a full disk, a failed audit, a library. Thrown on all ranks alike, so that they
/// end together; an exception of another type is one rank's own, and that rank must stop the others.
class SharedError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The run became invalid: non-finite or exploding motion (exit code 3). Thrown on all ranks alike.
class InvalidRun : public std::runtime_error {
public:
    InvalidRun(const std::string& text, std::int64_t step, MassId mass)
        : std::runtime_error{text}, step_{step}, mass_{mass} {}

    [[nodiscard]] std::int64_t step() const { return step_; }
    [[nodiscard]] MassId mass() const { return mass_; }

private:
    std::int64_t step_;
    MassId mass_;
};

}  // namespace cracksim
