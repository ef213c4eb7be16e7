// The scan with eight lanes, compiled for AVX2 (math/avx2.hpp).
#include "../exact.hpp"

#include "../math/avx2.hpp"

#include "../broadphase/columns.hpp"

namespace islet::detail {

#if defined(ISLET_AVX2)
std::uint32_t scan_columns_8(const Columns& c, std::uint32_t first, const Columns& from, std::uint32_t i, std::uint32_t* out) {
    return scan_columns<Lane8>(c, first, from, i, out);
}
#endif

}  // namespace islet::detail

ISLET_AVX2_END
