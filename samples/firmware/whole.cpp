// Nothing but a world, linked with every function of the engine whether called or not: what tools/footprint.sh calls the whole engine.
#include <islet/islet.hpp>

#include "board.hpp"

namespace firmware {

static islet::StaticWorld<islet::Capacity{.bodies = 16, .shapes = 16, .contacts = 48, .joints = 4}> storage;

int run() {
    storage.create().step(1.0f / 60);
    return 0;
}

}  // namespace firmware
