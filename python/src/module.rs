//! The Python module: a handful of functions, each a closure over values of Rust.

use crate::work::{Heard, Nothing, Work};
use calib_host::cli::{Failure, ask_for_silence};
use calib_link::StopSwitch;
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::PyValueError;
use pyo3::ffi;
use pyo3::prelude::*;
use pyo3::types::{PyCFunction, PyCapsule, PyCapsuleMethods, PyDict, PyTuple};
use serde_json::Value;
use std::ffi::{CStr, OsString};
use std::time::Duration;

/// Between two looks at Python's signals: Ctrl-C is felt as immediate.
const LOOK: Duration = Duration::from_millis(50);

/// Output of a verb (documents and lines, then remarks), and how it failed: error, hint, exit code.
type Answer = (
    Vec<String>,
    Vec<String>,
    Option<(String, Option<String>, u8)>,
);

/// A stop that any thread may ask for, in a capsule.
struct Stop {
    switch: StopSwitch,
    emulated: bool,
}

/// Name of the capsule of a [`Stop`].
const STOP: &CStr = c"calib._calib.stop";

/// A new stop; of an emulated calibrator no alarm is given.
fn stop<'py>(py: Python<'py>, given: &Bound<'py, PyTuple>) -> PyResult<Bound<'py, PyCapsule>> {
    let (emulated,): (bool,) = given.extract()?;
    let switch = StopSwitch::default();
    PyCapsule::new_with_value(py, Stop { switch, emulated }, STOP)
}

/// Switch of a stop, and whether its calibrator is emulated.
fn opened(capsule: &Bound<'_, PyAny>) -> PyResult<(StopSwitch, bool)> {
    let capsule = capsule.cast::<PyCapsule>()?;
    let pointer = capsule.pointer_checked(Some(STOP))?.cast::<Stop>();
    // SAFETY: a capsule of this name holds a `Stop` for as long as it lives, which is borrowed here, and nobody
    // changes it.
    let stop = unsafe { pointer.as_ref() };
    Ok((stop.switch.clone(), stop.emulated))
}

/// Asks for silence; the number of this stop.
fn ask(given: &Bound<'_, PyTuple>) -> PyResult<u64> {
    let (capsule,): (Bound<'_, PyAny>,) = given.extract()?;
    let (switch, emulated) = opened(&capsule)?;
    Ok(ask_for_silence(&switch, emulated))
}

/// Whether the exciter is silent since this stop or a later one.
fn is_confirmed(given: &Bound<'_, PyTuple>) -> PyResult<bool> {
    let (capsule, number): (Bound<'_, PyAny>, u64) = given.extract()?;
    Ok(opened(&capsule)?.0.is_confirmed(number))
}

/// Carries out the verb of these words, without the lock of the interpreter: `(words, stop, listener or None, moves)`.
/// The listener hears each line of a stream as it comes. Ctrl-C, or an exception of the listener, asks for a stop and
/// waits for the end of what moves, and leaves the rest of anything else to itself.
fn verb(py: Python<'_>, given: &Bound<'_, PyTuple>) -> PyResult<Answer> {
    type Given<'py> = (Vec<OsString>, Bound<'py, PyAny>, Bound<'py, PyAny>, bool);
    let (words, capsule, listener, moves): Given<'_> = given.extract()?;
    let (switch, emulated) = opened(&capsule)?;
    let listener = (!listener.is_none()).then_some(listener);
    let (mut output, mut remarks) = (Vec::new(), Vec::new());
    let mut work = match Work::begin(words, &switch) {
        Ok(work) => work,
        Err(failure) => return Ok((output, remarks, Some(parts(failure)))),
    };
    let mut interrupted: Option<PyErr> = None;
    loop {
        let told = match py.detach(|| work.next(LOOK)) {
            Ok(None) => break,
            Err(Nothing) => Ok(()),
            Ok(Some(Heard::Remark(text))) => {
                remarks.push(text);
                Ok(())
            }
            Ok(Some(Heard::Output(text))) => match &listener {
                Some(listener) if interrupted.is_none() => listener.call1((text,)).map(drop),
                Some(_) => Ok(()),
                None => {
                    output.push(text);
                    Ok(())
                }
            },
        };
        if let Err(error) = told.and_then(|()| py.check_signals()) {
            if !moves || interrupted.is_some() {
                return Err(error);
            }
            ask_for_silence(&switch, emulated);
            interrupted = Some(error);
        }
    }
    let ended = py.detach(|| work.end());
    match interrupted {
        Some(error) => Err(error),
        None => Ok((output, remarks, ended.err().map(parts))),
    }
}

fn parts(failure: Failure) -> (String, Option<String>, u8) {
    (failure.error, failure.hint, failure.exit_code)
}

/// A JSON document as TOML, for verbs that read such a file.
fn to_toml(given: &Bound<'_, PyTuple>) -> PyResult<String> {
    let (text,): (String,) = given.extract()?;
    let value: Value = serde_json::from_str(&text).map_err(unusable)?;
    toml::to_string(&in_toml(value)).map_err(unusable)
}

/// A JSON value as TOML; numbers of JSON are texts inside, which TOML would write as such.
fn in_toml(value: Value) -> toml::Value {
    match value {
        Value::Null => toml::Value::String(String::new()),
        Value::Bool(is) => toml::Value::Boolean(is),
        Value::Number(number) => match number.as_i64() {
            Some(whole) => toml::Value::Integer(whole),
            None => toml::Value::Float(number.as_f64().unwrap_or(f64::NAN)),
        },
        Value::String(text) => toml::Value::String(text),
        Value::Array(items) => toml::Value::Array(items.into_iter().map(in_toml).collect()),
        Value::Object(members) => {
            let members = members
                .into_iter()
                .map(|(key, value)| (key, in_toml(value)));
            toml::Value::Table(members.collect())
        }
    }
}

fn unusable(error: impl std::fmt::Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// A function of the module, of its positional arguments.
type Function = fn(&Bound<'_, PyTuple>) -> PyResult<Py<PyAny>>;

/// Functions by their names.
const FUNCTIONS: [(&CStr, Function); 5] = [
    (c"stop", |given| {
        stop(given.py(), given)?.into_py_any(given.py())
    }),
    (c"ask", |given| ask(given)?.into_py_any(given.py())),
    (c"is_confirmed", |given| {
        is_confirmed(given)?.into_py_any(given.py())
    }),
    (c"verb", |given| {
        verb(given.py(), given)?.into_py_any(given.py())
    }),
    (c"toml", |given| to_toml(given)?.into_py_any(given.py())),
];

/// Puts the functions into the module.
fn fill(py: Python<'_>, module: &Bound<'_, PyModule>) -> PyResult<()> {
    for (name, function) in FUNCTIONS {
        let called =
            move |given: &Bound<'_, PyTuple>, _: Option<&Bound<'_, PyDict>>| function(given);
        let callable = PyCFunction::new_closure(py, Some(name), None, called)?;
        module.add(name.to_string_lossy().as_ref(), callable)?;
    }
    Ok(())
}

/// Entry point that the interpreter calls when it imports the module.
#[unsafe(no_mangle)]
#[allow(non_snake_case, reason = "the name is the interpreter's")]
extern "C" fn PyInit__calib() -> *mut ffi::PyObject {
    let definition = Box::new(ffi::PyModuleDef {
        m_base: ffi::PyModuleDef_HEAD_INIT,
        m_name: c"_calib".as_ptr(),
        m_doc: c"Words of the command line in, documents out.".as_ptr(),
        m_size: -1,
        m_methods: std::ptr::null_mut(),
        m_slots: std::ptr::null_mut(),
        m_traverse: None,
        m_clear: None,
        m_free: None,
    });
    Python::attach(|py| {
        // SAFETY: the interpreter is attached, and the definition lives as long as the program.
        let module = unsafe {
            let module = ffi::PyModule_Create(Box::into_raw(definition));
            Bound::from_owned_ptr_or_err(py, module)
        };
        let filled = module.and_then(|module| {
            let module = module.cast_into::<PyModule>()?;
            fill(py, &module)?;
            Ok(module.into_ptr())
        });
        filled.unwrap_or_else(|error| {
            error.restore(py);
            std::ptr::null_mut()
        })
    })
}
