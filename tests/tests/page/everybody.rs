//! The page for everybody: by thumb, by keyboard, by ear, in German.

use super::{SERIAL, Setup};
use calib_tests::browser::{Browser, axe};
use calib_tests::rigged::Fault;
use serde_json::json;

/// No rule of axe-core is broken, by day and by night.
pub(crate) fn can_use_it(page: &Browser) -> Result<(), Fault> {
    let Some(axe) = axe() else {
        return Ok(());
    };
    for scheme in ["light", "dark"] {
        let scheme = json!([{ "name": "prefers-color-scheme", "value": scheme }]);
        page.protocol("Emulation.setEmulatedMedia", json!({ "features": scheme }))?;
        let found = page.violations(&axe)?;
        assert!(found.is_empty(), "{scheme}: {found:#?}");
    }
    page.protocol("Emulation.setEmulatedMedia", json!({ "features": [] }))?;
    Ok(())
}

/// Connects, types a list and a serial number, and starts, by the keys of the keyboard.
pub(crate) fn begins_by_keyboard(setup: &Setup, frequencies: &str) -> Result<(), Fault> {
    let page = &setup.browser;
    page.open(&setup.server.url)?;
    page.wait_for_text("#link", "not connected")?;
    page.tab_to("#device")?;
    page.type_text(&setup.live.address)?;
    page.press("Enter")?;
    page.wait_for_text("#link", "connected to tcp:")?;
    page.tab_to("#serial")?;
    page.type_text(SERIAL)?;
    page.tab_to("#list")?;
    // The last of the lists is the one that is typed.
    page.press("End")?;
    page.tab_to("#frequencies")?;
    page.type_text(frequencies)?;
    page.tab_to("#start")?;
    page.press("Enter")
}

/// A finished calibration is worked with by Tab alone, and STOP is reached by it.
pub(crate) fn ends_by_keyboard(page: &Browser) -> Result<(), Fault> {
    for place in ["[data-format=html]", "[data-format=pdf]", "#stop", "#start"] {
        page.tab_to(place)?;
    }
    Ok(())
}

/// On a phone nothing is wider than the screen, and STOP is under the thumb
/// wherever the page is scrolled to.
pub(crate) fn fits_a_phone(setup: &Setup) -> Result<(), Fault> {
    let page = &setup.browser;
    page.screen(360, 640, 2.0, true)?;
    page.open(&setup.server.url)?;
    page.wait_for_text("#state", "finished")?;
    nothing_is_sideways(page)?;
    let stop_is_there =
        "(() => { const r = document.getElementById('stop').getBoundingClientRect();
        const at = document.elementFromPoint(r.x + r.width / 2, r.y + r.height / 2);
        return at.closest('#stop') !== null && r.top >= 0 && r.bottom <= innerHeight
            && r.height >= 48 && r.width >= 300; })()";
    let height = page.value("document.getElementById('content').scrollHeight")?;
    let height = height.as_u64().ok_or("no height")?;
    assert!(height > 640, "there is something to scroll: {height}");
    for place in [0, height / 2, height] {
        page.value(&format!(
            "document.getElementById('content').scrollTo(0, {place})"
        ))?;
        assert_eq!(page.value(stop_is_there)?, true, "scrolled to {place}");
    }
    points_are_cards(page)?;
    controls_are_large(page)?;
    can_use_it(page)?;
    page.screen(1280, 1000, 1.0, false)
}

/// Nothing is wider than the screen of a phone, and nothing within is to be moved sideways.
pub(crate) fn nothing_is_sideways(page: &Browser) -> Result<(), Fault> {
    for part in ["documentElement", "getElementById('content')"] {
        let fits = page.value(&format!("document.{part}.scrollWidth <= 360"))?;
        assert_eq!(fits, true, "{part}");
    }
    let sideways = "[...document.querySelectorAll('.scroll')].filter((place) => place.scrollWidth > place.clientWidth).length";
    assert_eq!(page.value(sideways)?, 0);
    Ok(())
}

/// Result above the form, each point with its state in sight.
fn points_are_cards(page: &Browser) -> Result<(), Fault> {
    let top = |id| format!("document.getElementById('{id}').getBoundingClientRect().top");
    let above = page.value(&format!("{} < {}", top("now"), top("run")))?;
    assert_eq!(above, true, "the result is above the form");
    let cards = "[...document.querySelectorAll('#points tr')].map((card) => {
        const state = card.lastElementChild.getBoundingClientRect(), all = card.getBoundingClientRect();
        return state.width > 0 && state.left >= 0 && state.right <= innerWidth && state.top - all.top < 40; })";
    assert_eq!(page.value(cards)?, json!([true, true, true]));
    Ok(())
}

/// Controls are 44 px high at least (WCAG 2.2, 2.5.5).
pub(crate) fn controls_are_large(page: &Browser) -> Result<(), Fault> {
    let small = "[...document.querySelectorAll('button, input, select, summary, a')]
        .filter((one) => one.checkVisibility() && one.getBoundingClientRect().height < 43.9)
        .map((one) => one.outerHTML)";
    assert_eq!(page.value(small)?, json!([]));
    Ok(())
}

/// In the browser's language, and in the one that is chosen; numbers too.
pub(crate) fn speaks_german(setup: &Setup) -> Result<(), Fault> {
    let page = &setup.browser;
    let agent = page.value("navigator.userAgent")?;
    page.protocol(
        "Emulation.setUserAgentOverride",
        json!({ "userAgent": agent, "acceptLanguage": "de-DE" }),
    )?;
    page.open(&setup.server.url)?;
    page.wait_for_text("#start", "Starten")?;
    page.wait_for_text("#state", "fertig")?;
    // The conformity comes from the server, and the laboratory's file states no language.
    page.wait_for_text("#conformity", "NICHT ERFÜLLT")?;
    page.wait_for_text("#points", "nicht erfüllt")?;
    page.wait_for_text("#sensitivity", ",")?;
    assert_eq!(page.value("document.documentElement.lang")?, "de");
    can_use_it(page)?;
    page.choose("#language", "en")?;
    page.wait_for_text("#start", "Start")?;
    page.wait_for_text("#conformity", "FAIL")?;
    page.open(&setup.server.url)?;
    page.wait_for_text("#state", "finished")?;
    page.choose("#language", "de")?;
    page.wait_for_text("#start", "Starten")?;
    page.choose("#language", "en")
}
