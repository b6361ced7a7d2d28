//! The lease of a run that a host began: how long it goes on when no host speaks any more.
//!
//! A laboratory that measures overnight wants the run to go on when a computer sleeps; one that has
//! people at the exciter wants it silent. So it is a setting (`lease_s`), which needs a hand like any
//! other, and 0, the value of the factory, lets runs go on as they always did. The button's runs have none:
//! whoever pressed it is there.
//!
//! A host speaks when something of it is answered. Noise, half a frame and an open port are nobody.

/// A lease of the run in work.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Lease {
    /// Quiet that is granted, ms; 0: any.
    granted_ms: u32,
    /// When a host was last heard, ms since the start, which may wrap.
    heard_ms: u32,
}

impl Lease {
    /// No lease: the run goes on.
    pub const NONE: Self = Self {
        granted_ms: 0,
        heard_ms: 0,
    };

    /// A run begins.
    pub fn begin(granted_s: u16, now_ms: u32) -> Self {
        Self {
            granted_ms: 1000 * u32::from(granted_s),
            heard_ms: now_ms,
        }
    }

    /// A host has spoken.
    pub fn hear(&mut self, now_ms: u32) {
        self.heard_ms = now_ms;
    }

    /// Whether hosts have been silent for longer than is granted.
    pub fn has_run_out(&self, now_ms: u32) -> bool {
        self.granted_ms > 0 && now_ms.wrapping_sub(self.heard_ms) > self.granted_ms
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_runs_out_after_the_quiet_that_is_granted_and_any_word_renews_it() {
        // Across the wrap of the clock after 49 days.
        let start_ms = u32::MAX - 1_500;
        let after = |ms: u32| start_ms.wrapping_add(ms);
        let mut lease = Lease::begin(2, start_ms);
        assert!(!lease.has_run_out(after(2_000)));
        assert!(lease.has_run_out(after(2_001)));
        lease.hear(after(1_900));
        assert!(!lease.has_run_out(after(3_900)));
        assert!(lease.has_run_out(after(3_901)));
    }

    #[test]
    fn without_one_a_run_goes_on() {
        for lease in [Lease::NONE, Lease::begin(0, 5)] {
            assert!(!lease.has_run_out(u32::MAX));
        }
    }
}
