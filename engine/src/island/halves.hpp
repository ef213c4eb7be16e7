// Two workers share a large batch: each sweeps the contacts of one half of it, where the other cannot disturb it.
//
// Swept colour by colour, the contacts of a batch would take two workers a wait for each colour, and most bodies would go from one core to the other and back.
// So the bodies of the largest batch are cut into halves, left and right or below and above. A contact waits if it lies between the halves, or if another that
// waits, or a joint, comes before it at one of its bodies. The workers sweep what does not wait, each in the order of colours; then follows what waits, in the
// order of colours, too. So the constraints of each body are solved in the order of their colours, as in a batch without halves, and the bits are the same. In
// heaps of thousands of bodies 3 to 6 % of the contacts wait. (With more workers, more would, and each would have a smaller part; these share colours.)
#pragma once

#include "../island/batches.hpp"
#include "../island/contact_list.hpp"

namespace islet::detail {

/// Which half of a batch each body is in.
struct BodyHalves {
    std::uint32_t batch = null_index;  // null_index: no batch has halves
    std::uint8_t* of = nullptr;        // by body: 0, 1, or `none` for bodies of other batches, and for those that cannot be pushed
    static constexpr std::uint8_t none = 0xff;

    /// The place of a body's half among the batches, if the body's batch has halves.
    std::uint32_t place_of(const Plan& plan, std::uint32_t body) const { return plan.batch_count + (of[body] == 1 ? 1 : 0); }
};

/// Cuts the largest batch, and gives its halves their places after the batches, if two workers are to solve it, and it is worth it.
BodyHalves cut_in_halves(const Core& core, Plan& plan, const Islands& found, Arena& temporary);

/// Notes in the list which contacts do not wait, and in which half they are.
void halve_contacts(const Core& core, const Plan& plan, const BodyHalves& halves, const ContactList& list, const PlannedConstraint* joints, Arena temporary);

}  // namespace islet::detail
