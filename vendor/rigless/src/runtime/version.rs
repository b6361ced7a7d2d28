// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! What this runtime calls itself.
//!
//! An official release says its version alone, `X.Y.Z`. Any other build says which source it is as
//! semver build metadata: `X.Y.Z+<commit>` for a commit that isn't the release, and
//! `X.Y.Z+<commit>.dirty` when the tree had changes that commit doesn't hold. A result from a runtime
//! that isn't a release can't pass for one. `build.rs` decides:
//!
//! * A package from the registry is the release when cargo recorded a clean tree packing it.
//! * A checkout is the release only at the tag its version names, with nothing that builds changed:
//!   the sources, the build script and the manifests.
//! * A build with neither says `+unknown`.

#[cfg(test)]
mod provenance;

/// This runtime's version, as `rigless --version` prints it and the target's `Manifest` carries it.
pub const RUNTIME: &str = include!(concat!(env!("OUT_DIR"), "/version.rs"));
