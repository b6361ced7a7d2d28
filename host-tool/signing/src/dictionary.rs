//! The few words of PDF an appended signature takes: where in a dictionary the value of a key stands.

use crate::Problem;
use std::ops::Range;

/// Depth of what is passed over; nothing that is written is as deep.
const DEEPEST: usize = 64;

/// The value of `key` (with its stroke) in the dictionary the bytes begin with.
pub(crate) fn value<'a>(bytes: &'a [u8], key: &str) -> Result<Option<&'a [u8]>, Problem> {
    let (entries, _) = entries(bytes)?;
    let found = entries.into_iter().find(|(name, _)| name == key.as_bytes());
    Ok(found.and_then(|(_, range)| bytes.get(range)))
}

/// The dictionary the bytes begin with, without what follows it.
pub(crate) fn whole(bytes: &[u8]) -> Result<&[u8], Problem> {
    let (_, end) = entries(bytes)?;
    Ok(&bytes[..end])
}

/// The number of the object `N 0 R` refers to.
pub(crate) fn reference(value: &[u8]) -> Option<u32> {
    let text = std::str::from_utf8(value).ok()?;
    let mut words = text.split_ascii_whitespace();
    let number = words.next()?.parse().ok()?;
    (words.next()? == "0" && words.next()? == "R" && words.next().is_none()).then_some(number)
}

/// The first reference of an array.
pub(crate) fn first_reference(array: &[u8]) -> Option<u32> {
    let inside = array.strip_prefix(b"[")?;
    let end = inside.iter().position(|byte| *byte == b'R')?;
    reference(inside.get(..=end)?)
}

type Entries = Vec<(Vec<u8>, Range<usize>)>;

fn malformed() -> Problem {
    Problem::new("is no PDF this tool can sign: a dictionary of it is malformed")
}

fn entries(bytes: &[u8]) -> Result<(Entries, usize), Problem> {
    let mut at = blank(bytes, 0);
    if !bytes[at..].starts_with(b"<<") {
        return Err(malformed());
    }
    at = blank(bytes, at + 2);
    let mut entries = Vec::new();
    while !bytes[at..].starts_with(b">>") {
        let name = token(bytes, at, 0)?;
        if bytes.get(at) != Some(&b'/') {
            return Err(malformed());
        }
        let begin = blank(bytes, name);
        let end = operand(bytes, begin)?;
        entries.push((bytes[at..name].to_vec(), begin..end));
        at = blank(bytes, end);
    }
    Ok((entries, at + 2))
}

/// End of the value that begins here; a reference has three words.
fn operand(bytes: &[u8], begin: usize) -> Result<usize, Problem> {
    let end = token(bytes, begin, 0)?;
    if !bytes[begin..end].iter().all(u8::is_ascii_digit) {
        return Ok(end);
    }
    let second = blank(bytes, end);
    let third = match bytes.get(second).is_some_and(u8::is_ascii_digit) {
        true => blank(bytes, token(bytes, second, 0)?),
        false => return Ok(end),
    };
    match bytes.get(third) {
        Some(b'R') => Ok(third + 1),
        _ => Ok(end),
    }
}

/// End of the token that begins here.
fn token(bytes: &[u8], at: usize, depth: usize) -> Result<usize, Problem> {
    let rest = bytes.get(at..).ok_or_else(malformed)?;
    match rest {
        _ if depth > DEEPEST => Err(malformed()),
        [b'<', b'<', ..] => group(bytes, at + 2, b">>", depth),
        [b'[', ..] => group(bytes, at + 1, b"]", depth),
        [b'<', ..] => {
            let end = rest.iter().position(|byte| *byte == b'>');
            end.map(|end| at + end + 1).ok_or_else(malformed)
        }
        [b'(', ..] => text(bytes, at),
        [first, ..] => {
            let begin = at + usize::from(*first == b'/');
            let length = bytes[begin..].iter().position(|byte| !is_regular(*byte));
            let end = length.map_or(bytes.len(), |length| begin + length);
            if end > at { Ok(end) } else { Err(malformed()) }
        }
        [] => Err(malformed()),
    }
}

fn group(bytes: &[u8], begin: usize, close: &[u8], depth: usize) -> Result<usize, Problem> {
    let mut at = blank(bytes, begin);
    while !bytes[at..].starts_with(close) {
        at = blank(bytes, token(bytes, at, depth + 1)?);
    }
    Ok(at + close.len())
}

/// End of a text in parentheses, which may hold others.
fn text(bytes: &[u8], begin: usize) -> Result<usize, Problem> {
    let (mut open, mut escaped) = (0, false);
    for (at, byte) in bytes.iter().enumerate().skip(begin) {
        match byte {
            _ if escaped => escaped = false,
            b'\\' => escaped = true,
            b'(' => open += 1,
            b')' if open == 1 => return Ok(at + 1),
            b')' => open -= 1,
            _ => (),
        }
    }
    Err(malformed())
}

fn is_blank(byte: u8) -> bool {
    matches!(byte, 0 | b'\t' | b'\n' | 0x0c | b'\r' | b' ')
}

fn is_regular(byte: u8) -> bool {
    !is_blank(byte) && !b"()<>[]{}/%".contains(&byte)
}

/// Where the blanks that begin here end.
fn blank(bytes: &[u8], at: usize) -> usize {
    let blanks = bytes.iter().skip(at).take_while(|byte| is_blank(**byte));
    (at + blanks.count()).min(bytes.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_ends_where_the_next_key_begins() {
        let bytes =
            b"<</A 12 0 R/B[1 0 R 2 0 R]/C<</A(x\\)(y))>> /D <0aff>/E/F/G 7/H true>> endobj";
        let of = |key| value(bytes, key).expect("well formed");
        assert_eq!(of("/A"), Some(&b"12 0 R"[..]));
        assert_eq!(of("/B"), Some(&b"[1 0 R 2 0 R]"[..]));
        assert_eq!(of("/C"), Some(&b"<</A(x\\)(y))>>"[..]));
        assert_eq!(of("/D"), Some(&b"<0aff>"[..]));
        assert_eq!(of("/E"), Some(&b"/F"[..]));
        assert_eq!(of("/G"), Some(&b"7"[..]));
        assert_eq!(of("/H"), Some(&b"true"[..]));
        assert_eq!(of("/I"), None);
        assert_eq!(reference(b"12 0 R"), Some(12));
        assert_eq!(first_reference(b"[1 0 R 2 0 R]"), Some(1));
        assert!(whole(bytes).expect("well formed").ends_with(b"true>>"));
    }

    #[test]
    fn what_ends_too_soon_is_refused() {
        let bytes = b"<</A 12 0 R/B[1 0 R (t\\))]/C<</A<0a>>>>>";
        for end in 0..bytes.len() {
            assert!(whole(&bytes[..end]).is_err(), "{end}");
        }
        let deep = [b"<</A".as_slice(), &b"[".repeat(100_000)].concat();
        assert!(whole(&deep).is_err());
    }
}
