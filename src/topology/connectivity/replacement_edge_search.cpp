#include "topology/connectivity/replacement_edge_search.hpp"

#include <utility>

namespace cracksim::topology {
namespace {

constexpr std::int32_t no_front = -1;
/// Value in next_ of an entity that is in no queue. None (the default) marks the end of a queue.
constexpr LocalEntity not_queued{-2};

}  // namespace

void make_root(LocalEntity entity, Parents& parents) {
    LocalEntity below;
    while (entity != LocalEntity{}) {
        entity = std::exchange(parents[entity], std::exchange(below, entity));
    }
}

ReplacementEdgeSearch::ReplacementEdgeSearch(std::size_t entities)
    : next_(entities, not_queued), front_of_(entities, no_front) {}

// The fronts above the cuts start at the parents of the orphans: most replacement edges are near the cut.
void ReplacementEdgeSearch::start(std::span<const LocalEntity> orphans, Parents& parents) {
    std::vector<LocalEntity> left;
    for (const LocalEntity orphan : orphans) {
        left.push_back(std::exchange(parents[orphan], LocalEntity{}));
        queue(orphan, add_front(orphan, false));
    }
    for (const LocalEntity parent : left) {
        const std::int32_t front = front_above(parent, parents);
        if (next_[parent] == not_queued) {
            queue(parent, front);
        }
    }
}

std::int32_t ReplacementEdgeSearch::add_front(LocalEntity root, bool has_root) {
    const auto front = static_cast<std::int32_t>(fronts_.size());
    fronts_.push_back({{}, {}, front, has_root, false});
    turns_.push_back(front);
    know(root, front);
    ++living_;
    return front;
}

std::int32_t ReplacementEdgeSearch::next_in_turn() {
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

LocalEntity ReplacementEdgeSearch::take(std::int32_t front) {
    Queue& to_see = at(front).to_see;
    const LocalEntity entity = to_see.first;
    if (entity != LocalEntity{}) {
        to_see = next_[entity] == LocalEntity{} ? Queue{} : Queue{next_[entity], to_see.last};
        next_[entity] = LocalEntity{};
        append(at(front).seen, {entity, entity});
    }
    return entity;
}

// The subtree without the old root is attached to the other one: the path that make_root() reverses is shorter there.
void ReplacementEdgeSearch::reach(std::int32_t front, LocalEntity from, LocalEntity entity, Parents& parents) {
    if (next_[entity] != not_queued && find(front_of_[entity]) == front) {
        return;
    }
    const std::int32_t other = front_above(entity, parents);
    if (other == front) {
        queue(entity, front);
        return;
    }
    const auto [hung, on] = at(front).has_root ? std::pair{entity, from} : std::pair{from, entity};
    make_root(hung, parents);
    parents[hung] = on;
    join(front, other);
}

void ReplacementEdgeSearch::join(std::int32_t front, std::int32_t other) {
    append(at(front).seen, at(other).seen);
    append(at(front).to_see, at(other).to_see);
    at(front).has_root = at(front).has_root || at(other).has_root;
    at(other).joined = front;
    --living_;
}

void ReplacementEdgeSearch::end(std::int32_t front) {
    at(front).ended = true;
    ended_.push_back(front);
    --living_;
}

const std::vector<LocalEntity>& ReplacementEdgeSearch::members(std::int32_t front) {
    members_.clear();
    for (LocalEntity e = at(front).seen.first; e != LocalEntity{}; e = next_[e]) {
        members_.push_back(e);
    }
    return members_;
}

void ReplacementEdgeSearch::clear() {
    for (const LocalEntity e : known_) {
        front_of_[e] = no_front;
        next_[e] = not_queued;
    }
    known_.clear();
    fronts_.clear();
    turns_.clear();
    ended_.clear();
    turn_ = 0;
    living_ = 0;
}

std::int32_t ReplacementEdgeSearch::front_above(LocalEntity entity, const Parents& parents) {
    path_.clear();
    while (front_of_[entity] == no_front && parents[entity] != LocalEntity{}) {
        path_.push_back(entity);
        entity = parents[entity];
    }
    const std::int32_t front = front_of_[entity] == no_front ? add_front(entity, true) : find(front_of_[entity]);
    for (const LocalEntity below : path_) {
        know(below, front);
    }
    return front;
}

std::int32_t ReplacementEdgeSearch::find(std::int32_t front) {
    while (at(front).joined != front) {
        at(front).joined = at(at(front).joined).joined;
        front = at(front).joined;
    }
    return front;
}

void ReplacementEdgeSearch::know(LocalEntity entity, std::int32_t front) {
    front_of_[entity] = front;
    known_.push_back(entity);
}

void ReplacementEdgeSearch::queue(LocalEntity entity, std::int32_t front) {
    next_[entity] = LocalEntity{};
    append(at(front).to_see, {entity, entity});
}

void ReplacementEdgeSearch::append(Queue& queue, Queue added) {
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

}  // namespace cracksim::topology
