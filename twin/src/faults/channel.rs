//! Faults of a transducer, its cable and its conditioner, seen at the input connector.

/// The supply of an IEPE transducer breaks down: its bias jumps, the signal is gone, and the
/// conditioner's coupling lets the jump decay.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surge {
    /// When, s.
    pub at_s: f64,
    /// Size of the jump at the connector, V.
    pub volt: f64,
    /// Time constant of the coupling, s.
    pub time_constant_s: f64,
}

/// A contact that opens and closes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// From when on, s.
    pub at_s: f64,
    /// How often, Hz.
    pub rate_hz: f64,
    /// Part of the time it is open.
    pub open_fraction: f64,
}

/// A sensitivity that changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fade {
    /// From when on, s.
    pub at_s: f64,
    /// Relative change per second; nothing is left at -1.
    pub per_s: f64,
}

/// Faults of one channel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ChannelFaults {
    /// IEPE open or short.
    pub surge: Option<Surge>,
    /// Intermittent cable.
    pub contact: Option<Contact>,
    /// Drifting transducer.
    pub fade: Option<Fade>,
    /// The transducer gives nothing from here on, s.
    pub dead_from_s: Option<f64>,
    /// Its amplifier saturates at this, V peak, from an instant in s on.
    pub saturation: Option<(f64, f64)>,
}

impl ChannelFaults {
    /// Whether there are none.
    pub(crate) fn is_none(&self) -> bool {
        *self == Self::default()
    }

    /// Volts at the connector at `elapsed_s`, where a healthy channel has `volt`.
    pub(crate) fn volt(&self, volt: f64, elapsed_s: f64) -> f64 {
        let since = |at_s: f64| (elapsed_s >= at_s).then_some(elapsed_s - at_s);
        let mut volt = volt;
        if let Some((fade, since_s)) = self.fade.and_then(|f| Some((f, since(f.at_s)?))) {
            volt *= (1.0 + fade.per_s * since_s).max(0.0);
        }
        if let Some((threshold_v, _)) = self.saturation.filter(|s| elapsed_s >= s.1) {
            volt = volt.clamp(-threshold_v, threshold_v);
        }
        if let Some((contact, since_s)) = self.contact.and_then(|c| Some((c, since(c.at_s)?))) {
            let phase = (since_s * contact.rate_hz).fract();
            if phase < contact.open_fraction {
                volt = 0.0;
            }
        }
        if self.dead_from_s.is_some_and(|at_s| elapsed_s >= at_s) {
            volt = 0.0;
        }
        if let Some((surge, since_s)) = self.surge.and_then(|s| Some((s, since(s.at_s)?))) {
            volt = surge.volt * (-since_s / surge.time_constant_s).exp();
        }
        volt
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_happens_before_its_time() {
        let faults = ChannelFaults {
            surge: Some(Surge {
                at_s: 1.0,
                volt: 10.0,
                time_constant_s: 0.5,
            }),
            contact: Some(Contact {
                at_s: 1.0,
                rate_hz: 30.0,
                open_fraction: 0.5,
            }),
            fade: Some(Fade {
                at_s: 1.0,
                per_s: -0.5,
            }),
            dead_from_s: Some(1.0),
            saturation: Some((0.1, 1.0)),
        };
        assert_eq!(faults.volt(0.7, 0.999), 0.7);
        assert!(!faults.is_none());
    }

    #[test]
    fn each_fault_does_what_its_name_says() {
        let surge = ChannelFaults {
            surge: Some(Surge {
                at_s: 0.0,
                volt: 10.0,
                time_constant_s: 0.5,
            }),
            ..ChannelFaults::default()
        };
        // One time constant leaves 1/e.
        assert!((surge.volt(0.3, 0.5) - 10.0 / std::f64::consts::E).abs() < 1e-12);
        let fade = ChannelFaults {
            fade: Some(Fade {
                at_s: 1.0,
                per_s: -0.25,
            }),
            ..ChannelFaults::default()
        };
        assert_eq!([fade.volt(1.0, 3.0), fade.volt(1.0, 9.0)], [0.5, 0.0]);
        let contact = ChannelFaults {
            contact: Some(Contact {
                at_s: 0.0,
                rate_hz: 10.0,
                open_fraction: 0.3,
            }),
            ..ChannelFaults::default()
        };
        let seen = [0.01, 0.029, 0.031, 0.09].map(|time_s| contact.volt(1.0, time_s));
        assert_eq!(seen, [0.0, 0.0, 1.0, 1.0]);
    }
}
