// The touching contacts as they are listed while a plan is made.
#pragma once

#include "../data/core.hpp"
#include "../data/parallel.hpp"
#include "../island/height_order.hpp"
#include "../math/inlining.hpp"

namespace islet::detail {

inline constexpr std::uint32_t part_contacts = 256;  // that are worth a task

/// A listed contact's colour has a flag above it if the contact lands, and so has its place once it is counted. Among contacts of one colour these come first:
/// a block in which one lane lands is solved again as a whole. Rows by themselves have no use for that.
inline constexpr std::uint32_t listed_landing = max_lanes > 1 ? 1u << 31 : 0;

/// Above the colour of a contact stands, from 1 on, the half of its batch that it belongs to.
inline constexpr std::uint32_t listed_half_shift = 8;

/// The touching contacts, cut into parts that are planned side by side: workers list each part in its own piece of the array, count its contacts by place, and
/// put them where the counts of all parts say. The plan is the same however the contacts are cut.
struct ContactList {
    PlannedConstraint* contacts = nullptr;
    std::uint32_t parts_with_threads = 1;
    std::uint32_t end_word[max_plan_parts] = {};  // of each part, in the set of awake contacts
    std::uint32_t first[max_plan_parts] = {};     // contact of each part
    std::uint32_t end[max_plan_parts] = {};
    std::uint32_t colors[max_plan_parts] = {};  // bits of those that a part's contacts may have
    bool lands[max_plan_parts] = {};            // whether any of the part does

    std::uint32_t parts() const { return has_threads ? parts_with_threads : 1; }
    bool any_lands() const {
        for (std::uint32_t p = 0; p < parts(); ++p)
            if (lands[p]) return true;
        return false;
    }
    std::uint32_t first_word(std::uint32_t part) const { return part == 0 ? 0 : end_word[part - 1]; }

    /// Cuts the awake contacts into at most `most` parts, each with about as many as the others.
    void cut(BitSet awake, std::uint32_t most) {
        const std::uint32_t total = awake.count();
        const std::uint32_t wanted = total < 2 * part_contacts ? 1 : total / part_contacts < most ? total / part_contacts : most;
        std::uint32_t part = 0, listed = 0;
        for (std::uint32_t w = 0; w < awake.word_count && part + 1 < wanted; ++w) {
            listed += BitSet::bits_of(awake.words[w]);
            if (listed < std::uint64_t{total} * (part + 1) / wanted) continue;
            end_word[part++] = w + 1;
            first[part] = listed;
        }
        end_word[part] = awake.word_count;
        parts_with_threads = part + 1;
    }

    template <class Visit>
    ISLET_ALWAYS_INLINE void for_each(Visit&& visit) const {
        for (std::uint32_t p = 0; p < parts(); ++p)
            for (std::uint32_t k = first[p]; k < end[p]; ++k) visit(contacts[k]);
    }
};

}  // namespace islet::detail
