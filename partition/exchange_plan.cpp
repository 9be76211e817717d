#include "partition/exchange_plan.hpp"

#include <petscsf.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "core/sorted.hpp"

namespace cracksim::partition {

namespace {

void check(PetscErrorCode code) {
    if (code != 0) {
        throw std::runtime_error{"PetscSF failed with code " + std::to_string(code)};
    }
}

using Lists = std::vector<std::vector<std::int64_t>>;

/// The requested ids of all ranks, ascending, each once.
std::vector<std::int64_t> merged(const Lists& requests) {
    std::vector<std::int64_t> all;
    for (const auto& list : requests) {
        all.insert(all.end(), list.begin(), list.end());
    }
    sort_and_make_unique(all);
    return all;
}

/// The index of each requested id in an ascending list.
Lists places_in(const std::vector<std::int64_t>& ids, const Lists& requests) {
    Lists places(requests.size());
    for (std::size_t r = 0; r < requests.size(); ++r) {
        for (const std::int64_t id : requests[r]) {
            places[r].push_back(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
        }
    }
    return places;
}

std::vector<ExchangePlan::Side> sides_of(const Lists& places) {
    std::vector<ExchangePlan::Side> sides;
    for (std::size_t r = 0; r < places.size(); ++r) {
        if (!places[r].empty()) {
            sides.push_back({Rank{static_cast<std::int32_t>(r)}, {places[r].begin(), places[r].end()}});
        }
    }
    return sides;
}

}  // namespace

class ExchangePlan::Forest {
public:
    Forest(MPI_Comm comm, std::size_t roots, std::vector<PetscSFNode> leaves) {
        check(PetscSFCreate(comm, &forest_));
        check(PetscSFSetFromOptions(forest_));
        check(PetscSFSetGraph(forest_, static_cast<PetscInt>(roots), static_cast<PetscInt>(leaves.size()), nullptr,
                              PETSC_COPY_VALUES, leaves.data(), PETSC_COPY_VALUES));
        check(PetscSFSetUp(forest_));
    }
    Forest(const Forest&) = delete;
    Forest& operator=(const Forest&) = delete;
    ~Forest() {
        for (auto& [bytes, unit] : units_) {
            MPI_Type_free(&unit);
        }
        PetscSFDestroy(&forest_);
    }

    void begin(std::size_t bytes, const void* roots, void* leaves) {
        check(PetscSFBcastBegin(forest_, unit_of(bytes), roots, leaves, MPI_REPLACE));
    }
    void end(std::size_t bytes, const void* roots, void* leaves) {
        check(PetscSFBcastEnd(forest_, unit_of(bytes), roots, leaves, MPI_REPLACE));
    }

private:
    MPI_Datatype unit_of(std::size_t bytes) {
        const auto found = units_.find(bytes);
        if (found != units_.end()) {
            return found->second;
        }
        MPI_Datatype unit = MPI_DATATYPE_NULL;
        const bool doubles = bytes % sizeof(double) == 0;
        MPI_Type_contiguous(static_cast<int>(doubles ? bytes / sizeof(double) : bytes),
                            doubles ? MPI_DOUBLE : MPI_UNSIGNED_CHAR, &unit);
        MPI_Type_commit(&unit);
        units_.emplace(bytes, unit);
        return unit;
    }

    PetscSF forest_{nullptr};
    std::map<std::size_t, MPI_Datatype> units_;
};

void ExchangePlan::ForestDeleter::operator()(Forest* forest) const { delete forest; }

ExchangePlan::ExchangePlan(const Communicator& comm, std::vector<std::int64_t> needed, std::span<const Rank> owner)
    : received_{std::move(needed)} {
    CRACKSIM_EXPECT(std::is_sorted(received_.begin(), received_.end()) && owner.size() == received_.size());
    Lists requests(static_cast<std::size_t>(comm.size()));
    for (std::size_t i = 0; i < received_.size(); ++i) {
        requests[owner[i].index()].push_back(received_[i]);
    }
    const Lists asked = comm.exchange(requests);
    sent_ = merged(asked);
    const Lists sent_places = places_in(sent_, asked);
    const Lists places = comm.exchange(sent_places);
    targets_ = sides_of(sent_places);
    sources_ = sides_of(places_in(received_, requests));

    std::vector<std::size_t> next(requests.size(), 0);
    std::vector<PetscSFNode> leaves;
    for (const Rank rank : owner) {
        const std::int64_t place = places[rank.index()][next[rank.index()]++];
        leaves.push_back({rank.value(), static_cast<PetscInt>(place)});
    }
    forest_.reset(new Forest{comm.handle(), sent_.size(), std::move(leaves)});
    for (std::size_t r = 0; r < requests.size(); ++r) {
        neighbours_ += requests[r].empty() && asked[r].empty() ? 0 : 1;
        values_sent_ += static_cast<std::int64_t>(asked[r].size());
    }
}

PendingExchange::PendingExchange(const ExchangePlan& plan, std::size_t unit, const void* values, void* received_values)
    : plan_{&plan}, unit_{unit}, values_{values}, received_values_{received_values} {
    plan.forest_->begin(unit, values, received_values);
}

void PendingExchange::end() {
    CRACKSIM_EXPECT(!ended_);
    ended_ = true;
    plan_->forest_->end(unit_, values_, received_values_);
}

PendingExchange::~PendingExchange() {
    if (!ended_) {
        try {
            end();
        } catch (const std::exception&) {
            // The stack is being unwound: the exception that caused it is reported and ends the run on all ranks.
        }
    }
}

}  // namespace cracksim::partition
