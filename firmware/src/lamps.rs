//! What the red lamp says of an instrument that is degraded.

use crate::button::PERIOD_MS;
use calib_protocol::health::Defects;

/// A blink is dark and lit for so many periods each: a quarter of a second.
const HALF_BLINK: u32 = (250 / PERIOD_MS) as u32;
/// Dark behind the blinks of a defect: a second and a half.
const PAUSE: u32 = (1_500 / PERIOD_MS) as u32;

/// Whether the red lamp is lit in this period of [`PERIOD_MS`], counted from any.
///
/// Each defect blinks once more than its number, in turn, with a pause behind it. One that only a
/// newer release knows is a lamp that stays lit.
pub fn is_red_lit(defects: Defects, period: u32) -> bool {
    let blinks = || defects.iter().map(|defect| defect as u32 + 1);
    let lasts = |blinks: u32| 2 * HALF_BLINK * blinks + PAUSE;
    let round: u32 = blinks().map(lasts).sum();
    let Some(mut place) = period.checked_rem(round) else {
        return !defects.is_none();
    };
    for count in blinks() {
        if place < lasts(count) {
            return place < 2 * HALF_BLINK * count && (place / HALF_BLINK).is_multiple_of(2);
        }
        place -= lasts(count);
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_protocol::health::Defect;

    /// Times the lamp goes on in a minute.
    fn blinks(defects: Defects) -> usize {
        let lit: std::vec::Vec<bool> = (0..60_000 / PERIOD_MS as u32)
            .map(|period| is_red_lit(defects, period))
            .collect();
        lit.windows(2).filter(|pair| pair == &[false, true]).count()
    }

    #[test]
    fn a_defect_is_told_by_how_often_it_blinks() {
        assert_eq!(blinks(Defects::NONE), 0);
        for defect in Defect::ALL {
            let number = defect as u32 + 1;
            let lit: std::vec::Vec<bool> = (0..2 * HALF_BLINK * number + PAUSE)
                .map(|period| is_red_lit(Defects::NONE.with(defect), period))
                .collect();
            // It begins lit.
            let rises = lit.windows(2).filter(|pair| pair == &[false, true]).count();
            assert_eq!(rises as u32 + 1, number);
            assert!(!lit[lit.len() - PAUSE as usize..].contains(&true));
        }
    }

    #[test]
    fn two_defects_take_turns() {
        let both = Defects::NONE.with(Defect::Archive).with(Defect::Clock);
        // One and four blinks in 5 half seconds and two pauses: 5.5 s.
        assert!((53..=55).contains(&blinks(both)), "{}", blinks(both));
    }
}
