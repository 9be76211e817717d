#include "topology/parting_search.hpp"

namespace cracksim::topology {

PartingSearch::PartingSearch(std::size_t entities) : next_(entities), front_of_(entities, -1) {}

void PartingSearch::start(std::span<const LocalEntity> sources) {
    for (const LocalEntity source : sources) {
        if (front_of_[source] >= 0) {
            continue;
        }
        const auto front = static_cast<std::int32_t>(fronts_.size());
        front_of_[source] = front;
        next_[source] = LocalEntity{};
        fronts_.push_back({{}, {source, source}, front, false});
        turns_.push_back(front);
    }
    living_ = fronts_.size();
}

std::int32_t PartingSearch::next_in_turn() {
    for (;;) {
        turn_ = turn_ < turns_.size() ? turn_ : 0;
        const std::int32_t front = turns_[turn_];
        if (at(front).joined == front && !at(front).ended) {
            ++turn_;
            return front;
        }
        turns_[turn_] = turns_.back();
        turns_.pop_back();
    }
}

LocalEntity PartingSearch::take(std::int32_t front) {
    Queue& to_see = at(front).to_see;
    const LocalEntity entity = to_see.first;
    if (entity != LocalEntity{}) {
        to_see = next_[entity] == LocalEntity{} ? Queue{} : Queue{next_[entity], to_see.last};
        next_[entity] = LocalEntity{};
        append(at(front).seen, {entity, entity});
    }
    return entity;
}

void PartingSearch::reach(std::int32_t front, LocalEntity entity) {
    const std::int32_t met = front_of_[entity];
    if (met < 0) {
        front_of_[entity] = front;
        next_[entity] = LocalEntity{};
        append(at(front).to_see, {entity, entity});
        return;
    }
    if (const std::int32_t other = find(met); other != front) {
        append(at(front).seen, at(other).seen);
        append(at(front).to_see, at(other).to_see);
        at(other).joined = front;
        --living_;
    }
}

void PartingSearch::end(std::int32_t front) {
    at(front).ended = true;
    ended_.push_back(front);
    --living_;
}

const std::vector<LocalEntity>& PartingSearch::members(std::int32_t front) {
    members_.clear();
    for (LocalEntity e = at(front).seen.first; e != LocalEntity{}; e = next_[e]) {
        members_.push_back(e);
    }
    return members_;
}

void PartingSearch::clear() {
    for (std::int32_t front = 0; static_cast<std::size_t>(front) < fronts_.size(); ++front) {
        if (at(front).joined == front) {
            release(at(front).seen);
            release(at(front).to_see);
        }
    }
    fronts_.clear();
    turns_.clear();
    ended_.clear();
    turn_ = 0;
}

std::int32_t PartingSearch::find(std::int32_t front) {
    while (at(front).joined != front) {
        at(front).joined = at(at(front).joined).joined;
        front = at(front).joined;
    }
    return front;
}

void PartingSearch::append(Queue& queue, Queue added) {
    if (added.first == LocalEntity{}) {
        return;
    }
    if (queue.first == LocalEntity{}) {
        queue = added;
        return;
    }
    next_[queue.last] = added.first;
    queue.last = added.last;
}

void PartingSearch::release(Queue queue) {
    for (LocalEntity e = queue.first; e != LocalEntity{}; e = next_[e]) {
        front_of_[e] = -1;
    }
}

std::size_t PartingSearch::memory_bytes() const { return next_.bytes() + front_of_.bytes(); }

}  // namespace cracksim::topology
