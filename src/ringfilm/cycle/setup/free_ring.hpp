#pragma once
#include "ringfilm/case/case.hpp"
#include "ringfilm/models/conformity/free_shape.hpp"

namespace ringfilm::cycle {

/// Size and modulus of the ring as a beam, without its tension.
models::RingBeamSize beam_size(const Case& c);

/// The highest order of the pressure that ring.free_shape_smoothing leaves, eq-closure-measured-shape.
int orders_of_free_ring(const Case& c);

/// Tension and target pressure of the measured ring.free_shape. Throws InputError where it does not close.
models::FreeShapeFit free_ring(const Case& c);

}  // namespace ringfilm::cycle
