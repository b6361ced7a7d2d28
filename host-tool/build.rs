//! Lets `./run package` put the firmware image into the tool: `CALIB_EMBED_IMAGE` names it.

const VARIABLE: &str = "CALIB_EMBED_IMAGE";

fn main() {
    println!("cargo::rustc-check-cfg=cfg(image_inside)");
    println!("cargo::rerun-if-env-changed={VARIABLE}");
    if let Ok(image) = std::env::var(VARIABLE) {
        println!("cargo::rerun-if-changed={image}");
        println!("cargo::rustc-cfg=image_inside");
    }
}
