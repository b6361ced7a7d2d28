//! Times as people read them.

pub(crate) use calib_host::clock::unix_time_s;
use jiff::Timestamp;

/// `2026-11-21 14:05Z`, or `not known` for 0.
pub(crate) fn date_and_minute(unix_time_s: u64) -> String {
    let known = i64::try_from(unix_time_s)
        .ok()
        .filter(|seconds| *seconds > 0)
        .and_then(|seconds| Timestamp::from_second(seconds).ok());
    match known {
        Some(time) => time.strftime("%Y-%m-%d %H:%MZ").to_string(),
        None => "not known".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unknown_and_impossible_times_are_said_to_be_so() {
        // date -u -d @1795269900: 2026-11-21 14:05.
        assert_eq!(date_and_minute(1_795_269_900), "2026-11-21 14:05Z");
        for unix_time_s in [0, u64::MAX] {
            assert_eq!(date_and_minute(unix_time_s), "not known");
        }
    }
}
