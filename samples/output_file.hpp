// A file of results that is known to be writable before the work begins.
#pragma once

#include <cstdio>
#include <fstream>
#include <string>

namespace islet::samples {

class OutputFile {
public:
    /// An empty path is no file: good, and writing to it does nothing.
    explicit OutputFile(const std::string& path) : path_(path) {
        if (!path.empty()) file_.open(path, std::ios::binary);
    }
    bool good() const { return path_.empty() || file_.good(); }
    /// True if all of it was written.
    bool write(const std::string& text) {
        if (path_.empty()) return true;
        file_ << text << std::flush;
        return file_.good();
    }
    const std::string& path() const { return path_; }

private:
    std::string path_;
    std::ofstream file_;
};

/// True if all that was printed so far has reached its end.
inline bool all_printed() { return std::fflush(stdout) == 0 && std::ferror(stdout) == 0; }

}  // namespace islet::samples
