//! Words of operators and instruments: one line each, in the order they are written.
//!
//! A line feed in a serial number is a line of its own in a report, and controls of the direction of writing
//! (Unicode Standard Annex 9) show words in another order than they are in. Neither is part of any word. So
//! instruments take no such label, and readers put a question mark in place of each.

use heapless::String;

/// Whether a character steers a terminal, ends a line or turns one round.
pub fn steers(character: char) -> bool {
    character.is_control()
        || matches!(
            character,
            '\u{61c}'
                | '\u{200e}'
                | '\u{200f}'
                | '\u{2028}'..='\u{202e}'
                | '\u{2066}'..='\u{2069}'
        )
}

/// Whether these are words of one line.
pub fn is_plain(text: &str) -> bool {
    !text.chars().any(steers)
}

/// Puts a question mark in place of each character that steers; the text never becomes longer.
pub fn tame<const N: usize>(text: &mut String<N>) {
    if is_plain(text) {
        return;
    }
    let mut tamed = String::new();
    for character in text.chars() {
        // There is room for each: a question mark is one byte.
        let _ = tamed.push(if steers(character) { '?' } else { character });
    }
    *text = tamed;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_ends_or_turns_a_line_is_replaced_and_nothing_else() {
        let mut text: String<32> = "S\u{202e}1\nU\r\u{1b}[2J\u{2028}"
            .try_into()
            .expect("short");
        tame(&mut text);
        assert_eq!(text, "S?1?U??[2J?");
        let mut text: String<32> = "M\u{fc}ller \u{5d0} 2 \u{b0}C".try_into().expect("short");
        let before = text.clone();
        tame(&mut text);
        assert_eq!(text, before);
    }

    #[test]
    fn a_full_text_of_controls_stays_as_long_as_it_was_at_most() {
        let mut text: String<6> = "\u{2066}\u{2069}".try_into().expect("six bytes");
        tame(&mut text);
        assert_eq!(text, "??");
    }
}
