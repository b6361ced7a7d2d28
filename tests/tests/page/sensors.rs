//! A sensor is registered on the page, measured, adjusted and measured again.

use super::{LEFT_OUT, Setup, everybody};
use calib_tests::browser::Browser;
use calib_tests::rigged::Fault;
use calib_tests::served::tool;
use std::process::Command;

#[test]
fn a_sensor_is_registered_measured_adjusted_and_measured_again() -> Result<(), Fault> {
    let Some(setup) = Setup::new()? else {
        return Ok(());
    };
    let page = &setup.browser;
    setup.connect()?;
    page.wait_for_text("#no-records", "Each run enters")?;
    page.click("#registration summary")?;
    page.fill("#new-serial", "A-77")?;
    page.fill("#register [name=model]", "Examplia 1")?;
    // 100 mV/g are 10.197 mV/(m/s2): the transducer of this rig has 9.3.
    page.fill("#register [name=sensitivity]", "100")?;
    page.choose("#register [name=unit]", "mV/g")?;
    page.fill("#register [name=tolerance]", "5")?;
    page.fill("#register [name=resonance]", "32.5")?;
    page.value("document.querySelector('#register [name=due_day]').value = '2020-02-01'")?;
    page.click("#register button")?;
    page.wait_for_text("#sensor", "A-77 Examplia 1")?;
    page.wait_for_text("#due-list", "overdue since 2020-02-01")?;
    let known = "const asked = new XMLHttpRequest(); asked.open('GET', 'api/sensors', false); asked.send();";
    let resonance_hz =
        format!("(() => {{ {known} return JSON.parse(asked.response)[0].resonance_hz }})()");
    assert_eq!(page.value(&resonance_hz)?, 32_500.0);
    assert_eq!(
        page.value("document.getElementById('sensor').value")?,
        "A-77"
    );
    // Twice is refused, with what is there.
    page.click("#registration summary")?;
    page.fill("#new-serial", "a-77")?;
    page.click("#register button")?;
    page.wait_for_text("#trouble", "in the logbook already")?;

    // Records have the numbers of their instrument, whose first is that of its settings.
    measure(&setup, 2)?;
    page.wait_for_text("#conformity", "FAIL")?;
    measure(&setup, 3)?;
    page.choose("#adjustment", "as_left")?;
    page.wait_for_text("#as_found", "record 2")?;
    page.choose("#as_found", "1")?;
    page.fill("#customer", "Mills & Sons")?;
    page.fill("#humidity_percent", "45")?;
    page.value("document.getElementById('humidity_percent').dispatchEvent(new Event('change'))")?;
    let link = page.value("document.querySelector('#certificates a[data-format=html]').href")?;
    let own = page.open_tab(link.as_str().ok_or("no link")?)?;
    let certificate = page.text("body")?;
    for stated in ["Mills & Sons", "45", "As found", "A-77"] {
        assert!(certificate.contains(stated), "{stated}: {certificate}");
    }
    page.switch_to(own)?;
    is_a_check_standard(&setup)?;
    by_substitution(&setup)
}

/// Named one in the terminal, it stands on the page by its serial number, for everybody.
fn is_a_check_standard(setup: &Setup) -> Result<(), Fault> {
    let named = Command::new(tool()?)
        .args(["assure", "A-77", "--every", "7", "--quiet"])
        .args(["--certified", "9.285", "--certified-u", "2"])
        .env("CALIB_LOGBOOK", setup.folder.path().join("logbook.sqlite"))
        .status()?;
    assert!(named.success());
    let page = &setup.browser;
    page.open(&setup.server.url)?;
    page.wait_for_text("#check-list", "no chart yet")?;
    assert_eq!(page.text("#check-list button")?, "A-77");
    everybody::can_use_it(page)
}

/// Another device in the check standard's channel: what its certificate states is by that standard.
fn by_substitution(setup: &Setup) -> Result<(), Fault> {
    let page = &setup.browser;
    page.choose("#sensor", "")?;
    page.fill("#serial", "B-1")?;
    measure(setup, 4)?;
    page.wait_for_text("#substituted", "A-77, record 3")?;
    page.choose("#substituted", "2")?;
    let link = page.value("document.querySelector('#certificates a[data-format=html]').href")?;
    let own = page.open_tab(link.as_str().ok_or("no link")?)?;
    let certificate = page.text("body")?;
    let stated = "by substitution of standard A-77 (record 3)";
    assert!(certificate.contains(stated), "{certificate}");
    page.switch_to(own)?;
    Ok(())
}

/// A kind of sensor as it is registered, and what the page says of it.
struct Kind {
    serial: &'static str,
    unit: &'static str,
    /// Lines below the first of the list of units.
    place: usize,
    /// Gain of the charge amplifier, or burden.
    between: Option<&'static str>,
    /// Of the transducer of this rig, 9.285 mV/(m/s2) at 160 Hz, w = 1005 1/s.
    nominal: &'static str,
    conformity: &'static str,
}

const KINDS: [Kind; 4] = [
    Kind {
        serial: "V-1",
        unit: "mV/(mm/s)",
        place: 2,
        between: None,
        nominal: "9.33",
        conformity: "PASS",
    },
    Kind {
        serial: "D-1",
        unit: "mV/um",
        place: 3,
        between: None,
        // 9.38 mV/um, by half.
        nominal: "4.69",
        conformity: "FAIL",
    },
    Kind {
        serial: "Q-1",
        unit: "pC/g",
        place: 5,
        between: Some("10"),
        nominal: "9.11",
        conformity: "PASS",
    },
    Kind {
        serial: "T-1",
        unit: "mA/g",
        place: 7,
        between: Some("250"),
        nominal: "0.364",
        // Reported only.
        conformity: "",
    },
];

/// From the register to the conformity, on a phone, by the keys of the keyboard.
#[test]
fn every_kind_of_sensor_fits_a_phone_and_a_keyboard() -> Result<(), Fault> {
    // Unit and tolerance are the sensors', from the logbook.
    let unstated = [&LEFT_OUT[..], &["unit", "specification", "rule"]].concat();
    let Some(setup) = Setup::without(&unstated)? else {
        return Ok(());
    };
    let page = &setup.browser;
    page.screen(360, 640, 2.0, true)?;
    setup.connect()?;
    page.choose("#list", "typed")?;
    page.fill("#frequencies", "160")?;
    for (nth, kind) in KINDS.iter().enumerate() {
        register_by_keyboard(page, kind)?;
        page.tab_to("#start")?;
        page.press("Enter")?;
        page.wait_for_text("#kept", &format!("record {}", nth + 2))?;
        let units =
            "[...document.querySelectorAll('.unit')].map((one) => one.textContent).join(' ')";
        let units = page
            .value(units)?
            .to_string()
            .replace('\u{b5}', "u")
            .replace('\u{b2}', "2");
        assert!(units.contains(kind.unit), "{}: {units}", kind.unit);
        match kind.conformity {
            "" => assert_eq!(
                page.value("document.getElementById('conformity').hidden")?,
                true
            ),
            stated => page.wait_for_text("#conformity", stated)?,
        }
        everybody::nothing_is_sideways(page)?;
        everybody::controls_are_large(page)?;
        everybody::can_use_it(page)?;
    }
    Ok(())
}

fn register_by_keyboard(page: &Browser, kind: &Kind) -> Result<(), Fault> {
    let typed = |place: &str, text: &str| {
        page.tab_to(place)?;
        page.type_text(text)
    };
    page.tab_to("#registration summary")?;
    page.press("Enter")?;
    typed("#new-serial", kind.serial)?;
    typed("#register [name=sensitivity]", kind.nominal)?;
    page.tab_to("#new-unit")?;
    page.press("Home")?;
    (0..kind.place).try_for_each(|_| page.press("ArrowDown"))?;
    assert_eq!(
        page.value("document.getElementById('new-unit').value")?,
        kind.unit
    );
    if let Some(between) = kind.between {
        typed("#between-value", between)?;
        typed("#between-u", "0.5")?;
    }
    // With the form open as well.
    everybody::nothing_is_sideways(page)?;
    everybody::controls_are_large(page)?;
    if !kind.conformity.is_empty() {
        typed("#register [name=tolerance]", "5")?;
    }
    page.tab_to("#register button")?;
    page.press("Enter")?;
    page.wait_for_text("#sensor", kind.serial)
}

fn measure(setup: &Setup, record: u32) -> Result<(), Fault> {
    let page = &setup.browser;
    page.choose("#list", "typed")?;
    page.fill("#frequencies", "160")?;
    page.click("#start")?;
    page.wait_for_text("#kept", &format!("record {record}"))
}
