//! A signature in a PDF (PAdES, ETSI EN 319 142-1, level B-B): appended, so that every byte of before stays.
//!
//! Signed is the file from its first byte to its last, but for the hexadecimal digits of the signature
//! itself (ISO 32000-1, 12.8.1; ISO 19005-3, 6.4.3). The check takes nothing else for a signature.

use crate::dictionary::{first_reference, reference, value, whole};
use crate::{Certificate, LaboratoryKey, Problem, cms};
use jiff::Timestamp;
use jiff::tz::TimeZone;
use sha2::{Digest, Sha256};
use std::fmt::Write;
use std::ops::Range;

/// Bytes a signature takes beside its certificates: attributes, names and the longest RSA signature, twice over.
const ROOM: usize = 2048;
const RANGE: &[u8] = b"/ByteRange";
const TIME: &[u8] = b"/M(D:";
/// Pages within pages; no certificate has as many.
const DEEPEST: usize = 16;

fn unknown(what: &str) -> Problem {
    Problem::new(format!("is no PDF this tool can sign: {what}"))
}

fn last(bytes: &[u8], what: &[u8]) -> Option<usize> {
    bytes.windows(what.len()).rposition(|found| found == what)
}

/// Whether a signature is in it.
pub(crate) fn is_signed(file: &[u8]) -> bool {
    last(file, RANGE).is_some()
}

/// The file as far as its objects have to be known: written once, with a table of the classical form.
struct Written<'a> {
    file: &'a [u8],
    table: usize,
    trailer: &'a [u8],
}

impl<'a> Written<'a> {
    fn read(file: &'a [u8]) -> Result<Self, Problem> {
        let start = last(file, b"startxref").ok_or_else(|| unknown("it has no end"))?;
        let table: usize = word(&file[start + 9..]).ok_or_else(|| unknown("it has no table"))?;
        let rest = file.get(table..).unwrap_or_default();
        let trailer = rest.windows(7).position(|found| found == b"trailer");
        let trailer = trailer.filter(|_| rest.starts_with(b"xref"));
        let trailer = trailer.ok_or_else(|| unknown("its table is of another form"))?;
        let trailer = whole(&rest[trailer + 7..])?;
        let written = Self {
            file,
            table,
            trailer,
        };
        match value(trailer, "/Prev")?.or(value(trailer, "/Encrypt")?) {
            None => Ok(written),
            Some(_) => Err(unknown("it was changed since it was written")),
        }
    }

    fn needed(&self, key: &str) -> Result<&'a [u8], Problem> {
        value(self.trailer, key)?.ok_or_else(|| unknown(&format!("its end lacks {key}")))
    }

    /// Text of an object, by its number.
    fn object(&self, number: u32) -> Result<&'a [u8], Problem> {
        let missing = || unknown(&format!("object {number} is missing"));
        let table = &self.file[self.table..];
        // "xref\n0 N\n", then lines of 20 bytes: the form every file written at once has.
        let first = table
            .windows(3)
            .position(|w| w == b"\n0 ")
            .ok_or_else(missing)?;
        let lines = table[first + 1..].iter().position(|b| *b == b'\n');
        let lines = first + 1 + lines.ok_or_else(missing)? + 1;
        let line = lines + 20 * number as usize;
        let offset: usize = table
            .get(line..line + 10)
            .and_then(word)
            .ok_or_else(missing)?;
        let object = self.file.get(offset..).ok_or_else(missing)?;
        object
            .strip_prefix(format!("{number} 0 obj").as_bytes())
            .ok_or_else(missing)
    }

    fn dictionary(&self, number: u32) -> Result<&'a [u8], Problem> {
        let object = self.object(number)?.trim_ascii_start();
        whole(object)
    }

    /// The first page, which the signature's field belongs to.
    fn first_page(&self, catalogue: &[u8]) -> Result<(u32, &'a [u8]), Problem> {
        let missing = || unknown("it has no page");
        let pages = value(catalogue, "/Pages")?.and_then(reference);
        let mut number = pages.ok_or_else(missing)?;
        for _ in 0..DEEPEST {
            let node = self.dictionary(number)?;
            let Some(kids) = value(node, "/Kids")? else {
                return Ok((number, node));
            };
            number = first_reference(kids).ok_or_else(missing)?;
        }
        Err(missing())
    }
}

/// The number the bytes begin with.
fn word<T: std::str::FromStr>(bytes: &[u8]) -> Option<T> {
    let bytes = bytes.trim_ascii_start();
    let digits = bytes.iter().take_while(|byte| byte.is_ascii_digit());
    let digits = bytes.get(..digits.count())?;
    std::str::from_utf8(digits).ok()?.parse().ok()
}

/// The dictionary with one more entry.
fn with(dictionary: &[u8], entry: &str) -> Vec<u8> {
    let inside = dictionary.strip_suffix(b">>").unwrap_or(dictionary);
    [inside, entry.as_bytes(), b">>"].concat()
}

/// Signs a PDF that was written at once.
pub(crate) fn sign(file: &[u8], key: &LaboratoryKey, at: Timestamp) -> Result<Vec<u8>, Problem> {
    if is_signed(file) {
        return Err(Problem::new("is signed already"));
    }
    let room = ROOM
        + key
            .certificates()
            .iter()
            .map(|one| one.der().len())
            .sum::<usize>();
    let mut signed = appended(file, room, at)?;
    let gap = gap(&signed)?;
    let range = format!("[0 {} {} {}]", gap.start, gap.end, signed.len() - gap.end);
    let place = last(&signed, RANGE).ok_or_else(|| unknown("it has no end"))? + RANGE.len();
    signed[place..place + range.len()].copy_from_slice(range.as_bytes());
    let container = cms::sign(key, digest(&signed, &gap))?;
    let digits = hex::encode(container);
    if digits.len() > gap.len() - 2 {
        return Err(unknown("its signature has no room"));
    }
    signed[gap.start + 1..gap.start + 1 + digits.len()].copy_from_slice(digits.as_bytes());
    Ok(signed)
}

/// The file with the objects of a signature, of which bounds and digits are still to be filled in.
fn appended(file: &[u8], room: usize, at: Timestamp) -> Result<Vec<u8>, Problem> {
    let written = Written::read(file)?;
    let next: u32 = word(written.needed("/Size")?).ok_or_else(|| unknown("it has no size"))?;
    let root = reference(written.needed("/Root")?).ok_or_else(|| unknown("it has no root"))?;
    let catalogue = written.dictionary(root)?;
    if value(catalogue, "/AcroForm")?.is_some() {
        return Err(unknown("it has a form"));
    }
    let (page, dictionary) = written.first_page(catalogue)?;
    let (signature, field) = (next, next + 1);
    let form = format!("/AcroForm<</Fields[{field} 0 R]/SigFlags 3>>");
    let mut objects = vec![
        (root, with(catalogue, &form)),
        (signature, signature_object(room, at)),
        (field, field_object(signature, page)),
    ];
    objects.push(annotated(&written, page, dictionary, field)?);
    objects.sort_by_key(|(number, _)| *number);
    Ok(append(&written, root, next + 2, &objects))
}

/// Part written after the file: the objects, their table, and the way to the table before.
fn append(written: &Written<'_>, root: u32, size: u32, objects: &[(u32, Vec<u8>)]) -> Vec<u8> {
    let mut file = written.file.to_vec();
    if !file.ends_with(b"\n") {
        file.push(b'\n');
    }
    let mut table = String::from("xref\n");
    for (number, object) in objects {
        let _ = write!(table, "{number} 1\n{:010} 00000 n \n", file.len());
        file.extend(format!("{number} 0 obj\n").bytes());
        file.extend(object);
        file.extend(b"\nendobj\n");
    }
    let kept = ["/Info", "/ID"].map(|key| {
        let found = value(written.trailer, key).ok().flatten();
        let text = found.map(|found| String::from_utf8_lossy(found).into_owned());
        text.map_or(String::new(), |text| format!("{key} {text}"))
    });
    let start = file.len();
    let _ = write!(
        table,
        "trailer\n<</Size {size}/Root {root} 0 R{}{}/Prev {}>>\nstartxref\n{start}\n%%EOF\n",
        kept[0], kept[1], written.table
    );
    file.extend(table.bytes());
    file
}

fn signature_object(room: usize, at: Timestamp) -> Vec<u8> {
    let time = at.to_zoned(TimeZone::UTC).strftime("%Y%m%d%H%M%SZ");
    format!(
        "<</Type/Sig/Filter/Adobe.PPKLite/SubFilter/ETSI.CAdES.detached/M(D:{time})\
         /ByteRange{:60}/Contents<{}>>>",
        "",
        "0".repeat(2 * room)
    )
    .into_bytes()
}

/// A field nobody sees: what is printed stays as it was (ISO 19005-3, 6.3.3 lets one of no size go without looks).
fn field_object(signature: u32, page: u32) -> Vec<u8> {
    format!(
        "<</Type/Annot/Subtype/Widget/FT/Sig/T(Signature1)/V {signature} 0 R/P {page} 0 R\
         /Rect[0 0 0 0]/F 132>>"
    )
    .into_bytes()
}

/// The page, or the list of what lies on it, with the field.
fn annotated(
    written: &Written<'_>,
    page: u32,
    dictionary: &[u8],
    field: u32,
) -> Result<(u32, Vec<u8>), Problem> {
    let array = |list: &[u8]| {
        let inside = list.strip_suffix(b"]")?;
        Some([inside, format!(" {field} 0 R]").as_bytes()].concat())
    };
    let other = || unknown("what lies on its page is of another form");
    match value(dictionary, "/Annots")? {
        None => Ok((page, with(dictionary, &format!("/Annots[{field} 0 R]")))),
        Some(list) if list.starts_with(b"[") => {
            let at = list.as_ptr() as usize - dictionary.as_ptr() as usize;
            let list_with = array(list).ok_or_else(other)?;
            let after = &dictionary[at + list.len()..];
            Ok((page, [&dictionary[..at], &list_with, after].concat()))
        }
        Some(elsewhere) => {
            let number = reference(elsewhere).ok_or_else(other)?;
            let object = written.object(number)?.trim_ascii_start();
            let end = object.windows(6).position(|found| found == b"endobj");
            let list = object[..end.ok_or_else(other)?].trim_ascii_end();
            Ok((number, array(list).ok_or_else(other)?))
        }
    }
}

/// Where the digits of the last signature are, with the brackets around them.
fn gap(file: &[u8]) -> Result<Range<usize>, Problem> {
    let missing = || Problem::new("its signature is malformed");
    let range = last(file, RANGE).ok_or_else(missing)?;
    let rest = &file[range..];
    let contents = rest.windows(10).position(|found| found == b"/Contents<");
    let start = range + contents.ok_or_else(missing)? + 9;
    let end = file[start..].iter().position(|byte| *byte == b'>');
    Ok(start..start + end.ok_or_else(missing)? + 1)
}

fn digest(file: &[u8], gap: &Range<usize>) -> [u8; 32] {
    let sum = Sha256::new().chain_update(&file[..gap.start]);
    sum.chain_update(&file[gap.end..]).finalize().into()
}

/// A signature that holds.
pub(crate) struct Held {
    pub(crate) by: Certificate,
    pub(crate) others: Vec<Certificate>,
    /// When it was made, as its maker says.
    pub(crate) at: Option<Timestamp>,
}

/// Checks the last signature of a PDF: that it is over every byte but its own, and holds.
pub(crate) fn verify(file: &[u8]) -> Result<Held, Problem> {
    let gap = stated_gap(file)?;
    let digits = &file[gap.start + 1..gap.end - 1];
    let container = bytes(digits).ok_or_else(|| Problem::new("its signature is no number"))?;
    let (by, others) = cms::verify(&container, digest(file, &gap))?;
    let at = last(&file[..gap.start], TIME).and_then(|at| time(&file[at + TIME.len()..]));
    Ok(Held { by, others, at })
}

/// The bytes its signature leaves out, which are the digits of the signature and nothing else.
fn stated_gap(file: &[u8]) -> Result<Range<usize>, Problem> {
    let malformed = || Problem::new("its signature does not say what it signs");
    let range = last(file, RANGE).ok_or_else(malformed)? + RANGE.len();
    let rest = &file[range..];
    let end = rest
        .iter()
        .position(|byte| *byte == b']')
        .ok_or_else(malformed)?;
    let text = rest[..end].trim_ascii_start().strip_prefix(b"[");
    let text = std::str::from_utf8(text.ok_or_else(malformed)?).map_err(|_| malformed())?;
    let numbers: Result<Vec<usize>, _> = text.split_ascii_whitespace().map(str::parse).collect();
    let Ok(&[0, start, after, length]) = numbers.as_deref() else {
        return Err(malformed());
    };
    match after.checked_add(length) {
        Some(end) if end == file.len() => (),
        Some(end) if end < file.len() => {
            let added = file.len() - end;
            return Err(Problem::new(format!(
                "{added} bytes were added after it was signed"
            )));
        }
        _ => return Err(Problem::new("it was cut off after it was signed")),
    }
    let own = file.get(start..after).filter(|gap| gap.len() >= 2);
    match own.map(|gap| (gap[0], gap[gap.len() - 1])) {
        Some((b'<', b'>')) if file[..start].ends_with(b"/Contents") => Ok(start..after),
        _ => Err(Problem::new("its signature leaves out more than itself")),
    }
}

/// Hexadecimal digits as bytes.
fn bytes(digits: &[u8]) -> Option<Vec<u8>> {
    let digit = |byte: &u8| {
        char::from(*byte)
            .to_digit(16)
            .and_then(|d| u8::try_from(d).ok())
    };
    let pair = |pair: &[u8]| match pair {
        [high, low] => Some(16 * digit(high)? + digit(low)?),
        _ => None,
    };
    digits.chunks(2).map(pair).collect()
}

/// The time `20261123070000Z`, as this tool and most others write it.
fn time(text: &[u8]) -> Option<Timestamp> {
    let digits = std::str::from_utf8(text.get(..14)?).ok()?;
    let civil = jiff::civil::DateTime::strptime("%Y%m%d%H%M%S", digits).ok()?;
    let zone = text.get(14..)?;
    if !(zone.starts_with(b"Z") || zone.starts_with(b"+00")) {
        return None;
    }
    civil
        .to_zoned(TimeZone::UTC)
        .ok()
        .map(|zoned| zoned.timestamp())
}
