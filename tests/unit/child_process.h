// Child processes for tests of a hostile disk: they may give up rights, limit themselves or mount
// file systems without a trace in the test's own process.
#pragma once

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace splineloft {

/// What became of a function that ran in a process of its own.
struct Ending {
    bool couldStart = false; ///< `prepare` answered true
    std::string said;
};

/// Runs `prepare` and, where that answers true, `act` in a child process, which may give up rights
/// or mount file systems without a trace here. The result is what `act` returned.
inline Ending inChild(const std::function<bool()>& prepare,
                      const std::function<std::string()>& act) {
    int ends[2];
    if (::pipe(ends) != 0) {
        return {};
    }
    const auto child = ::fork();
    if (child == 0) {
        const std::string said = prepare() ? "+" + act() : "-";
        [[maybe_unused]] const auto count = ::write(ends[1], said.data(), said.size());
        ::_exit(0);
    }
    ::close(ends[1]);
    std::string said;
    char letter = 0;
    while (::read(ends[0], &letter, 1) == 1) {
        said += letter;
    }
    ::close(ends[0]);
    ::waitpid(child, nullptr, 0);
    return {said.starts_with('+'), said.empty() ? "" : said.substr(1)};
}

/// Files may become so many bytes long and no longer.
inline bool limitFiles(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, bytes};
    return ::setrlimit(RLIMIT_FSIZE, &limit) == 0;
}

/// Become somebody without special rights, where this process has them.
inline bool becomeNobody() {
    constexpr uid_t nobody = 65534;
    return ::geteuid() != 0 || (::setgid(nobody) == 0 && ::setuid(nobody) == 0);
}

/// This process gets mounts of its own; without root's rights by being root among its own users.
inline bool mayMount() {
    const auto tell = [](const char* file, const std::string& text) {
        std::ofstream(file) << text;
    };
    const auto user = std::to_string(::geteuid());
    const auto group = std::to_string(::getegid());
    if (::unshare(CLONE_NEWNS) == 0) {
        return true;
    }
    if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) {
        return false;
    }
    tell("/proc/self/setgroups", "deny");
    tell("/proc/self/uid_map", "0 " + user + " 1");
    tell("/proc/self/gid_map", "0 " + group + " 1");
    return true;
}

/// A small file system of its own, mounted at `folder`, seen by this process alone.
inline bool mountSmall(const std::filesystem::path& folder) {
    if (!mayMount()) {
        return false;
    }
    ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr);
    return ::mount("none", folder.c_str(), "tmpfs", 0, "size=16k,mode=777") == 0;
}

} // namespace splineloft
