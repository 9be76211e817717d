#include "io/frame_writer.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "io/file_error.hpp"
#include "io/hdf5.hpp"
#include "io/vtkhdf.hpp"
#include "unit/io/scratch.hpp"
#include "unit/io/strip_mesh.hpp"

namespace cracksim::io {
namespace {

/// Runs each test for both ways of writing: gathered on the root, and by all ranks at once (a limit of 0 bytes).
class FrameWriting : public testing::TestWithParam<std::int64_t> {
protected:
    void SetUp() override {
        if (world().is_root()) {
            std::filesystem::create_directory(scratch_ / "frames");
        }
        MPI_Barrier(world().handle());
    }
    [[nodiscard]] hdf5::File frame(const std::string& file) const { return {scratch_ / file, hdf5::Access::read}; }

    Scratch scratch_;
    FrameWriter surface_{world(), scratch_.path(), "surface", GetParam()};
};

std::string way(const testing::TestParamInfo<std::int64_t>& info) {
    return info.param == 0 ? "ByAllRanks" : "ByTheRoot";
}

INSTANTIATE_TEST_SUITE_P(Frames, FrameWriting, testing::Values(0, FrameWriter::default_gather_below), way);

TEST_P(FrameWriting, DatasetsAreTheWholeMeshOnAnyNumberOfRanks) {
    constexpr std::int64_t cells = 11;
    const FrameRecord record = surface_.write(strip_mesh(world(), cells, 0.5), 7, 0.125);
    const hdf5::File file = frame(record.file);
    const std::vector<Vec3> points = file.read<Vec3>("/VTKHDF/Points");
    const auto connectivity = file.read<std::int64_t>("/VTKHDF/Connectivity");
    const auto offsets = file.read<std::int64_t>("/VTKHDF/Offsets");
    const auto opening = file.read<double>("/VTKHDF/CellData/opening");
    ASSERT_EQ(points.size(), 2U * (cells + 1));
    ASSERT_EQ(connectivity.size(), 4U * cells);
    ASSERT_EQ(offsets.size(), cells + 1U);
    EXPECT_EQ(points[9], (Vec3{4, 1, 8}));
    EXPECT_EQ(file.read<std::uint8_t>("/VTKHDF/Types"), std::vector<std::uint8_t>(cells, 9));
    for (std::size_t cell = 0; cell < cells; ++cell) {
        const auto c = static_cast<std::int64_t>(cell);
        EXPECT_EQ(connectivity[4 * cell + 2], 2 * c + 3);
        EXPECT_EQ(offsets[cell + 1], 4 * (c + 1));
        EXPECT_EQ(file.read<std::int64_t>("/VTKHDF/CellData/entity")[cell], 1000 + c);
        EXPECT_EQ(opening[cell], 0.1 * static_cast<double>(c));
    }
}

TEST_P(FrameWriting, SizesStepAndTimeStandInTheFile) {
    const FrameRecord record = surface_.write(strip_mesh(world(), 3, 0), 7, 0.1);
    const hdf5::File file = frame(record.file);
    EXPECT_EQ(file.text_attribute("/VTKHDF", "Type"), "UnstructuredGrid");
    EXPECT_EQ(file.integer_attribute("/VTKHDF", "Version"), (std::vector<std::int64_t>{1, 0}));
    EXPECT_EQ(file.read<std::int64_t>("/VTKHDF/NumberOfPoints"), std::vector<std::int64_t>{8});
    EXPECT_EQ(file.read<std::int64_t>("/VTKHDF/NumberOfCells"), std::vector<std::int64_t>{3});
    EXPECT_EQ(file.read<std::int64_t>("/VTKHDF/NumberOfConnectivityIds"), std::vector<std::int64_t>{12});
    EXPECT_EQ(file.read<std::int64_t>("/VTKHDF/FieldData/Step"), std::vector<std::int64_t>{7});
    EXPECT_EQ(file.read<double>("/VTKHDF/FieldData/TimeValue"), std::vector<double>{0.1});
}

TEST_P(FrameWriting, RecordSaysWhatWasWritten) {
    const FrameRecord record = surface_.write(strip_mesh(world(), 5, 0), 42, 0.5);
    EXPECT_TRUE(record.written());
    EXPECT_EQ(record.file, "frames/surface-000000.hdf");
    EXPECT_EQ(record.step, 42);
    EXPECT_EQ(record.time, 0.5);
    EXPECT_EQ(record.faces, 5);
    EXPECT_EQ(record.points, 12);
}

TEST_P(FrameWriting, FrameWithoutACellIsLeftOut) {
    EXPECT_FALSE(surface_.write(strip_mesh(world(), 0, 0), 0, 0).written());
    EXPECT_FALSE(surface_.write(geometry::Mesh{}, 0, 0).written());
    EXPECT_TRUE(std::filesystem::is_empty(scratch_ / "frames"));
    EXPECT_FALSE(std::filesystem::exists(scratch_ / "surface.xdmf"));
    EXPECT_EQ(surface_.write(strip_mesh(world(), 1, 0), 1, 0.1).file, "frames/surface-000000.hdf");
    EXPECT_EQ(surface_.series().frames.size(), 1U);
}

TEST_P(FrameWriting, OneRankMayHoldTheWholeMeshAndTheOthersADefaultOne) {
    partition::Communicator alone{MPI_COMM_SELF};
    const bool last = world().rank().value() == world().size() - 1;
    FrameWriter masses{world(), scratch_.path(), "masses", GetParam()};
    const FrameRecord record = masses.write(last ? point_mesh(alone, 4) : geometry::Mesh{}, 0, 0);
    const hdf5::File file = frame(record.file);
    EXPECT_EQ(file.read<std::uint8_t>("/VTKHDF/Types"), std::vector<std::uint8_t>(4, 1));
    EXPECT_EQ(file.read<std::int64_t>("/VTKHDF/Connectivity"), (std::vector<std::int64_t>{0, 1, 2, 3}));
    EXPECT_EQ(file.read<std::int64_t>("/VTKHDF/Offsets"), (std::vector<std::int64_t>{0, 1, 2, 3, 4}));
    EXPECT_EQ(file.read<double>("/VTKHDF/CellData/speed"), (std::vector<double>{0, 1, 2, 3}));
}

TEST_P(FrameWriting, IndexesListAllFramesWithTheirTimesAndSizes) {
    surface_.write(strip_mesh(world(), 2, 0), 0, 0);
    surface_.write(strip_mesh(world(), 0, 0), 5, 0.05);
    surface_.write(strip_mesh(world(), 3, 0), 10, 0.1);
    surface_.finish_index();
    const nlohmann::json series = nlohmann::json::parse(text_of(scratch_ / "surface.hdf.series"));
    ASSERT_EQ(series["files"].size(), 2U);
    EXPECT_EQ(series["files"][1]["name"], "frames/surface-000001.hdf");
    EXPECT_EQ(series["files"][1]["time"], 0.1);
    pugi::xml_document xdmf;
    ASSERT_TRUE(xdmf.load_file((scratch_ / "surface.xdmf").c_str()));
    const auto grids = xdmf.select_nodes("/Xdmf/Domain/Grid[@CollectionType='Temporal']/Grid");
    ASSERT_EQ(grids.size(), 2U);
    EXPECT_EQ(grids[1].node().child("Time").attribute("Value").as_double(), 0.1);
    const pugi::xml_node connectivity = grids[1].node().child("Topology").child("DataItem");
    EXPECT_STREQ(connectivity.attribute("Dimensions").value(), "12");
    EXPECT_STREQ(connectivity.text().get(), "frames/surface-000001.hdf:/VTKHDF/Connectivity");
}

TEST_P(FrameWriting, NothingUnfinishedStays) {
    surface_.write(strip_mesh(world(), 2, 0), 0, 0);
    EXPECT_FALSE(has_unfinished(scratch_.path()));
}

TEST_P(FrameWriting, FieldOfAnotherLengthIsRefusedOnAllRanks) {
    geometry::Mesh mesh = strip_mesh(world(), 7, 0);
    if (world().rank().value() == world().size() - 1) {
        std::get<std::vector<double>>(mesh.fields[1].values).pop_back();
    }
    EXPECT_THROW(surface_.write(mesh, 0, 0), FileError);
}

/// Limits the size of files, so that writes fail half-way as on a full disk.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before_);
        struct rlimit limit = before_;
        limit.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
    struct rlimit before_ {};
};

TEST_P(FrameWriting, FailedWriteThrowsOnAllRanksAndLeavesTheSeriesAsItWas) {
    surface_.write(strip_mesh(world(), 2, 0), 0, 0);
    const geometry::Mesh mesh = strip_mesh(world(), 20000, 0);
    {
        const FileSizeLimit limit{200000};
        EXPECT_THROW(surface_.write(mesh, 1, 1), FileError);
    }
    MPI_Barrier(world().handle());
    EXPECT_FALSE(has_unfinished(scratch_.path()));
    EXPECT_EQ(surface_.series().frames.size(), 1U);
    EXPECT_EQ(surface_.write(mesh, 2, 2).file, "frames/surface-000001.hdf");
}

TEST_P(FrameWriting, FrameOfTheRootAloneIsTheOneThatAllWrite) {
    const geometry::Mesh whole = strip_mesh(partition::Communicator{MPI_COMM_SELF}, 11, 0.5);
    const FrameRecord together = surface_.write(strip_mesh(world(), 11, 0.5), 7, 0.125);
    const FrameRecord alone = world().is_root() ? surface_.write_alone(whole, 7, 0.125) : FrameRecord{};
    MPI_Barrier(world().handle());
    if (world().is_root()) {
        EXPECT_EQ(alone.file, "frames/surface-000001.hdf");
        EXPECT_EQ(alone.faces, together.faces);
        EXPECT_EQ(alone.points, together.points);
        const hdf5::File expected = frame(together.file);
        const hdf5::File found = frame(alone.file);
        EXPECT_EQ(found.read<Vec3>("/VTKHDF/Points"), expected.read<Vec3>("/VTKHDF/Points"));
        for (const char* name : {"/VTKHDF/Connectivity", "/VTKHDF/Offsets", "/VTKHDF/CellData/entity",
                                 "/VTKHDF/FieldData/Step", "/VTKHDF/NumberOfPoints"}) {
            EXPECT_EQ(found.read<std::int64_t>(name), expected.read<std::int64_t>(name)) << name;
        }
        for (const char* name : {"/VTKHDF/CellData/opening", "/VTKHDF/FieldData/TimeValue"}) {
            EXPECT_EQ(found.read<double>(name), expected.read<double>(name)) << name;
        }
    }
}

TEST_P(FrameWriting, FramesOfAllFollowThoseOfTheRootAlone) {
    const geometry::Mesh whole = strip_mesh(partition::Communicator{MPI_COMM_SELF}, 2, 0);
    if (world().is_root()) {
        EXPECT_FALSE(surface_.write_alone(strip_mesh(partition::Communicator{MPI_COMM_SELF}, 0, 0), 0, 0).written());
        surface_.write_alone(whole, 1, 0.1);
        surface_.write_alone(whole, 2, 0.2);
    }
    EXPECT_EQ(surface_.write(strip_mesh(world(), 3, 0), 3, 0.3).file, "frames/surface-000002.hdf");
    EXPECT_EQ(surface_.write(strip_mesh(world(), 3, 0), 4, 0.4).file, "frames/surface-000003.hdf");
    surface_.finish_index();
    const nlohmann::json series = nlohmann::json::parse(text_of(scratch_ / "surface.hdf.series"));
    EXPECT_EQ(series["files"].size(), 4U);
    EXPECT_EQ(surface_.series().frames.size(), world().is_root() ? 4U : 2U);
}

TEST_P(FrameWriting, FailedWriteOfTheRootAloneLeavesTheSeriesAsItWas) {
    if (world().is_root()) {
        const partition::Communicator alone{MPI_COMM_SELF};
        surface_.write_alone(strip_mesh(alone, 2, 0), 0, 0);
        {
            const FileSizeLimit limit{200000};
            EXPECT_THROW(surface_.write_alone(strip_mesh(alone, 20000, 0), 1, 1), FileError);
        }
        EXPECT_FALSE(has_unfinished(scratch_.path()));
        EXPECT_EQ(surface_.series().frames.size(), 1U);
        EXPECT_EQ(surface_.write_alone(strip_mesh(alone, 20000, 0), 2, 2).file, "frames/surface-000001.hdf");
    }
}

TEST_P(FrameWriting, SizesOfFramesAndIndexesAreKnownBeforehand) {
    constexpr std::int64_t frames = 5;
    constexpr std::int64_t cells = 20000;
    FrameRecord record;
    for (std::int64_t n = 0; n < frames; ++n) {
        record = surface_.write(strip_mesh(world(), cells, 0), n, 0.5);
    }
    surface_.finish_index();
    if (world().is_root()) {
        const CellLayout layout{geometry::CellKind::quadrilateral, {{"entity", true}, {"opening", false}}};
        const IndexedFrame frame{record, layout};
        const auto size = [&](const std::string& file) {
            return static_cast<std::int64_t>(std::filesystem::file_size(scratch_ / file));
        };
        // Ranks that write at once cut the file to its written size; not all of the space reserved for headers is used.
        const bool is_cut = GetParam() == 0 && world().size() > 1;
        EXPECT_LE(vtkhdf_bytes(frame) - size(record.file), is_cut ? 65536 : 0);
        EXPECT_GE(vtkhdf_bytes(frame), size(record.file));
        EXPECT_EQ(index_bytes("surface", frame, frames), size("surface.xdmf") + size("surface.hdf.series"));
        EXPECT_EQ(index_bytes("surface", frame, 0), 0);
    }
}

}  // namespace
}  // namespace cracksim::io
