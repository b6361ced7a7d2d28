// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The `rigless` command over every machine this build carries. The command itself is
//! `rigless::cli`, so a binary of your own over your own machines is the same line.

fn main() -> std::process::ExitCode {
    rigless::cli::main(rigless::machine::all())
}
