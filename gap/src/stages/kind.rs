//! Classes of deviations: rules without the formula of any effect.

/// A rule: which observables deviate together, and along which condition.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// The ratio, over frequency only.
    Ratio,
    /// The phase of the ratio, growing with time.
    PhaseInTime,
    /// The ratio, with the cosine and sine of the rotation.
    Rotation,
    /// The ratio, in proportion to the payload.
    Payload,
    /// The ratio, with temperature.
    Temperature,
    /// The ratio, with time.
    Time,
    /// The ratio, with level.
    Level,
    /// Ratio and drive, equal and opposite, over frequency.
    Mirrored,
    /// The same, with temperature or time.
    MirroredSlow,
    /// The same, with level.
    MirroredLevel,
    /// The drive alone, with time.
    DriveInTime,
    /// Drive and current, over frequency or level.
    Exciter,
    /// Drive and current, with time.
    ExciterInTime,
    /// Noise of the channel of the device alone.
    NoiseOfDut,
    /// Noise of the reference channel or of both.
    NoiseOfBoth,
}
