//! The square of a printed certificate (QR code, ISO/IEC 18004): what a telephone needs to ask whether it is true.

use super::model::{Certificate, Value};
use calib_files::{Error, Result};
use qrcode::render::svg;
use qrcode::{EcLevel, QrCode};

/// Where it is verified when the laboratory states no place of its own.
const WITH_THE_TOOL: &str = "calib verify";

/// Number, sum of the record, and where to verify; a line each.
pub(super) fn text(certificate: &Certificate) -> String {
    let entries = certificate
        .sections
        .iter()
        .flat_map(|section| &section.entries);
    let sum = entries.filter(|entry| entry.key == "sha256");
    let sum = sum.filter_map(|entry| match &entry.value {
        Some(Value::Text(sum)) => Some(sum.replace(' ', "")),
        _ => None,
    });
    let laboratory = &certificate.particulars.laboratory;
    let place = laboratory.verify_at.as_deref().unwrap_or(WITH_THE_TOOL);
    let sum: String = sum.take(1).collect();
    let number = &certificate.number;
    format!("CERTIFICATE {number}\nRECORD SHA-256 {sum}\nVERIFY {place}")
}

/// The square, with the rim that readers want, as SVG.
///
/// # Errors
/// [`Error::Input`] when the text is too long for any.
pub(super) fn draw(text: &str) -> Result<String> {
    // 15 % of it may be damaged: a fold, or a stamp.
    let square = QrCode::with_error_correction_level(text, EcLevel::M);
    let square = square.map_err(|error| {
        let hint = "state a shorter verify_at under [laboratory]";
        Error::input("square of the certificate", error.to_string(), hint)
    })?;
    Ok(square.render::<svg::Color<'_>>().build())
}
