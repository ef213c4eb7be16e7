#include "read_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace islet::tools {

std::string read_file(const std::string& path) {
    const auto fail = [] { throw FileError(std::string("cannot be read: ") + std::strerror(errno)); };
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) fail();
    std::string bytes;
    char piece[65536];
    for (;;) {
        const std::size_t count = std::fread(piece, 1, sizeof piece, file.get());
        bytes.append(piece, count);
        if (count < sizeof piece) break;
    }
    if (std::ferror(file.get()) != 0) fail();  // of a folder: here
    return bytes;
}

std::string kind_of(const std::string& bytes) {
    const std::size_t text = bytes.find_first_not_of(" \t\r\n");
    if (text == std::string::npos) return "an empty file";
    const auto begins = [&](const char* with) { return bytes.compare(text, std::strlen(with), with) == 0; };
    if (begins("IltR")) return "a recording";
    if (begins("ISLT")) return "a snapshot";
    if (begins("{") || begins("[")) return "a JSON file";
    if (begins("<svg")) return "a picture";
    if (begins("<")) return "a page";
    if (begins("step,")) return "a table of steps";
    return "a file of another kind";
}

}  // namespace islet::tools
