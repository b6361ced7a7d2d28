//! The lists kept on the instrument: which there are, and which of them a tap of the button measures.

use super::errors::ScpiError;
use crate::command::{self, Instrument};
use calib_protocol::lists::{KeptList, ListChange};
use calib_protocol::message::{Request, Response};
use core::fmt::Write;

/// Names of the lists, as strings; an empty one where there is none.
pub(super) async fn catalog(
    instrument: &mut impl Instrument,
    out: &mut impl Write,
) -> Result<(), ScpiError> {
    for place in 0..=u8::MAX {
        let Some(kept) = at(place, instrument).await? else {
            let _ = out.write_str(if place == 0 { "\"\"" } else { "" });
            break;
        };
        let separator = if place == 0 { "" } else { "," };
        let _ = write!(out, "{separator}\"{}\"", kept.list.terms.name);
    }
    Ok(())
}

/// Name of the list a tap of the button measures; empty: the default list.
pub(super) async fn chosen(
    instrument: &mut impl Instrument,
    out: &mut impl Write,
) -> Result<(), ScpiError> {
    for place in 0..=u8::MAX {
        match at(place, instrument).await? {
            Some(kept) if kept.chosen => {
                let _ = write!(out, "\"{}\"", kept.list.terms.name);
                return Ok(());
            }
            Some(_) => {}
            None => break,
        }
    }
    let _ = out.write_str("\"\"");
    Ok(())
}

/// Chooses the list of the name in quotes, under a hand.
pub(super) async fn choose(
    parameter: &str,
    instrument: &mut impl Instrument,
) -> Result<(), ScpiError> {
    if parameter.is_empty() {
        return Err(ScpiError::MissingParameter);
    }
    let quoted = |quote| parameter.strip_prefix(quote)?.strip_suffix(quote);
    let name = quoted('"').or(quoted('\'')).ok_or(ScpiError::DataType)?;
    let name = name.try_into().map_err(|_| ScpiError::IllegalParameter)?;
    // The same road a frame takes, with the same rule who may choose.
    let request = Request::ChangeLists(ListChange::Choose { name });
    match command::answer(request, instrument).await {
        Response::Refused(refusal) => Err(refusal.into()),
        _ => Ok(()),
    }
}

async fn at(place: u8, instrument: &mut impl Instrument) -> Result<Option<KeptList>, ScpiError> {
    match command::answer(Request::List { place }, instrument).await {
        Response::List(kept) => Ok(kept),
        _ => Err(ScpiError::StorageFault),
    }
}
