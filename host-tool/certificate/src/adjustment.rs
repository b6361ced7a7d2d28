//! As found and as left: two records of one object, before and after it was
//! adjusted (ISO/IEC 17025 7.8.4.1 d).

use super::model::{Certificate, Entry, Point, Value};
use calib_files::{Error, Result};
use calib_protocol::record::Record;

/// Adds the record from before the adjustment to the certificate of `left`.
///
/// # Errors
/// [`Error::Input`] when the two are not of one object, or not in this order.
pub(super) fn attach(certificate: &mut Certificate, left: &Record, found: &Record) -> Result<()> {
    let object = |record: &Record| {
        let labels = &record.head.labels;
        (labels.dut_model.clone(), labels.dut_serial.clone())
    };
    let name = format!("record {} as found", found.head.id);
    if object(found) != object(left) {
        let problem = format!(
            "is of {} {}, and record {} is of {} {}",
            found.head.labels.dut_model,
            found.head.labels.dut_serial,
            left.head.id,
            left.head.labels.dut_model,
            left.head.labels.dut_serial
        );
        return Err(Error::input(
            name,
            problem,
            "give two records of one object",
        ));
    }
    let (before, after) = (found.head.labels.unix_time_s, left.head.labels.unix_time_s);
    if before > 0 && after > 0 && before > after {
        let problem = format!("was made after record {}", left.head.id);
        return Err(Error::input(name, problem, "exchange the two records"));
    }
    // A number that was stated is that of the whole, and not of what was found.
    let mut particulars = certificate.particulars.clone();
    particulars.calibration.number = None;
    particulars.calibration.replaces = None;
    let found = Certificate::from_record(found, &particulars);
    certificate.as_found = Some(Box::new(found));
    state(certificate);
    Ok(())
}

/// Says that both are given, whatever was stated of one of them.
fn state(certificate: &mut Certificate) {
    let calibration = certificate
        .sections
        .iter_mut()
        .find(|section| section.key == "calibration");
    let adjustment = |entry: &&mut Entry| entry.key == "adjustment";
    let entry = calibration.and_then(|section| section.entries.iter_mut().find(adjustment));
    if let Some(entry) = entry {
        entry.value = Some(Value::Phrase("adjustment.pair".to_owned(), vec![]));
    }
}

/// Change of the sensitivity by the adjustment, in percent of as found.
pub(super) fn change_percent(found: Option<&Point>, left: &Point) -> Option<f64> {
    let found = found?.values()?.sensitivity;
    let left = left.values()?.sensitivity;
    Some(100.0 * (left / found - 1.0))
}

#[cfg(test)]
mod tests {
    use super::super::{Format, Language, Particulars, render};
    use super::*;
    use calib_record::sample::{record, text};

    fn pair() -> (Record, Record) {
        let left = record(&[80.0, 160.0]);
        let mut found = record(&[160.0]);
        found.head.id = 16;
        found.head.labels.unix_time_s -= 3600;
        // 4 % low before it was adjusted.
        found.points[0].sensitivity_v_per_ms2 /= 1.04;
        (found, left)
    }

    fn joined(found: &Record, left: &Record) -> Result<Certificate> {
        let mut certificate = Certificate::from_record(left, &Particulars::default());
        attach(&mut certificate, left, found).map(|()| certificate)
    }

    #[test]
    fn both_states_and_the_change_are_in_every_form_for_people() {
        let (found, left) = pair();
        let certificate = joined(&found, &left).expect("one object");
        let json = render(&certificate, Format::Json, Language::En).expect("renders");
        let json: serde_json::Value = serde_json::from_slice(&json).expect("JSON");
        let pairs = json["as_found"]["pairs"].as_array().expect("pairs");
        assert!(pairs[0]["change_rel"].is_null(), "80 Hz was not found");
        let change = pairs[1]["change_rel"].as_f64().expect("number");
        // Two f32 roundings of 6e-8 each.
        assert!((change - 0.04).abs() < 2.0e-7, "{change}");
        let html = render(&certificate, Format::Html, Language::En).expect("renders");
        let html = String::from_utf8(html).expect("UTF-8");
        assert!(html.contains("As found and as left") && html.contains("<td>4.00</td>"));
        assert!(html.contains("results as found and as left are both given"));
        render(&certificate, Format::Pdf, Language::De).expect("renders");
    }

    #[test]
    fn records_of_two_objects_or_in_the_wrong_order_are_refused() {
        let (mut found, left) = pair();
        let error = joined(&left, &found).expect_err("exchanged");
        assert!(error.to_string().contains("after record 16"), "{error}");
        found.head.labels.dut_serial = text("another");
        let error = joined(&found, &left).expect_err("two objects");
        assert!(error.to_string().contains("another"), "{error}");
    }
}
