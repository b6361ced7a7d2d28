//! Prints the answer for one dataset as JSON: `diagnose DATASET [VALIDATE|-] [WITHOUT,...|-] [MOST]`.
fn main() {
    let a: Vec<String> = std::env::args().skip(1).collect();
    let Some(dataset) = a.first() else {
        eprintln!("usage: diagnose DATASET [VALIDATE|-] [WITHOUT,...|-] [MOST]");
        return;
    };
    let without = a.get(2).map_or("", String::as_str).split(',');
    let options = calib_gap::Options {
        validate: a.get(1).filter(|v| *v != "-").map(Into::into),
        without: without
            .filter(|n| !n.is_empty() && *n != "-")
            .map(Into::into)
            .collect(),
        most_effects: a.get(3).and_then(|n| n.parse().ok()),
    };
    match calib_gap::diagnose(dataset.as_ref(), &options) {
        Ok(answer) => println!(
            "{}",
            serde_json::to_string_pretty(&answer).unwrap_or_default()
        ),
        Err(error) => eprintln!("{error}"),
    }
}
