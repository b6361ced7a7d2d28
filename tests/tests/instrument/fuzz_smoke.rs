//! The fuzz targets on mutated seeds: a few seconds, the same inputs each time.
//! `./run bench fuzz` goes on from here.

use calib_tests::hostile::{self, Mutator, Seed, files};
use std::path::{Path, PathBuf};

fn corpus() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/corpus")
}

/// Runs `body` on every file of the target's corpus, and on `inputs` mutations.
fn smoke(target: &str, inputs: u32, body: fn(&[u8])) {
    let folder = corpus().join(target);
    let files = std::fs::read_dir(&folder).expect("the corpus is in the tree");
    let mut paths: Vec<PathBuf> = files.map(|file| file.expect("file").path()).collect();
    paths.sort();
    let seeds: Vec<Vec<u8>> = paths
        .iter()
        .map(|path| std::fs::read(path).expect("seed"))
        .collect();
    seeds.iter().for_each(|seed| body(seed));
    let mut mutator = Mutator::new(seeds, 1);
    for nth in 0..inputs {
        let input = mutator.next_input();
        let outcome = std::panic::catch_unwind(|| body(&input));
        assert!(outcome.is_ok(), "{target}, input {nth}: {input:02x?}");
    }
}

#[test]
fn the_decoder_finds_the_frames_there_are() {
    smoke("frames", 100_000, hostile::frames);
}

#[test]
fn the_command_layer_answers_what_is_whole_and_changes_nothing_unasked() {
    smoke("commands", 40_000, hostile::commands);
}

#[test]
fn records_of_any_bytes_are_read_or_refused() {
    smoke("records", 60_000, hostile::records);
}

#[test]
fn the_client_survives_a_device_that_answers_anything() {
    smoke("client", 40_000, hostile::client);
}

#[test]
fn files_of_any_content_are_read_or_refused() {
    smoke("points", 2_000, files::points);
    smoke("settings", 4_000, files::settings);
    smoke("particulars", 300, files::particulars);
    smoke("teds", 3_000, files::teds);
    smoke("rig", 5_000, files::rig);
    smoke("dataset", 300, files::dataset);
    smoke("logbook", 200, files::logbook);
    smoke("signed", 3_000, files::signed);
    smoke("metrology", 4_000, files::metrology);
}

/// `cargo run --release -p calib-tests --example fuzz_seeds` writes them.
#[test]
fn the_corpus_holds_every_seed() {
    for Seed {
        target,
        name,
        bytes,
    } in hostile::seeds()
    {
        let path = corpus().join(target).join(&name);
        let found = std::fs::read(&path).unwrap_or_default();
        assert!(found == bytes, "{target}/{name} is not what it should be");
    }
}
