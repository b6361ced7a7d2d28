//! The verdict as nobody overlooks it.

use calib_certificate::Verdict;

/// Columns every terminal has.
const COLUMNS: usize = 80;

/// Verdict between two rules, and what decided below it.
pub fn show(verdict: &Verdict) -> String {
    let rule = "=".repeat(verdict.title.chars().count() + 6);
    let mut text = format!("{rule}\n   {}\n{rule}\n", verdict.title);
    let mut column = 0;
    for word in verdict.because.split(' ') {
        let length = word.chars().count();
        let begins = column == 0;
        if !begins && column + 1 + length > COLUMNS {
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
    fn a_verdict_stands_alone_on_its_line() {
        let verdict = Verdict {
            conformity: Stated::Fail,
            title: "FAIL".to_owned(),
            because: "+5.92 % of nominal, limit \u{b1}5 %, at 160 Hz (U = 0.77 %)".to_owned(),
            frequency_hz: None,
            base: None,
            deviation_rel: None,
            lower_limit_rel: None,
            upper_limit_rel: None,
        };
        let shown = show(&verdict);
        assert!(shown.lines().any(|line| line.trim() == "FAIL"), "{shown}");
        assert!(shown.ends_with("(U = 0.77 %)"), "{shown}");
        assert!(shown.lines().all(|line| line.chars().count() <= COLUMNS));
    }
}
