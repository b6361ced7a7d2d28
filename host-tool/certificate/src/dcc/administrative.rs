//! Administrative data: software, core data, item, laboratory, people.

use super::needs::Needs;
use super::xml::Xml;
use crate::model::Certificate;
use crate::particulars::{Contact, Place};
use crate::present;
use crate::words::Language;

pub(super) fn write(
    xml: &mut Xml,
    certificate: &Certificate,
    needs: Needs<'_>,
    language: Language,
) {
    xml.element("dcc:administrativeData", |xml| {
        software(xml, certificate);
        core_data(xml, certificate, needs, language);
        items(xml, certificate, language);
        xml.element("dcc:calibrationLaboratory", |xml| {
            let laboratory = &certificate.particulars.laboratory;
            xml.optional(
                "dcc:calibrationLaboratoryCode",
                laboratory.accreditation.as_deref(),
            );
            contact(xml, "dcc:contact", laboratory, language);
        });
        people(xml, certificate, language);
        contact(
            xml,
            "dcc:customer",
            &certificate.particulars.customer,
            language,
        );
        statements(xml, certificate, language);
    });
}

/// Statement in words, or "not stated".
pub(super) fn stated(
    certificate: &Certificate,
    section: &str,
    key: &str,
    language: Language,
) -> String {
    let value = certificate.statement(section, key);
    value.map_or_else(
        || language.word("missing").to_owned(),
        |v| present::value(v, language),
    )
}

fn software(xml: &mut Xml, certificate: &Certificate) {
    let firmware = stated(certificate, "equipment", "firmware", Language::En);
    xml.element("dcc:dccSoftware", |xml| {
        one_software(xml, "calib", env!("CARGO_PKG_VERSION"), "application");
        one_software(xml, "calibrator firmware", &firmware, "firmware");
    });
}

/// A name and a release, which must look like v1.2.3.
pub(super) fn one_software(xml: &mut Xml, name: &str, version: &str, kind: &str) {
    let numeric = |c: char| c.is_ascii_digit() || c == '.';
    let number: String = version.chars().take_while(|c| numeric(*c)).collect();
    let complete = number.split('.').filter(|part| !part.is_empty()).count() == 3;
    let release = if complete {
        format!("v{number}")
    } else {
        "v0.0.0".to_owned()
    };
    xml.element("dcc:software", |xml| {
        xml.element("dcc:name", |xml| {
            xml.leaf("dcc:content", &format!("{name} {version}"))
        });
        xml.leaf("dcc:release", &release);
        xml.leaf("dcc:type", kind);
    });
}

fn core_data(xml: &mut Xml, certificate: &Certificate, needs: Needs<'_>, language: Language) {
    let Needs {
        days: (first, last),
        country,
    } = needs;
    let particulars = &certificate.particulars;
    let place = match particulars.calibration.place {
        Some(Place::Laboratory) => "laboratory",
        Some(Place::Customer) => "customer",
        Some(Place::Other) | None => "other",
    };
    xml.element("dcc:coreData", |xml| {
        xml.leaf("dcc:countryCodeISO3166_1", country);
        xml.leaf("dcc:usedLangCodeISO639_1", language.code());
        xml.leaf("dcc:mandatoryLangCodeISO639_1", language.code());
        xml.leaf("dcc:uniqueIdentifier", &certificate.number);
        if let Some(received) = particulars.item.received {
            xml.leaf("dcc:receiptDate", &received.to_string());
        }
        xml.leaf("dcc:beginPerformanceDate", &first.to_string());
        xml.leaf("dcc:endPerformanceDate", &last.to_string());
        xml.leaf("dcc:performanceLocation", place);
        if let Some(issued) = particulars.calibration.issued {
            xml.leaf("dcc:issueDate", &issued.to_string());
        }
        if let Some(amended) = &particulars.calibration.replaces {
            // A whole new one in place of the old, which is withdrawn (7.8.8.3); the reason has no
            // element of its own and is a statement.
            xml.element("dcc:reportAmendedSubstituted", |xml| {
                xml.leaf("dcc:typeOfChange", "substituted");
                xml.leaf("dcc:replacedUniqueIdentifier", amended.certificate.trim());
            });
        }
    });
}

fn items(xml: &mut Xml, certificate: &Certificate, language: Language) {
    let said = |key| stated(certificate, "item", key, language);
    let name = certificate.particulars.item.description.clone();
    let name = name.unwrap_or_else(|| language.word("item.default").to_owned());
    let serial = language.word("item.serial").to_owned();
    xml.element("dcc:items", |xml| {
        xml.element("dcc:item", |xml| {
            xml.content("dcc:name", language.code(), &name);
            xml.leaf("dcc:model", &said("model"));
            xml.element("dcc:identifications", |xml| {
                identification(xml, "manufacturer", &said("serial"), &serial, language);
                if let Some(id) = &certificate.particulars.item.customer_id {
                    let label = language.word("item.customer_id");
                    identification(xml, "customer", id, label, language);
                }
            });
        });
    });
}

pub(super) fn identification(
    xml: &mut Xml,
    issuer: &str,
    value: &str,
    name: &str,
    language: Language,
) {
    xml.element("dcc:identification", |xml| {
        xml.leaf("dcc:issuer", issuer);
        xml.leaf("dcc:value", value);
        xml.content("dcc:name", language.code(), name);
    });
}

fn contact(xml: &mut Xml, element: &str, contact: &Contact, language: Language) {
    let missing = language.word("missing");
    xml.element(element, |xml| {
        let name = contact.name.as_deref().unwrap_or(missing);
        xml.element("dcc:name", |xml| xml.leaf("dcc:content", name));
        xml.optional("dcc:eMail", contact.email.as_deref());
        xml.optional("dcc:phone", contact.phone.as_deref());
        xml.element("dcc:location", |xml| {
            xml.leaf("dcc:city", contact.city.as_deref().unwrap_or(missing));
            xml.optional("dcc:countryCode", contact.country.as_deref());
            xml.optional("dcc:postCode", contact.postcode.as_deref());
            xml.optional("dcc:street", contact.street.as_deref());
        });
    });
}

fn people(xml: &mut Xml, certificate: &Certificate, language: Language) {
    let operator = stated(certificate, "calibration", "operator", language);
    let approved_by = certificate.particulars.calibration.approved_by.as_deref();
    // Nobody authorised what nobody is named for.
    let approved_by = approved_by.map(str::trim).filter(|name| !name.is_empty());
    xml.element("dcc:respPersons", |xml| {
        if let Some(name) = approved_by {
            person(xml, name, language.word("calibration.approved_by"), true);
        }
        if approved_by != Some(operator.as_str()) {
            person(xml, &operator, language.word("calibration.operator"), false);
        }
    });
}

fn person(xml: &mut Xml, name: &str, role: &str, main: bool) {
    xml.element("dcc:respPerson", |xml| {
        xml.element("dcc:person", |xml| {
            xml.element("dcc:name", |xml| xml.leaf("dcc:content", name));
        });
        xml.leaf("dcc:role", role);
        xml.leaf("dcc:mainSigner", if main { "true" } else { "false" });
    });
}

/// Traceability, what the results relate to, adjustment, deviations, remarks.
fn statements(xml: &mut Xml, certificate: &Certificate, language: Language) {
    let traceability = stated(certificate, "equipment", "traceability", language);
    let of = |key| certificate.statement("calibration", key);
    xml.element("dcc:statements", |xml| {
        for (title, reason) in certificate.marks_in_words(language) {
            statement(
                xml,
                None,
                "7.8.2.1",
                &format!("{title}: {reason}"),
                language,
            );
        }
        let traceable = Some(certificate.traceable);
        statement(xml, traceable, "7.8.4.1 c", &traceability, language);
        statement(
            xml,
            None,
            "7.8.2.1 l",
            language.word("statement.relates"),
            language,
        );
        if let Some(value) = of("adjustment") {
            statement(
                xml,
                None,
                "7.8.4.1 d",
                &present::value(value, language),
                language,
            );
        }
        for key in [
            "substitution",
            "standard_certificate",
            "standard_due",
            "linearity",
        ] {
            if let Some(value) = of(key) {
                let label = format!("calibration.{key}");
                let name = language.word(&label);
                let said = format!("{name}: {}", present::value(value, language));
                statement(xml, None, "7.8.2.1 m", &said, language);
            }
        }
        if let Some(value) = of("replaces") {
            let said = present::value(value, language);
            statement(xml, None, "7.8.8", &said, language);
        }
        if let Some(value) = of("deviations") {
            statement(
                xml,
                None,
                "7.8.2.1 n",
                &present::value(value, language),
                language,
            );
        }
        if let Some(chain) = of("chain") {
            let sum = stated(certificate, "calibration", "sha256", language);
            let record = stated(certificate, "calibration", "record", language);
            let chain = present::value(chain, language);
            let text = format!("{record}, SHA-256 {sum}: {chain}");
            statement(xml, None, "7.11.3", &text, language);
        }
        for remark in &certificate.remarks {
            statement(
                xml,
                None,
                "7.8.7",
                &present::remark_text(remark, language),
                language,
            );
        }
    });
}

fn statement(xml: &mut Xml, traceable: Option<bool>, clause: &str, text: &str, language: Language) {
    xml.element("dcc:statement", |xml| {
        if let Some(traceable) = traceable {
            xml.leaf("dcc:traceable", if traceable { "true" } else { "false" });
        }
        xml.leaf("dcc:norm", "ISO/IEC 17025:2017");
        xml.leaf("dcc:reference", clause);
        xml.content("dcc:declaration", language.code(), text);
    });
}
