//! A page used by its keyboard alone.

use crate::browser::Browser;
use crate::rigged::Fault;
use serde_json::json;

/// More keys than a page has places that take the focus.
const MOST_PLACES: usize = 120;

impl Browser {
    /// Presses one of the keys Tab, Enter, Home, End and ArrowDown, wherever the focus is.
    ///
    /// # Errors
    /// The browser refuses.
    pub fn press(&self, key: &str) -> Result<(), Fault> {
        let (number, text) = match key {
            "Tab" => (9, ""),
            "Enter" => (13, "\r"),
            "End" => (35, ""),
            "Home" => (36, ""),
            "ArrowDown" => (40, ""),
            other => return Err(format!("no key {other}").into()),
        };
        for (event, text) in [("keyDown", text), ("keyUp", "")] {
            let event = json!({ "type": event, "key": key, "code": key, "text": text, "windowsVirtualKeyCode": number });
            self.protocol("Input.dispatchKeyEvent", event)?;
        }
        Ok(())
    }

    /// Types where the focus is, in place of what is there.
    ///
    /// # Errors
    /// The browser refuses.
    pub fn type_text(&self, text: &str) -> Result<(), Fault> {
        self.value("document.activeElement.select()")?;
        self.protocol("Input.insertText", json!({ "text": text }))?;
        Ok(())
    }

    /// Presses Tab until the focus is on what `selector` names, and sees on the way that it can be seen where the
    /// focus is.
    ///
    /// # Errors
    /// It never gets there, or cannot be seen.
    pub fn tab_to(&self, selector: &str) -> Result<(), Fault> {
        let there = format!("document.activeElement.matches({})", json!(selector));
        let marked = "document.activeElement === document.body
            || getComputedStyle(document.activeElement).outlineStyle !== 'none'";
        for _ in 0..MOST_PLACES {
            self.press("Tab")?;
            if self.value(marked)? != true {
                let place = self.value("document.activeElement.outerHTML")?;
                return Err(format!("the focus does not show on {place}").into());
            }
            if self.value(&there)? == true {
                return Ok(());
            }
        }
        Err(format!("Tab never gets to {selector}").into())
    }
}
