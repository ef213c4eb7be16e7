// Hit events: read off the rows of contacts once they are solved, which know the approach of what bounces or tells of hits.
#pragma once

#include "../constraint/contact_rows.hpp"
#include "../data/core.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

/// How fast the shapes of a contact came together, and at which of its points. A speed is never below 0, so its sign has room for the point.
class Hit {
public:
    /// Of the two points the one that came down faster; the speeds are 0 where the shapes needed no impulse.
    static Hit of_points(float first, float second) { return Hit(second > first ? -second : first); }
    float speed() const { return abs(signed_); }  // m/s
    std::uint32_t point() const { return signed_ < 0 ? 1 : 0; }

private:
    explicit Hit(float s) : signed_(s) {}
    float signed_;
};

/// Of solved rows: writes to `hits`, by contact, those of contacts that are to tell of them (contact_hits).
void note_hits(const ContactManifold* manifolds, const ContactRows<1>* rows, std::uint32_t count, Hit* hits);
void note_hits(const ContactManifold* manifolds, const ContactRows<4>* rows, std::uint32_t count, Hit* hits);
void note_hits(const ContactManifold* manifolds, const ContactRows<8>* rows, std::uint32_t count, Hit* hits);

/// Reports the contacts whose shapes came together faster than the threshold, in slot order.
void report_hits(Core& core, const Hit* hits);

}  // namespace islet::detail
