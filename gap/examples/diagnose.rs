//! Prints the answer for one dataset as JSON: `diagnose DATASET [VALIDATE]`.
fn main() {
    let a: Vec<std::path::PathBuf> = std::env::args_os().skip(1).map(Into::into).collect();
    let options = calib_gap::Options {
        validate: a.get(1).cloned(),
        ..Default::default()
    };
    match calib_gap::diagnose(&a[0], &options) {
        Ok(answer) => println!(
            "{}",
            serde_json::to_string_pretty(&answer).unwrap_or_default()
        ),
        Err(error) => eprintln!("{error}"),
    }
}
