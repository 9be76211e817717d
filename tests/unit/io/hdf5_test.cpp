#include "io/hdf5.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "io/file_error.hpp"
#include "unit/io/scratch.hpp"

namespace cracksim::io::hdf5 {
namespace {

std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const FileError& error) {
        return error.what();
    }
    return "nothing thrown";
}

TEST(Hdf5, RowsSpreadOverTheRanksReadBackInGlobalOrder) {
    const Scratch scratch;
    const std::int64_t rank = world().rank().value();
    {
        File file{scratch / "a.hdf", Access::create, world().handle()};
        // Rank r has r rows, so the root has none.
        const std::vector<Vec3> own(static_cast<std::size_t>(rank), Vec3{static_cast<double>(rank), 2, 3});
        file.create<Vec3>("/points", world().sum(rank) + 1);
        file.write("/points", world().sum_below(rank), std::span<const Vec3>{own});
        const Vec3 last{-1, -1, -1};
        file.write("/points", world().sum(rank), std::span<const Vec3>{&last, world().is_root() ? 1U : 0U});
        file.close();
    }
    const std::vector<Vec3> points = File{scratch / "a.hdf", Access::read}.read<Vec3>("/points");
    std::vector<Vec3> expected;
    for (int r = 0; r < world().size(); ++r) {
        expected.insert(expected.end(), static_cast<std::size_t>(r), Vec3{static_cast<double>(r), 2, 3});
    }
    expected.push_back({-1, -1, -1});
    EXPECT_EQ(points, expected);
}

TEST(Hdf5, DatasetWithoutRowsIsWrittenByAllRanksWithoutFailure) {
    const Scratch scratch;
    File file{scratch / "a.hdf", Access::create, world().handle()};
    file.create<double>("/none", 0);
    EXPECT_NO_THROW(file.write("/none", 0, std::span<const double>{}));
    file.close();
}

TEST(Hdf5, AppendedRowsFollowTheOldOnes) {
    const Scratch scratch;
    if (!world().is_root()) {
        return;
    }
    std::vector<std::int64_t> all;
    for (std::int64_t go = 0; go < 3; ++go) {
        File file{scratch / "a.hdf", go == 0 ? Access::create : Access::modify};
        if (go == 0) {
            file.create_extendible<std::int64_t>("/rows");
        }
        const std::vector<std::int64_t> rows(5000, go);
        file.append("/rows", std::span<const std::int64_t>{rows});
        all.insert(all.end(), rows.begin(), rows.end());
        file.close();
    }
    EXPECT_EQ((File{scratch / "a.hdf", Access::read}.read<std::int64_t>("/rows")), all);
}

TEST(Hdf5, AttributesReadBack) {
    const Scratch scratch;
    if (world().is_root()) {
        File file{scratch / "a.hdf", Access::create};
        file.create_group("/group");
        file.set_attribute("/group", "numbers", std::vector<std::int64_t>{1, -2});
        file.set_attribute("/group", "text", "UnstructuredGrid");
        EXPECT_EQ(file.integer_attribute("/group", "numbers"), (std::vector<std::int64_t>{1, -2}));
        EXPECT_EQ(file.text_attribute("/group", "text"), "UnstructuredGrid");
        file.close();
    }
}

TEST(Hdf5, ErrorsNameFileAndOperationAndAreNotPrinted) {
    const Scratch scratch;
    testing::internal::CaptureStderr();
    EXPECT_TRUE(message_of([] { File{"/nowhere/a.hdf", Access::create}; }).starts_with("cannot create /nowhere/a.hdf"));
    const std::string name = (scratch / "none.hdf").string();
    EXPECT_TRUE(message_of([&] { File{name, Access::read}; }).starts_with("cannot open " + name));
    MPI_Barrier(world().handle());
    if (world().is_root()) {
        const std::string made = (scratch / "a.hdf").string();
        File file{made, Access::create};
        EXPECT_TRUE(message_of([&] { (void)file.rows("/x"); }).starts_with("cannot find the dataset /x in " + made));
        file.close();
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace cracksim::io::hdf5
