//! Functions of complex numbers of ordinary size.

use num_complex::Complex64;

/// Logarithm without the care for overflow that the library's takes: no value here is near it.
pub(super) fn ln(value: Complex64) -> Complex64 {
    if value == Complex64::ONE {
        return Complex64::ZERO;
    }
    Complex64::new(0.5 * value.norm_sqr().ln(), value.im.atan2(value.re))
}

/// Size of a value, likewise.
pub(super) fn size(value: Complex64) -> f64 {
    value.norm_sqr().sqrt()
}
