//! PDF/A-3b with the digital calibration certificate attached.

use super::model::Certificate;
use super::present::Presented;
use calib_certificate_pdf::{File, printable};
use calib_files::{Error, Result, text};
use serde_json::{Value, json};
use std::path::Path;

/// The built-in page.
pub(super) const TEMPLATE: &str = include_str!("page/certificate.typ");

/// Before every template, the laboratory's as well: the marks across each page.
const MARKS: &str = "#set page(foreground: { let marks = json(\"certificate.json\").marks; \
    if marks.len() > 0 { rotate(-50deg, text(size: 74pt, weight: \"bold\", \
    fill: rgb(179, 38, 30, 45), marks.map(mark => mark.at(0)).join(linebreak()))) } })\n";

/// The certificate as PDF/A-3b, by the laboratory's template or the built-in, with the DCC inside where there
/// is one.
///
/// One certificate always gives equal bytes: no clock is read, no font of the
/// system is used.
///
/// # Errors
/// [`Error::File`] when template or logo cannot be read, [`Error::Input`] with
/// the line of the template when it does not compile.
pub(super) fn render(
    certificate: &Certificate,
    presented: &Presented,
    dcc: Option<&[u8]>,
) -> Result<Vec<u8>> {
    let layout = &certificate.particulars.layout;
    let own = layout.template.as_deref();
    let template = own.map_or_else(|| Ok(TEMPLATE.to_owned()), read_text)?;
    let template = format!("{MARKS}{template}");
    let logo = layout.logo.as_deref().map(logo).transpose()?;
    let data = data(
        certificate,
        presented,
        logo.as_ref().map(|(name, _)| name.as_str()),
        dcc.is_some(),
    );
    let data = serde_json::to_vec(&data)
        .map_err(|e| Error::input("PDF", e.to_string(), "report this as a defect"))?;
    let square = super::square::draw(&super::square::text(certificate))?;
    let mut files = vec![
        File {
            name: "certificate.json",
            bytes: &data,
        },
        File {
            name: "verify.svg",
            bytes: square.as_bytes(),
        },
        File {
            name: "sensitivity.svg",
            bytes: presented.plot_sensitivity.as_bytes(),
        },
        File {
            name: "phase.svg",
            bytes: presented.plot_phase.as_bytes(),
        },
    ];
    if let Some((name, bytes)) = &logo {
        files.push(File { name, bytes });
    }
    if let Some(dcc) = dcc {
        files.push(File {
            name: "certificate.dcc.xml",
            bytes: dcc,
        });
    }
    let set = calib_certificate_pdf::render(&template, &files, &certificate.number);
    set.map_err(|error| {
        let name = own.map_or("certificate.typ".to_owned(), |path| {
            path.display().to_string()
        });
        // The line of the marks is not the template's.
        let line = error.line.saturating_sub(1).max(1);
        Error::input(format!("{name}:{line}"), error.problem, error.hint)
    })
}

fn read_text(path: &Path) -> Result<String> {
    text::read(path)
}

/// Name of the logo in the template, and its bytes.
fn logo(path: &Path) -> Result<(String, Vec<u8>)> {
    let extension = path
        .extension()
        .map(|e| e.to_string_lossy().to_lowercase())
        .unwrap_or_default();
    if !["svg", "png", "jpg", "jpeg"].contains(&extension.as_str()) {
        let place = path.display().to_string();
        return Err(Error::input(
            place,
            "is no picture the certificate can hold",
            "use SVG, PNG or JPEG",
        ));
    }
    let bytes = std::fs::read(path).map_err(|e| Error::file("read", path, e))?;
    Ok((format!("logo.{extension}"), bytes))
}

/// Data for the template: the presented certificate, every text printable.
fn data(certificate: &Certificate, presented: &Presented, logo: Option<&str>, dcc: bool) -> Value {
    let mut data = json!(presented);
    data["date"] = json!(
        certificate
            .particulars
            .calibration
            .issued
            .or(certificate.day)
            .map(|d| d.to_string())
    );
    data["laboratory"] = json!(
        certificate
            .particulars
            .laboratory
            .name
            .clone()
            .unwrap_or_default()
    );
    let laboratory = &certificate.particulars.laboratory;
    let city = [&laboratory.postcode, &laboratory.city].map(|part| part.as_deref().unwrap_or(""));
    let city = city.join(" ").trim().to_owned();
    let address = [laboratory.street.clone(), Some(city)]
        .into_iter()
        .flatten();
    let reach = [
        &laboratory.phone,
        &laboratory.email,
        &laboratory.accreditation,
    ];
    let lines = address.chain(reach.into_iter().flatten().cloned());
    data["address"] = lines.filter(|line| !line.is_empty()).collect();
    data["logo"] = json!(logo);
    data["dcc"] = json!(dcc);
    make_printable(&mut data);
    data
}

fn make_printable(value: &mut Value) {
    match value {
        Value::String(text) => *text = printable(text),
        Value::Array(values) => values.iter_mut().for_each(make_printable),
        Value::Object(map) => map.values_mut().for_each(make_printable),
        _ => (),
    }
}
