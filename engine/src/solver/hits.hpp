// Hit events. After the solve, the rows of contacts that bounce or report hits know how fast the shapes came together.
#pragma once

#include "../constraint/contact_rows.hpp"
#include "../data/core.hpp"
#include "../math/scalar.hpp"

namespace islet::detail {

/// How fast the shapes of a contact came together, and at which of its points. A speed is never below 0, so the bit of its sign is free for the point.
class Hit {
public:
    /// At the point that came down faster. A point that needed no impulse has the speed 0.
    static Hit of_points(float first, float second) { return second > first ? Hit(second, 1) : Hit(first, 0); }
    float speed() const { return __builtin_bit_cast(float, speed_and_point_ & ~sign_bit); }  // m/s
    std::uint32_t point() const { return speed_and_point_ >> 31; }

private:
    static constexpr std::uint32_t sign_bit = 1u << 31;
    Hit(float speed, std::uint32_t point) : speed_and_point_(bits_of(speed) | point << 31) {}
    std::uint32_t speed_and_point_;
};

/// Writes to `hits`, by contact, the hits of those contacts in solved rows that report them (contact_hits).
void note_hits(const ContactManifold* manifolds, const ContactRows<1>* rows, std::uint32_t count, Hit* hits);
void note_hits(const ContactManifold* manifolds, const ContactRows<4>* rows, std::uint32_t count, Hit* hits);
void note_hits(const ContactManifold* manifolds, const ContactRows<8>* rows, std::uint32_t count, Hit* hits);
void note_hits(const ContactManifold* manifolds, const ContactRows<16>* rows, std::uint32_t count, Hit* hits);

/// Reports the contacts whose shapes came together faster than the threshold, in slot order.
void report_hits(Core& core, const Hit* hits);

}  // namespace islet::detail
