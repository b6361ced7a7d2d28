//! A sensor is registered on the page, measured, adjusted and measured again.

use super::Setup;
use calib_tests::bench::Fault;

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
    page.value("document.querySelector('#register [name=due_day]').value = '2020-02-01'")?;
    page.click("#register button")?;
    page.wait_for_text("#sensor", "A-77 Examplia 1")?;
    page.wait_for_text("#due-list", "overdue since 2020-02-01")?;
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
    page.wait_for_text("#verdict", "FAIL")?;
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
    Ok(())
}

fn measure(setup: &Setup, record: u32) -> Result<(), Fault> {
    let page = &setup.browser;
    page.choose("#list", "typed")?;
    page.fill("#frequencies", "160")?;
    page.click("#start")?;
    page.wait_for_text("#kept", &format!("record {record}"))
}
