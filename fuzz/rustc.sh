#!/bin/sh
# Cargo's RUSTC_WORKSPACE_WRAPPER when it builds the fuzz targets: instruments the
# crates of this project, and leaves what they depend on as it was built for the
# tests. A build script or macro runs in the compiler, where no fuzzer listens.
case "$*" in
  *"--crate-name build_script_"* | *"--crate-type proc-macro"* | *"--print"*) exec "$@" ;;
esac
exec "$@" --cfg fuzzing -C debug-assertions -C overflow-checks -C codegen-units=1 \
  -C passes=sancov-module \
  -C llvm-args=-sanitizer-coverage-level=4 \
  -C llvm-args=-sanitizer-coverage-inline-8bit-counters \
  -C llvm-args=-sanitizer-coverage-pc-table \
  -C llvm-args=-sanitizer-coverage-trace-compares \
  -C llvm-args=-simplifycfg-branch-fold-threshold=0
