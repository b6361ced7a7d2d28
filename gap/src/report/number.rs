//! Numbers as a person reads them.

/// Three significant digits, without an exponent where it reads better.
pub(super) fn short(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return "0".into();
    }
    let decade = value.abs().log10().floor() as i32;
    if !(-4..6).contains(&decade) {
        return format!("{value:.2e}");
    }
    let text = format!("{value:.*}", (2 - decade).max(0) as usize);
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').into()
    } else {
        text
    }
}
