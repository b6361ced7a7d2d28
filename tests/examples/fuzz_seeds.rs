//! Writes the seeds of the fuzz targets to `fuzz/corpus`.

use calib_tests::hostile::{Seed, seeds};
use std::path::Path;

fn main() -> std::io::Result<()> {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/corpus");
    for Seed {
        target,
        name,
        bytes,
    } in seeds()
    {
        let folder = corpus.join(target);
        std::fs::create_dir_all(&folder)?;
        std::fs::write(folder.join(name), bytes)?;
    }
    Ok(())
}
