// The contacts of a world that has not made a step yet, and so does not know them.
#pragma once

#include <vector>

#include <islet/islet.hpp>

namespace islet::tools {

/// A copy of a world that has gone on by the shortest step, a microsecond. It has no hooks: those of a scene may count their calls.
class FirstContacts {
public:
    explicit FirstContacts(const World& world);

    /// The copy, or the world itself if it cannot be copied.
    const World& world() const { return *world_; }

private:
    std::vector<std::byte> block_, image_;
    const World* world_;
};

}  // namespace islet::tools
