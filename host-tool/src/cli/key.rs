//! `calib key`: the key an instrument signs its records with.

use super::Context;
use super::hand::Hand;
use calib_host::{Error, Result};
use calib_logbook::Logbook;
use calib_protocol::signature::{DeviceKey, PublicKey};
use calib_record::signature::short;
use clap::Args;
use jiff::Timestamp;
use schemars::JsonSchema;
use serde::Serialize;

/// `calib key`.
#[derive(Debug, Args)]
#[command(after_help = "\
An instrument makes its key once in its life, with its own generator of random numbers, while
its button is held; the half that signs never leaves it. From then on every record is signed,
and the logbook refuses unsigned records of the instrument. The public key enters the logbook,
if there is one. When another computer shows its digits, compare them with those on the
instrument's paper. An instrument whose memory was erased makes another key, and counts its
records anew. The logbook takes both keys only when --replaced says why, for a forger's
instrument looks the same. Earlier records stay with the earlier key. docs/safety.md says what
the key proves and what it does not.")]
pub(crate) struct Key {
    /// Makes the key of an instrument that has none.
    #[arg(long)]
    make: bool,
    /// Reason why it has another key than the logbook knows, such as `memory erased in repair, order 4711`; it is
    /// kept for good.
    #[arg(long, value_name = "REASON")]
    replaced: Option<String>,
    #[command(flatten)]
    hand: Hand,
}

/// The key of an instrument.
#[derive(Serialize, JsonSchema)]
pub(super) struct KeyView {
    instrument_serial: String,
    /// The public key (Ed25519), in hexadecimal digits; none where the instrument signs nothing.
    public_key: Option<String>,
    /// Running number of the first record it signed.
    signed_since_record: Option<u32>,
    /// Why it is another key than before, as the logbook has it; none of the first.
    replaced_because: Option<String>,
    /// Whether the logbook has it now.
    in_logbook: bool,
}

impl Key {
    /// Prints the key, after making it if asked to, and enters it in the logbook.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let mut client = self.hand.connect(context)?;
        let serial = client.info()?.serial;
        let key = match self.make {
            true => Some(
                self.hand
                    .wait_for(context, &mut client, |client| client.make_key())?,
            ),
            false => client.key()?,
        };
        let logbook = context.logbook_if_there()?;
        let replaced_because = match (&logbook, &key) {
            (Some(logbook), Some(key)) => self.enter(logbook, &serial, key)?,
            _ if self.replaced.is_some() => return Err(nothing_to_enter(key.is_some())),
            _ => None,
        };
        let view = KeyView {
            instrument_serial: serial.as_str().to_owned(),
            public_key: key.map(|key| hex::encode(key.public)),
            signed_since_record: key.map(|key| key.since),
            replaced_because,
            in_logbook: logbook.is_some() && key.is_some(),
        };
        context.print(&view, || view.text(key))
    }
}

impl Key {
    /// Enters the key, in place of the one before where that is said; why it is another one.
    fn enter(&self, logbook: &Logbook, serial: &str, key: &DeviceKey) -> Result<Option<String>> {
        match &self.replaced {
            Some(reason) => {
                let now = Timestamp::now().as_second();
                logbook.replace_key(serial, key, reason, now).map(drop)?;
            }
            None => logbook.enter_key(serial, key).map(drop)?,
        }
        let last = logbook.keys(serial)?.pop();
        Ok(last
            .map(|last| last.reason)
            .filter(|reason| !reason.is_empty()))
    }
}

/// Error that says what is missing for a statement.
fn nothing_to_enter(has_key: bool) -> Error {
    match has_key {
        true => Error::input(
            "--replaced",
            "there is no logbook that has a key",
            "name it with --logbook or CALIB_LOGBOOK",
        ),
        false => Error::input(
            "--replaced",
            "the instrument has no key",
            "`calib key --make --replaced REASON` makes one",
        ),
    }
}

impl KeyView {
    fn text(&self, key: Option<DeviceKey>) -> String {
        let Some(key) = key else {
            return format!(
                "{} has no key: its records are not signed. `calib key --make` makes one\n",
                self.instrument_serial
            );
        };
        let kept = match self.in_logbook {
            true => "in the logbook",
            false => {
                "there is no logbook to keep it in: `calib sensors add` and `calib logbook add` make one"
            }
        };
        let because = self.replaced_because.as_ref();
        let because = because.map(|why| format!("; in place of another: {why}"));
        format!(
            "{}  {}  signs its records from number {} on; {kept}{}\n",
            self.instrument_serial,
            short(&key.public),
            key.since,
            because.unwrap_or_default()
        )
    }
}

/// The key of 64 hexadecimal digits, as `calib key --json` prints them.
pub(super) fn parse(digits: &str) -> std::result::Result<PublicKey, String> {
    let wrong = || "a key is 64 hexadecimal digits, as `calib key --json` prints them".to_owned();
    let digits: Vec<u8> = digits.bytes().filter(|byte| *byte != b' ').collect();
    let digit = |byte: u8| char::from(byte).to_digit(16).ok_or_else(wrong);
    let pairs = digits.chunks(2).map(|pair| match *pair {
        [high, low] => Ok((digit(high)? * 16 + digit(low)?) as u8),
        _ => Err(wrong()),
    });
    let bytes: Vec<u8> = pairs.collect::<std::result::Result<_, _>>()?;
    bytes.try_into().map_err(|_| wrong())
}
