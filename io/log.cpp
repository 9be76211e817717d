#include "io/log.hpp"

#include <spdlog/logger.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include "io/collective_errors.hpp"
#include "io/file_error.hpp"

namespace cracksim::io {

namespace {

std::unique_ptr<spdlog::logger> make_logger(spdlog::sink_ptr sink, const std::string& pattern) {
    auto logger = std::make_unique<spdlog::logger>("cracksim", std::move(sink));
    logger->set_pattern(pattern);
    logger->flush_on(spdlog::level::info);
    return logger;
}

// A failure to write the log does not stop a run; the run's other files report errors of the same disk.
void ignore(const std::string& /*message*/) {}

}  // namespace

struct Log::Sinks {
    std::unique_ptr<spdlog::logger> problems = make_logger(std::make_shared<spdlog::sinks::stderr_sink_st>(), "%l: %v");
    std::unique_ptr<spdlog::logger> file;

    void to_file(spdlog::level::level_enum level, const std::string& text) const {
        if (file) {
            file->log(level, text);
        }
    }
};

Log::Log(const partition::Communicator& comm, bool quiet) : comm_{&comm}, quiet_{quiet} {
    if (comm.is_root()) {
        sinks_ = std::make_unique<Sinks>();
    }
}

Log::~Log() { wipe_live_line(); }

void Log::open(const std::filesystem::path& file) {
    on_root(*comm_, [&] {
        try {
            constexpr bool truncate = true;
            sinks_->file = make_logger(std::make_shared<spdlog::sinks::basic_file_sink_st>(file.string(), truncate),
                                       "%Y-%m-%d %H:%M:%S.%e %l: %v");
            sinks_->file->set_error_handler(ignore);
        } catch (const spdlog::spdlog_ex& failure) {
            throw FileError{"cannot create " + file.string() + ": " + failure.what(), false};
        }
    });
}

void Log::info(const std::string& text) {
    if (!sinks_) {
        return;
    }
    wipe_live_line();
    if (!quiet_) {
        print(text + "\n");
    }
    sinks_->to_file(spdlog::level::info, text);
}

void Log::warn(const std::string& text) {
    if (!sinks_) {
        return;
    }
    wipe_live_line();
    sinks_->problems->warn(text);
    sinks_->to_file(spdlog::level::warn, text);
}

void Log::error(const std::string& text) {
    if (!sinks_) {
        return;
    }
    wipe_live_line();
    sinks_->problems->error(text);
    sinks_->to_file(spdlog::level::err, text);
}

// Blanks overwrite the rest of a longer line; escape sequences would be visible in redirected output.
void Log::live(const std::string& text) {
    if (!sinks_ || quiet_) {
        return;
    }
    const std::string blanks(live_width_ > text.size() ? live_width_ - text.size() : 0, ' ');
    print("\r" + text + blanks);
    live_width_ = text.size();
}

// After a failure stdout is redirected to /dev/null: text that stays in its buffer would fail again at exit, where
// PETSc prints pages about it.
void Log::print(const std::string& text) {
    errno = 0;
    if (std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0) {
        return;
    }
    const std::string why = errno != 0 ? std::generic_category().message(errno) : "it is closed";
    lost_terminal_ = true;
    if (std::freopen("/dev/null", "w", stdout) == nullptr) {
        sinks_->problems->error("nothing can be opened in place of standard output");
    }
    error("standard output cannot be written: " + why +
          (sinks_->file ? "; the run goes on, and its lines are in its cracksim.log" : ""));
}

void Log::wipe_live_line() {
    if (live_width_ > 0) {
        print("\r" + std::string(std::exchange(live_width_, 0), ' ') + "\r");
    }
}

}  // namespace cracksim::io
