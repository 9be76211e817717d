#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "core/ids.hpp"

namespace cracksim {

/// A wrong command line or scene, found before the first step (exit code 2). The text gives the place, the error, its
/// reason and the remedy. Thrown on all ranks with the same text.
class InputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Another error that ends a run (exit code 1): a full disk, a failed audit, an error in a library. Thrown on all ranks
/// with the same text, so that they end together. An exception of any other type occurs on one rank, and that rank must
/// stop all ranks.
class SharedError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The run became invalid: non-finite or exploding motion (exit code 3). Thrown on all ranks with the same text.
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
