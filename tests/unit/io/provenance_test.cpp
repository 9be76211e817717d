#include "io/provenance.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace cracksim::io {
namespace {

TEST(Provenance, SaysWhatWasBuiltAndWhereItRuns) {
    const Provenance found = collect_provenance();
    EXPECT_NE(found.flags.find("-ffp-contract=off"), std::string::npos);
    EXPECT_EQ(found.flags.find("-Wall"), std::string::npos);
    EXPECT_FALSE(found.version.empty());
    EXPECT_FALSE(found.git.empty());
    EXPECT_FALSE(found.cpu.empty());
    EXPECT_FALSE(found.host.empty());
    EXPECT_NE(std::ranges::find(found.libraries, "HDF5", &std::pair<std::string, std::string>::first),
              found.libraries.end());
}

TEST(Provenance, VersionLineNamesProgramAndRevision) {
    const Provenance found = collect_provenance();
    EXPECT_TRUE(version_line().starts_with("cracksim " + found.version + " (" + found.git));
}

}  // namespace
}  // namespace cracksim::io
