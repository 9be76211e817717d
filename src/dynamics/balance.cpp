#include "dynamics/balance.hpp"

#include "core/vec3.hpp"

namespace cracksim::dynamics {

namespace {

/// Calls action(number) for each number of a balance.
void for_each_number(Balance& balance, auto&& action) {
    const auto vector = [&](Vec3& v) {
        action(v.x);
        action(v.y);
        action(v.z);
    };
    action(balance.unions.kinetic);
    vector(balance.unions.momentum);
    vector(balance.unions.angular_momentum);
    for (physics::SupportSums& support : balance.unions.supports) {
        vector(support.force);
        vector(support.displacement);
        action(support.mass);
        action(support.work);
    }
    action(balance.elastic);
    action(balance.dissipated);
    for (double& work : balance.work) {
        action(work);
    }
}

}  // namespace

Balance sum(const partition::Communicator& comm, Balance share) {
    std::vector<double> numbers;
    for_each_number(share, [&](double number) { numbers.push_back(number); });
    comm.sum(numbers);
    auto next = numbers.cbegin();
    for_each_number(share, [&](double& number) { number = *next++; });
    return share;
}

}  // namespace cracksim::dynamics
