// Compiled for AVX2, as solver/kernel_avx2.cpp is.
#include "broadphase/columns.hpp"

namespace islet::detail {

#if defined(__AVX2__)
std::uint32_t scan_columns_8(const Columns& c, std::uint32_t first, const Columns& from, std::uint32_t i, std::uint32_t* out) {
    return scan_columns<Lane8>(c, first, from, i, out);
}
#endif

}  // namespace islet::detail
