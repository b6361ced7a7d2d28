//! The object, who calibrated it and for whom.

use super::clause;
use super::value::{either, phrase, said, text};
use crate::model::{Section, Value};
use crate::particulars::{Contact, Particulars};
use calib_protocol::record::Record;

pub(super) fn item(record: &Record, particulars: &Particulars) -> Section {
    let item = &particulars.item;
    let labels = &record.head.labels;
    let model = either(&labels.dut_model, &item.model);
    let serial = either(&labels.dut_serial, &item.serial);
    let received = item.received.map(Value::Day);
    let kind = particulars.kind();
    // That of an accelerometer with a voltage goes without saying.
    let stated = (!kind.is_as_measured()).then(|| {
        let key = format!("kind.{}", kind.quantity_name());
        let said = phrase(key, &[kind.stated_unit().printed().to_owned()]);
        ("kind", clause::METHOD, said)
    });
    let lines = [
        ("description", clause::ITEM, said(&item.description)),
        ("model", clause::ITEM, model),
        ("serial", clause::ITEM, serial),
        ("customer_id", clause::ITEM, said(&item.customer_id)),
        ("condition", clause::ITEM, said(&item.condition)),
        ("received", clause::RECEIVED, received),
    ];
    Section::new("item", lines.into_iter().chain(stated))
}

pub(super) fn laboratory(particulars: &Particulars) -> Section {
    let laboratory = &particulars.laboratory;
    let customer = contact(&particulars.customer);
    let lines = [
        ("name", clause::LABORATORY, contact(laboratory)),
        (
            "accreditation",
            clause::NONE,
            said(&laboratory.accreditation),
        ),
        ("customer", clause::CUSTOMER, customer),
    ];
    Section::new("laboratory", lines)
}

/// A contact on one line: name, street, post code and city, country.
fn contact(contact: &Contact) -> Option<Value> {
    let part = |words: &Option<String>| {
        words
            .as_deref()
            .map(str::trim)
            .unwrap_or_default()
            .to_owned()
    };
    let city = format!("{} {}", part(&contact.postcode), part(&contact.city));
    let parts = [
        part(&contact.name),
        part(&contact.street),
        city.trim().to_owned(),
        part(&contact.country),
    ];
    let stated: Vec<String> = parts.into_iter().filter(|p| !p.is_empty()).collect();
    text(&stated.join(", "))
}
