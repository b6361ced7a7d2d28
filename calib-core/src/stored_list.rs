//! Lists that are kept on the instrument, with what their results are judged by.
//!
//! A tap of the button measures the list that was chosen, without a host, and the lamps tell what
//! [`crate::conformity`] makes of it. What a list is judged by stands in the record of each of its runs.

use crate::point::PointSpec;
use heapless::{String, Vec};
use serde::{Deserialize, Serialize};

/// Lists an instrument keeps.
pub const MAX_LISTS: usize = 8;
/// Points of such a list: the preferred series from 5 Hz to 10 kHz has 34.
pub const MAX_LIST_POINTS: usize = 40;
/// Bands of a tolerance.
pub const MAX_BANDS: usize = 6;

/// Frequencies of a band that holds for all, Hz.
pub const ANY_HZ: (f32, f32) = (0.0, f32::MAX);

/// Sensitivity that the limits of a band refer to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Base {
    /// The nominal sensitivity.
    Nominal,
    /// The sensitivity measured at the reference point (ISO 16063-21, 5.3).
    Reference,
}

/// How a result is judged (ILAC-G8:09/2019, 4.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Rule {
    /// Inside the tolerance (4.2.1).
    Simple,
    /// Inside the tolerance less U; between the two the statement is conditional (4.2.3).
    GuardBand,
}

/// A tolerance over a range of frequencies.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Band {
    /// Lowest frequency, Hz ([`ANY_HZ`]).
    pub from_hz: f32,
    /// Highest frequency, Hz.
    pub to_hz: f32,
    /// Sensitivity that the limits refer to.
    pub base: Base,
    /// Lower limit of the deviation from the base, relative, such as -0.05.
    pub lower_rel: f32,
    /// Upper limit of it.
    pub upper_rel: f32,
    /// Only the reference point is judged by it.
    pub reference_point_only: bool,
}

impl Band {
    /// This far to either side of the base, relative, at every frequency.
    pub const fn everywhere(base: Base, half_width_rel: f32) -> Self {
        Self {
            from_hz: ANY_HZ.0,
            to_hz: ANY_HZ.1,
            base,
            lower_rel: -half_width_rel,
            upper_rel: half_width_rel,
            reference_point_only: false,
        }
    }

    /// Whether it says something about this frequency. A nominal 10 Hz is played within 0.01 % of it.
    pub(crate) fn applies(&self, frequency_hz: f32, at_reference_point: bool) -> bool {
        let inside = frequency_hz >= 0.999 * self.from_hz && frequency_hz <= 1.001 * self.to_hz;
        inside && (at_reference_point || !self.reference_point_only)
    }

    fn is_usable(&self) -> bool {
        let numbers = [self.from_hz, self.to_hz, self.lower_rel, self.upper_rel];
        numbers.into_iter().all(f32::is_finite)
            && self.from_hz >= 0.0
            && self.from_hz <= self.to_hz
            && self.lower_rel > -1.0
            && self.lower_rel < self.upper_rel
    }
}

/// Name of a list, and the terms by which its results are judged.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ListTerms {
    /// Its name; empty: there is no list.
    pub name: String<24>,
    /// Nominal sensitivity, V/(m/s2); 0 = not stated.
    pub nominal_v_per_ms2: f32,
    /// Unit the sensor is specified in, for people, such as `mV/g`.
    pub unit: String<16>,
    /// How results are judged.
    pub rule: Rule,
    /// The tolerance; where several bands apply, all must be met.
    pub bands: Vec<Band, MAX_BANDS>,
}

impl ListTerms {
    /// Those of no list. Every byte is zero, for memory that is cleared at the start.
    pub const NONE: Self = Self {
        name: String::new(),
        nominal_v_per_ms2: 0.0,
        unit: String::new(),
        rule: Rule::Simple,
        bands: Vec::new(),
    };

    /// Whether there is no list.
    pub fn is_none(&self) -> bool {
        self.name.is_empty()
    }

    /// Whether something can be judged by it: a name, a tolerance, and the nominal sensitivity it is stated of.
    pub fn is_usable(&self) -> bool {
        let of_nominal = self.bands.iter().any(|band| band.base == Base::Nominal);
        let nominal = self.nominal_v_per_ms2;
        !self.is_none()
            && !self.bands.is_empty()
            && self.bands.iter().all(Band::is_usable)
            && nominal.is_finite()
            && nominal >= 0.0
            && (nominal > 0.0 || !of_nominal)
    }
}

impl Default for ListTerms {
    fn default() -> Self {
        Self::NONE
    }
}

/// A list kept on the instrument.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StoredList {
    /// Its name, and what it is judged by.
    pub terms: ListTerms,
    /// Points in the order they are measured.
    pub points: Vec<PointSpec, MAX_LIST_POINTS>,
}

impl StoredList {
    /// Whether it can be measured and judged: see [`ListTerms::is_usable`]; every frequency and level is finite
    /// and positive, and there is a point.
    pub fn is_usable(&self) -> bool {
        let usable = |value: f32| value.is_finite() && value > 0.0;
        let point =
            |point: &PointSpec| usable(point.frequency_hz) && usable(point.acceleration_rms_ms2);
        self.terms.is_usable() && !self.points.is_empty() && self.points.iter().all(point)
    }
}

/// The lists of an instrument, and which of them a tap of the button measures.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StoredLists {
    lists: Vec<StoredList, MAX_LISTS>,
    /// Place of the chosen one, from 1; 0 = none.
    chosen: u8,
}

/// There is no list of this name, or no room for another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoPlace {
    /// No list has this name.
    Unknown,
    /// [`MAX_LISTS`] are there.
    Full,
}

impl StoredLists {
    /// No list. Every byte is zero, for memory that is cleared at the start.
    pub const NONE: Self = Self {
        lists: Vec::new(),
        chosen: 0,
    };

    /// The lists, in the order they were stored.
    pub fn all(&self) -> &[StoredList] {
        &self.lists
    }

    /// The list a tap of the button measures.
    pub fn chosen(&self) -> Option<&StoredList> {
        self.lists.get(usize::from(self.chosen).checked_sub(1)?)
    }

    /// The list of this name.
    pub fn find(&self, name: &str) -> Option<&StoredList> {
        self.lists.get(self.place(name)?)
    }

    fn place(&self, name: &str) -> Option<usize> {
        self.lists.iter().position(|list| list.terms.name == name)
    }

    /// Stores a list in place of the one of its name, or behind the others.
    ///
    /// # Errors
    /// [`NoPlace::Full`].
    pub fn store(&mut self, list: &StoredList) -> Result<(), NoPlace> {
        let place = self.place(&list.terms.name);
        match place.and_then(|place| self.lists.get_mut(place)) {
            Some(before) => before.clone_from(list),
            None => self.lists.push(list.clone()).map_err(|_| NoPlace::Full)?,
        }
        Ok(())
    }

    /// Removes a list; if it was the chosen one, none is.
    ///
    /// # Errors
    /// [`NoPlace::Unknown`].
    pub fn remove(&mut self, name: &str) -> Result<(), NoPlace> {
        let place = self.place(name).ok_or(NoPlace::Unknown)?;
        self.lists.remove(place);
        let chosen = usize::from(self.chosen);
        if chosen == place + 1 {
            self.chosen = 0;
        } else if chosen > place {
            self.chosen -= 1;
        }
        Ok(())
    }

    /// Chooses the list of this name; with an empty one, none.
    ///
    /// # Errors
    /// [`NoPlace::Unknown`].
    pub fn choose(&mut self, name: &str) -> Result<(), NoPlace> {
        self.chosen = match name {
            "" => 0,
            name => self.place(name).ok_or(NoPlace::Unknown)? as u8 + 1,
        };
        Ok(())
    }

    /// Forgets all of them.
    pub fn clear(&mut self) {
        self.lists.clear();
        self.chosen = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn list(name: &str) -> StoredList {
        let band = Band::everywhere(Base::Nominal, 0.05);
        let point = PointSpec {
            frequency_hz: 160.0,
            acceleration_rms_ms2: 10.0,
        };
        StoredList {
            terms: ListTerms {
                name: name.try_into().expect("short"),
                nominal_v_per_ms2: 0.01,
                unit: "mV/g".try_into().expect("short"),
                rule: Rule::GuardBand,
                bands: [band].into_iter().collect(),
            },
            points: [point].into_iter().collect(),
        }
    }

    fn names(lists: &StoredLists) -> std::vec::Vec<&str> {
        lists.all().iter().map(|l| l.terms.name.as_str()).collect()
    }

    #[test]
    fn a_choice_stays_with_its_list_whatever_goes() {
        let mut lists = StoredLists::NONE;
        for name in ["a", "b", "c"] {
            assert_eq!(lists.store(&list(name)), Ok(()));
        }
        assert_eq!(lists.chosen(), None);
        assert_eq!(lists.choose("b"), Ok(()));
        assert_eq!(lists.remove("a"), Ok(()));
        assert_eq!(lists.chosen(), Some(&list("b")));
        assert_eq!(lists.remove("c"), Ok(()));
        assert_eq!(lists.chosen(), Some(&list("b")));
        assert_eq!(lists.remove("b"), Ok(()));
        assert_eq!(lists.chosen(), None);
        assert_eq!(lists.choose("b"), Err(NoPlace::Unknown));
        assert_eq!(lists.remove("b"), Err(NoPlace::Unknown));
    }

    #[test]
    fn a_name_is_stored_once_and_there_is_room_for_eight() {
        let mut lists = StoredLists::NONE;
        for name in ["a", "b", "c", "d", "e", "f", "g", "h"] {
            assert_eq!(lists.store(&list(name)), Ok(()));
        }
        assert_eq!(lists.store(&list("i")), Err(NoPlace::Full));
        let mut other = list("c");
        other.terms.nominal_v_per_ms2 = 0.02;
        assert_eq!(lists.store(&other), Ok(()));
        assert_eq!(lists.find("c"), Some(&other));
        assert_eq!(names(&lists), ["a", "b", "c", "d", "e", "f", "g", "h"]);
    }

    #[test]
    fn what_nothing_can_be_judged_by_is_no_list() {
        type Damage = fn(&mut StoredList);
        let damages: [Damage; 12] = [
            |l| l.terms.name.clear(),
            |l| l.points.clear(),
            |l| l.points[0].frequency_hz = f32::NAN,
            |l| l.points[0].acceleration_rms_ms2 = 0.0,
            |l| l.terms.bands.clear(),
            |l| l.terms.nominal_v_per_ms2 = 0.0,
            |l| l.terms.nominal_v_per_ms2 = f32::INFINITY,
            |l| l.terms.bands[0].lower_rel = 0.05,
            |l| l.terms.bands[0].lower_rel = -1.0,
            |l| l.terms.bands[0].upper_rel = f32::NAN,
            |l| l.terms.bands[0].from_hz = -1.0,
            |l| l.terms.bands[0].to_hz = f32::INFINITY,
        ];
        assert!(list("a").is_usable());
        for (number, damage) in damages.into_iter().enumerate() {
            let mut damaged = list("a");
            damage(&mut damaged);
            assert!(!damaged.is_usable(), "{number}");
        }
        let mut of_reference = list("a");
        of_reference.terms.nominal_v_per_ms2 = 0.0;
        of_reference.terms.bands[0].base = Base::Reference;
        assert!(of_reference.is_usable());
    }
}
