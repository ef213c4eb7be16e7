// A file of results that is known to be writable before the work begins.
#pragma once

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>

namespace islet::tools {

class OutputFile {
public:
    /// An empty path is no file: good, and writing to it does nothing.
    explicit OutputFile(const std::string& path) : path_(path) {
        if (path.empty()) return;
        errno = 0;
        file_.open(path, std::ios::binary);
        if (!file_.good()) failed("cannot write");
    }
    bool is_open() const { return file_.is_open(); }
    bool good() const { return path_.empty() || file_.good(); }
    /// What failed first, with the reason: "cannot write 'out.csv': Permission denied".
    const std::string& error() const { return error_; }
    /// True if all of it, and all before it, was written.
    bool write(std::string_view text) {
        if (path_.empty()) return true;
        errno = 0;
        file_.write(text.data(), static_cast<std::streamsize>(text.size()));
        if (!file_.good()) failed("cannot write all of");
        return file_.good();
    }
    /// True if all of it has reached the file.
    bool close() {
        if (!file_.is_open()) return path_.empty();
        errno = 0;
        file_.close();
        if (!file_.good()) failed("cannot write all of");
        return file_.good();
    }
    const std::string& path() const { return path_; }

private:
    void failed(const char* what) {
        if (error_.empty()) error_ = std::string(what) + " '" + path_ + "'" + (errno != 0 ? std::string(": ") + std::strerror(errno) : std::string());
    }

    std::string path_, error_;
    std::ofstream file_;
};

/// True if all that was printed so far has reached its end.
inline bool all_printed() { return std::fflush(stdout) == 0 && std::ferror(stdout) == 0; }

}  // namespace islet::tools
