// Which contacts a block of rows holds, and of what material they are.
#pragma once

#include "../constraint/contact_bounce.hpp"
#include "../data/core.hpp"
#include "../graph/mixing.hpp"
#include "../math/inlining.hpp"

namespace islet::detail {

/// Fills in the material of one lane of a block that has special or bouncy contacts. `flags` are its own contact's.
template <std::uint32_t W>
ISLET_PART void set_surface(ContactRows<W>& r, std::uint32_t lane, std::uint32_t flags, const MixedSurface& surface) {
    const bool special = W == 1 || (flags & contact_special) != 0;  // a block of one contact is read only if it is special
    restitution_of(r)[lane] = (flags & contact_bouncy) != 0 ? surface.restitution : 0;
    if (!has_surfaces) return;
    r.rolling_resistance[lane] = special ? surface.rolling_resistance : 0;
    r.tangent_speed[lane] = special ? surface.tangent_speed : 0;
}

/// Fills in the contacts of each block, and the materials of those that are special or bouncy.
template <std::uint32_t W>
void name_contacts(Core& core, ContactRows<W>* rows, std::uint32_t count, const PlanIndex* contacts) {
    for (std::uint32_t block = 0; block < count; ++block) {
        ContactRows<W>& r = rows[block];
        std::uint32_t any = 0;
        for (std::uint32_t i = 0; i < W; ++i) {
            const std::uint32_t c = index_of(contacts[block * W + i]);
            const std::uint32_t soon = block + 1 < count ? index_of(contacts[(block + 1) * W + i]) : null_index;
            if (W > 1 && soon != null_index) {  // the next block's contacts may be anywhere in memory
                ISLET_PREFETCH(&core.manifolds[soon].flags);
                ISLET_PREFETCH(&core.contacts[soon]);
            }
            set_contact(r, i, c, core.manifolds);
            if (c != null_index) any |= core.manifolds[c].flags;
        }
        if ((any & (contact_special | contact_bouncy | contact_hits)) == 0) continue;
        for (std::uint32_t i = 0; i < W; ++i) {
            // A contact's own flags decide, whatever the other contacts of the block have, and whatever its shapes would mix to now.
            const std::uint32_t c = index_of(contacts[block * W + i]);
            const bool is_live = W == 1 || c != null_index;
            const std::uint32_t soon = block + 1 < count ? index_of(contacts[(block + 1) * W + i]) : null_index;
            if (W > 1 && soon != null_index) {  // its materials are likely to be wanted, too
                ISLET_PREFETCH(&core.shapes[core.contacts[soon].shape_a].friction);
                ISLET_PREFETCH(&core.shapes[core.contacts[soon].shape_b].friction);
            }
            const std::uint32_t own = W == 1 ? any : is_live ? core.manifolds[c].flags : 0;
            set_surface(r, i, own, is_live ? surface_of(core, c) : MixedSurface{});
        }
    }
}

}  // namespace islet::detail
