#include "recorded_joints.hpp"

namespace islet::samples {

std::vector<RecordedJoint> collect_joints(const World& /*world*/) {
    // The engine has no joints yet; everything after this is ready for them.
    return {};
}

}  // namespace islet::samples
