#include "simulation/command_line.hpp"

#include <gtest/gtest.h>

#include "core/errors.hpp"

namespace cracksim::simulation {
namespace {

std::variant<CommandLine, Answer> parsed(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "cracksim");
    return parse(static_cast<int>(arguments.size()), arguments.data());
}

CommandLine command(const std::vector<const char*>& arguments) { return std::get<CommandLine>(parsed(arguments)); }

std::string error_of(const std::vector<const char*>& arguments) {
    try {
        static_cast<void>(parsed(arguments));
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(CommandLine, NeedsTheInputOnly) {
    const CommandLine c = command({"inputs/block.yaml"});
    EXPECT_EQ(c.input, "inputs/block.yaml");
    EXPECT_EQ(c.directory(), "block.out");
    EXPECT_TRUE(c.settings.empty());
    EXPECT_FALSE(c.out || c.dry_run || c.audit || c.quiet);
    EXPECT_EQ(c.progress, ProgressStyle::plain);
}

TEST(CommandLine, TakesEveryOptionInAnyOrder) {
    const CommandLine c =
        command({"--set", "time.end=0.5", "--audit", "a.b.yaml", "--set=block.cells=[1, 2, 3]", "--out", "d/e",
                 "--dry-run", "--quiet", "--progress", "live", "--set", "title=-x, y=z"});
    EXPECT_EQ(c.input, "a.b.yaml");
    EXPECT_EQ(c.directory(), "d/e");
    EXPECT_EQ(c.settings, (std::vector<std::string>{"time.end=0.5", "block.cells=[1, 2, 3]", "title=-x, y=z"}));
    EXPECT_TRUE(c.dry_run && c.audit && c.quiet);
    EXPECT_EQ(c.progress, ProgressStyle::live);
    EXPECT_EQ(command({"a.b.yaml"}).directory(), "a.b.out");
}

TEST(CommandLine, AnswersHelpAndVersion) {
    for (const char* flag : {"--help", "-h"}) {
        const auto answer = std::get<Answer>(parsed({flag}));
        EXPECT_EQ(answer.exit_code, 0);
        for (const char* option : {"INPUT.yaml", "--out", "--set", "--dry-run", "--audit", "--quiet", "--progress",
                                   "--simd", "--version", "--help"}) {
            EXPECT_NE(answer.text.find(option), std::string::npos) << option;
        }
    }
    const auto version = std::get<Answer>(parsed({"--version"}));
    EXPECT_EQ(version.exit_code, 0);
    EXPECT_EQ(version.text.find("cracksim"), 0U);
}

TEST(CommandLine, ExplainsWhatIsWrong) {
    EXPECT_EQ(error_of({}), "no input is named; say cracksim INPUT.yaml, such as cracksim inputs/block.yaml");
    EXPECT_EQ(error_of({"--version", "--dryrun"}), "--dryrun: unknown option; did you mean '--dry-run'?");
    EXPECT_EQ(error_of({"a.yaml", "--dryrun"}), "--dryrun: unknown option; did you mean '--dry-run'?");
    EXPECT_EQ(error_of({"a.yaml", "--ouput=x"}), "--ouput=x: unknown option; did you mean '--out'?");
    EXPECT_EQ(error_of({"a.yaml", "b.yaml"}),
              "b.yaml: there is one INPUT.yaml a run; to change a value use --set key.path=value");
    EXPECT_EQ(error_of({"a.yaml", "--progress", "lively"}), "--progress: does not know 'lively'; did you mean 'live'?");
    EXPECT_EQ(error_of({"a.yaml", "--quiet=maybe"}), "--quiet=maybe: takes no value; write --quiet");
}

TEST(CommandLine, OptionsDoNotTakeTheNextOptionForTheirValue) {
    const std::string needs = "--out: needs the name of a directory after it";
    const std::string hint = "; one whose name begins with - is written ./-name";
    EXPECT_EQ(error_of({"a.yaml", "--out", ""}), needs + hint);
    EXPECT_EQ(error_of({"a.yaml", "--out"}), needs + hint);
    EXPECT_EQ(error_of({"--out=", "a.yaml"}), needs + hint);
    EXPECT_EQ(error_of({"a.yaml", "--out", "--quiet"}), needs + ", not '--quiet'" + hint);
    EXPECT_EQ(error_of({"a.yaml", "--set"}),
              "--set: needs key.path=value after it; time.end=0.5 sets the end to 0.5 s");
    EXPECT_EQ(error_of({"a.yaml", "--out", "a", "--out=b"}), "--out: is given twice; give one");
    EXPECT_EQ(command({"a.yaml", "--out=-d"}).directory(), "-d");
    EXPECT_EQ(command({"a.yaml", "--set", "title=--out"}).settings.front(), "title=--out");
}

TEST(CommandLine, NamesOptionsThatComeLater) {
    EXPECT_EQ(error_of({"a.yaml", "--restart", "auto"}), "--restart: not available in cracksim 0.1; leave it out");
    EXPECT_EQ(error_of({"a.yaml", "--wall-time=60"}), "--wall-time: not available in cracksim 0.1; leave it out");
    EXPECT_EQ(error_of({"--petsc", "-ksp_type cg", "a.yaml"}), "--petsc: not available in cracksim 0.1; leave it out");
}

}  // namespace
}  // namespace cracksim::simulation
