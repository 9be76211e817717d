#include "dynamics/balance.hpp"

namespace cracksim::dynamics {

namespace {

/// Calls action(number) for each number of a balance.
void for_each_number(Balance& balance, auto&& action) {
    const auto vector = [&](Vec3& v) {
        action(v.x);
        action(v.y);
        action(v.z);
    };
    action(balance.kinetic);
    action(balance.elastic);
    action(balance.dissipated);
    vector(balance.momentum);
    vector(balance.angular_momentum);
    for (Balance::Support& support : balance.supports) {
        vector(support.force);
        vector(support.weighted);
        action(support.mass);
        action(support.work);
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
