#include "scene/schedule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace cracksim::scene {
namespace {

std::vector<std::int64_t> due_steps(double rate, double step_size, std::int64_t steps) {
    std::vector<std::int64_t> due;
    const Schedule schedule{rate, step_size};
    for (std::int64_t n = 0; n <= steps; ++n) {
        if (schedule.is_due(n)) {
            due.push_back(n);
        }
    }
    return due;
}

TEST(Schedule, IsDueAtTheFirstStepAtOrAfterEachTick) {
    EXPECT_EQ(due_steps(50, 1.0 / 1050, 1050).size(), 51U);
    for (const std::int64_t n : due_steps(50, 1.0 / 1050, 1050)) {
        EXPECT_EQ(n % 21, 0);
    }
    EXPECT_EQ(due_steps(10, 0.03, 14), (std::vector<std::int64_t>{0, 4, 7, 10, 14}));
}

TEST(Schedule, IsNeverDueAtRateZeroAndAtEveryStepAtAHighRate) {
    EXPECT_TRUE(due_steps(0, 0.1, 100).empty());
    EXPECT_EQ(due_steps(1000, 0.1, 100).size(), 101U);
}

TEST(Schedule, CountsAndFindsTheStepsThatAreDue) {
    for (const double rate : {0.0, 3.0, 50.0, 333.0, 999.0, 1000.0, 4000.0}) {
        const Schedule schedule{rate, 1e-3};
        const std::vector<std::int64_t> due = due_steps(rate, 1e-3, 1000);
        EXPECT_EQ(schedule.due_until(1000), static_cast<std::int64_t>(due.size())) << rate;
        for (std::size_t i = 1; i < due.size(); ++i) {
            ASSERT_EQ(schedule.next_due(due[i - 1]), due[i]) << rate;
            ASSERT_EQ(schedule.next_due(due[i] - 1), due[i]) << rate;
        }
    }
}

TEST(Schedule, IsNeverDueAgainWhereNoRunGetsSoFar) {
    EXPECT_EQ(Schedule(1e-20, 1e-3).next_due(0), Schedule::never);
    EXPECT_EQ(Schedule(1e-300, 1e-3).due_until(1'000'000'000), 1);
}

}  // namespace
}  // namespace cracksim::scene
