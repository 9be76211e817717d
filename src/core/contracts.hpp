#pragma once

/// Contracts by role: EXPECT is a precondition, ASSERT an invariant, ENSURE a postcondition.
/// They are checked in builds with CRACKSIM_CONTRACTS and cost nothing in other builds. User data are checked in every
/// build, with the exceptions of errors.hpp.

namespace cracksim {

/// Prints the violated contract with its file and line, and aborts.
[[noreturn]] void contract_violated(const char* role, const char* condition, const char* file, int line);

}  // namespace cracksim

#ifdef CRACKSIM_CONTRACTS
#define CRACKSIM_CHECK_CONTRACT(role, condition) \
    ((condition) ? static_cast<void>(0) : ::cracksim::contract_violated(role, #condition, __FILE__, __LINE__))
#else
#define CRACKSIM_CHECK_CONTRACT(role, condition) static_cast<void>(sizeof((condition) ? 1 : 0))
#endif

#define CRACKSIM_EXPECT(condition) CRACKSIM_CHECK_CONTRACT("precondition", condition)
#define CRACKSIM_ASSERT(condition) CRACKSIM_CHECK_CONTRACT("invariant", condition)
#define CRACKSIM_ENSURE(condition) CRACKSIM_CHECK_CONTRACT("postcondition", condition)
