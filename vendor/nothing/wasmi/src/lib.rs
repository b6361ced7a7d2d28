//! In the place of the published `wasmi`, which runs the WebAssembly plugins that a document may load.
//!
//! No module is read, so there is none to run: what follows one has no values.
#![no_std]

use core::marker::PhantomData;

/// How modules are to be read.
#[derive(Default)]
pub struct Config;

impl Config {
    /// Takes the setting, of which nothing depends.
    pub fn wasm_relaxed_simd(&mut self, _on: bool) -> &mut Self {
        self
    }
}

/// What would run modules.
pub struct Engine;

impl Engine {
    /// An engine that runs nothing.
    pub fn new(_config: &Config) -> Self {
        Self
    }
}

/// Every module is refused.
#[derive(Debug)]
pub struct Error;

impl core::fmt::Display for Error {
    fn fmt(&self, to: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        to.write_str("this program runs no WebAssembly")
    }
}

/// A module that was read: there is none.
pub enum Module {}

impl Module {
    /// Refuses the module.
    pub fn new(_engine: &Engine, _bytes: &[u8]) -> Result<Self, Error> {
        Err(Error)
    }

    /// What the module exports by a name.
    pub fn get_export(&self, _name: &str) -> Option<ExternType> {
        match *self {}
    }

    /// What the module exports.
    pub fn exports(&self) -> core::slice::Iter<'_, ExportType> {
        match *self {}
    }
}

/// An export of a module.
pub enum ExportType {}

impl ExportType {
    /// Its name.
    pub fn name(&self) -> &str {
        match *self {}
    }

    /// Its type.
    pub fn ty(&self) -> &ExternType {
        match *self {}
    }
}

/// Type of an export.
pub enum ExternType {
    /// A function.
    Func(FuncType),
    /// A memory.
    Memory(Memory),
}

/// Type of a function.
pub enum FuncType {}

impl FuncType {
    /// Types of its parameters.
    pub fn params(&self) -> &[ValType] {
        match *self {}
    }

    /// Types of its results.
    pub fn results(&self) -> &[ValType] {
        match *self {}
    }
}

/// Type of a value.
#[derive(Clone, Copy, PartialEq)]
pub enum ValType {
    /// A 32-bit integer.
    I32,
}

/// A value.
pub enum Val {
    /// A 32-bit integer.
    I32(i32),
}

/// What a module may call.
pub struct Linker<T> {
    engine: Engine,
    data: PhantomData<fn(T)>,
}

impl<T> Linker<T> {
    /// A linker of nothing.
    pub fn new(_engine: &Engine) -> Self {
        Self {
            engine: Engine,
            data: PhantomData,
        }
    }

    /// Takes a function that nobody calls.
    pub fn func_wrap<F>(&mut self, _of: &str, _name: &str, _function: F) -> Result<&mut Self, Error> {
        Ok(self)
    }

    /// The engine it links for.
    pub fn engine(&self) -> &Engine {
        &self.engine
    }

    /// An instance of a module.
    pub fn instantiate_and_start(&self, _store: &mut Store<T>, module: &Module) -> Result<Instance, Error> {
        match *module {}
    }
}

/// Data of the host beside an instance.
pub struct Store<T>(T);

impl<T> Store<T> {
    /// Keeps the data.
    pub fn new(_engine: &Engine, data: T) -> Self {
        Self(data)
    }

    /// The data.
    pub fn data_mut(&mut self) -> &mut T {
        &mut self.0
    }
}

/// An instance of a module: there is none.
pub enum Instance {}

impl Instance {
    /// What the instance exports by a name.
    pub fn get_export<T>(&self, _store: &Store<T>, _name: &str) -> Option<Extern> {
        match *self {}
    }
}

/// An export of an instance: there is none.
pub enum Extern {}

impl Extern {
    /// The export, if it is a function.
    pub fn into_func(self) -> Option<Func> {
        match self {}
    }

    /// The export, if it is a memory.
    pub fn into_memory(self) -> Option<Memory> {
        match self {}
    }
}

/// A function of an instance: there is none.
pub enum Func {}

impl Func {
    /// Its type.
    pub fn ty<T>(&self, _store: &Store<T>) -> FuncType {
        match *self {}
    }

    /// Calls it.
    pub fn call<T>(&self, _store: &mut Store<T>, _given: &[Val], _results: &mut [Val]) -> Result<(), Error> {
        match *self {}
    }
}

/// A memory of an instance: there is none.
pub enum Memory {}

impl Memory {
    /// Its pages.
    pub fn size<T>(&self, _store: &Store<T>) -> u64 {
        match *self {}
    }

    /// Adds pages.
    pub fn grow<T>(&self, _store: &mut Store<T>, _pages: u64) -> Result<u64, Error> {
        match *self {}
    }

    /// Its bytes.
    pub fn data<'a, T>(&self, _store: &'a Store<T>) -> &'a [u8] {
        match *self {}
    }

    /// Its bytes.
    pub fn data_mut<'a, T>(&self, _store: &'a mut Store<T>) -> &'a mut [u8] {
        match *self {}
    }

    /// Reads bytes.
    pub fn read<T>(&self, _caller: &Caller<'_, T>, _offset: usize, _into: &mut [u8]) -> Result<(), Error> {
        match *self {}
    }

    /// Writes bytes.
    pub fn write<T>(&self, _caller: &mut Caller<'_, T>, _offset: usize, _bytes: &[u8]) -> Result<(), Error> {
        match *self {}
    }
}

/// The instance that calls the host.
pub struct Caller<'a, T>(&'a mut T, Instance);

impl<T> Caller<'_, T> {
    /// What the caller exports by a name.
    pub fn get_export(&self, _name: &str) -> Option<Extern> {
        match self.1 {}
    }

    /// Data of the host.
    pub fn data_mut(&mut self) -> &mut T {
        self.0
    }
}
