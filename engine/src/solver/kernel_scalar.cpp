// The kernel for one lane, and for four where the target's baseline has vectors (SSE2, NEON, wasm-simd128).
#include "solver/kernel.hpp"

namespace islet::detail {

template struct ContactKernel<Lane1>;
template struct ContactKernel<Lane4>;

}  // namespace islet::detail
