#include "sweep_cluster.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <vector>

namespace islet::tools {

std::string sweep_on_cluster(int argc, char** argv) {
    std::string program(argv[0]);
    std::error_code error;
    if (const auto path = std::filesystem::read_symlink("/proc/self/exe", error); !error) program = path.string();
    std::vector<std::string> words = {"python3", "-m", "islet.sweep", "--program", program};
    words.insert(words.end(), argv + 2, argv + argc);
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    execvp(pointers[0], pointers.data());
    return std::string("cannot start python3: ") + std::strerror(errno);
}

}  // namespace islet::tools
