// Files that are read as a whole, and what a file is that was expected to be another.
#pragma once

#include <stdexcept>
#include <string>

namespace islet::tools {

/// A sentence with the reason.
struct FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// All bytes of a file. Throws a FileError if it cannot be read, or is a folder.
std::string read_file(const std::string& path);
/// What bytes look like: "a recording", "a snapshot", "a JSON file", ..., or "a file of another kind".
std::string kind_of(const std::string& bytes);

}  // namespace islet::tools
