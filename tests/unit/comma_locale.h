// A locale in which a half is written "0,5", to see that files do not follow it.
#pragma once

#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <string>
#include <unistd.h>
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

namespace splineloft {

/// Sets the locale of C and of C++ as long as it lives. Made on the spot where the system has none.
class CommaLocale {
  public:
    CommaLocale() {
        if (!set()) {
            make();
            set();
        }
    }
    CommaLocale(const CommaLocale&) = delete;
    CommaLocale& operator=(const CommaLocale&) = delete;
    ~CommaLocale() {
        std::locale::global(std::locale::classic());
        std::setlocale(LC_ALL, "C");
        if (!folder_.empty()) {
            std::filesystem::remove_all(folder_);
            ::unsetenv("LOCPATH");
        }
    }

    bool works() const { return std::string(std::localeconv()->decimal_point) == ","; }

  private:
    static constexpr const char* name = "de_DE.UTF-8";

    static bool set() {
#ifdef __SANITIZE_ADDRESS__
        const __lsan::ScopedDisabler theLibraryNeverFreesWhatItReadsFromLocpath;
#endif
        if (std::setlocale(LC_ALL, name) == nullptr) {
            return false;
        }
        std::locale::global(std::locale(name));
        return true;
    }

    void make() {
        folder_ = std::filesystem::temp_directory_path() /
                  ("splineloft-locale-" + std::to_string(::getpid()));
        std::filesystem::create_directories(folder_);
        const std::string command =
            "localedef -i de_DE -f UTF-8 '" + (folder_ / name).string() + "' >/dev/null 2>&1";
        if (std::system(command.c_str()) == 0) {
            ::setenv("LOCPATH", folder_.c_str(), 1);
        }
    }

    std::filesystem::path folder_;
};

/// Whether missing tools make a test fail instead of being skipped.
inline bool mustNotSkip() {
    return std::getenv("CI") != nullptr;
}

} // namespace splineloft

/// Ends the test where there is no such locale: as a failure in continuous integration.
#define SPLINELOFT_NEED_COMMA(commaLocale)                                                         \
    if (!(commaLocale).works()) {                                                                  \
        ASSERT_FALSE(splineloft::mustNotSkip())                                                    \
            << "no locale with a decimal comma: install locales";                                  \
        GTEST_SKIP() << "SKIPPED: no locale with a decimal comma could be made (install locales)"; \
    }
