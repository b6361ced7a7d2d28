//! The conformity as nobody overlooks it.

use super::COLUMNS;
use calib_certificate::ConformityStatement;

/// Conformity between two rules, and what decided below it, on a terminal of 80 columns.
pub fn show(conformity: &ConformityStatement) -> String {
    within(conformity, COLUMNS)
}

/// Conformity between two rules, and what decided below it, in `width` columns.
pub(super) fn within(conformity: &ConformityStatement, width: usize) -> String {
    let rule = "=".repeat(conformity.title.chars().count() + 6);
    format!(
        "{rule}\n   {}\n{rule}\n{}",
        conformity.title,
        wrapped(&conformity.because, width)
    )
}

/// The words in lines of at most `width` columns.
pub(super) fn wrapped(words: &str, width: usize) -> String {
    let mut text = String::new();
    let mut column = 0;
    for word in words.split(' ') {
        let length = word.chars().count();
        let begins = column == 0;
        if !begins && column + 1 + length > width {
            text.push('\n');
            column = 0;
        } else if !begins {
            text.push(' ');
            column += 1;
        }
        text.push_str(word);
        column += length;
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_certificate::decision::Stated;

    #[test]
    fn a_conformity_stands_alone_on_its_line() {
        let conformity = ConformityStatement {
            conformity: Stated::Fail,
            title: "FAIL".to_owned(),
            because: "+5.92 % of nominal, limit \u{b1}5 %, at 160 Hz (U = 0.77 %)".to_owned(),
            frequency_hz: None,
            base: None,
            deviation_from_base_rel: None,
            lower_limit_rel: None,
            upper_limit_rel: None,
        };
        let shown = show(&conformity);
        assert!(shown.lines().any(|line| line.trim() == "FAIL"), "{shown}");
        assert!(shown.ends_with("(U = 0.77 %)"), "{shown}");
        assert!(shown.lines().all(|line| line.chars().count() <= COLUMNS));
    }
}
