//! The whole logbook as a partitioned Parquet data set.
//!
//! ```text
//! DIR/points/year=2026/part-0.parquet
//! DIR/records/year=2026/part-0.parquet
//! DIR/certificates/year=2026/part-0.parquet
//! DIR/sensors/part-0.parquet, DIR/instruments/..., DIR/operators/...
//! ```
//!
//! The partition is in the folder's name alone, as Hive, Spark, DuckDB and
//! polars expect it.

use super::Logbook;
use super::table::{Kind, Part, TABLES, Table, Values};
use calib_files::{Error, Result, file};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::FileReader;
use parquet::file::serialized_reader::SerializedFileReader;
use parquet::file::writer::{
    SerializedColumnWriter, SerializedFileWriter, SerializedRowGroupWriter,
};
use parquet::record::RowAccessor;
use parquet::schema::parser::parse_message_type;
use parquet::schema::types::GroupTypeBuilder;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Writes the data set into `folder`, which must not be there or be empty, and
/// returns its files. A folder that is there is whole.
///
/// # Errors
/// [`Error::Input`] when the folder holds something; [`Error::File`].
pub fn export(logbook: &Logbook, folder: &Path) -> Result<Vec<PathBuf>> {
    let holds = std::fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_some());
    if holds {
        return Err(Error::input(
            folder.display().to_string(),
            "is there, and not empty",
            "name a new folder: a data set is written as a whole",
        ));
    }
    let parent = match folder.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    std::fs::create_dir_all(parent).map_err(|error| Error::file("create", parent, error))?;
    let staged = tempfile::tempdir_in(parent).map_err(|e| Error::file("create", parent, e))?;
    let mut files = Vec::new();
    for table in TABLES {
        for part in table.read(logbook)? {
            let below = match part.year {
                Some(year) => format!("{}/year={year}/part-0.parquet", table.name),
                None => format!("{}/part-0.parquet", table.name),
            };
            write(&staged.path().join(&below), table, &part)?;
            files.push(folder.join(below));
        }
    }
    let _ = std::fs::remove_dir(folder);
    file::rename(staged.path(), folder)?;
    readable(folder);
    Ok(files)
}

/// Temporary folders are private; an export is not.
fn readable(folder: &Path) {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let _ = std::fs::set_permissions(folder, std::fs::Permissions::from_mode(0o755));
    }
    #[cfg(not(unix))]
    let _ = folder;
}

pub(super) fn write(path: &Path, table: &Table, part: &Part) -> Result<()> {
    let failed = |error| Error::file("write", path, error);
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(|e| Error::file("create", folder, e))?;
    }
    // What a call that was cut off has left under this name, or somebody put there, is nobody's.
    let _ = std::fs::remove_file(path);
    let file = std::fs::File::create_new(path).map_err(failed)?;
    let content = file.try_clone().map_err(failed)?;
    encode(content, table, part).map_err(|error| failed(std::io::Error::other(error)))?;
    file.sync_all().map_err(failed)
}

/// The texts in a column of a file.
pub(super) fn texts(path: &Path, column: &str) -> Result<Vec<String>> {
    let file = std::fs::File::open(path).map_err(|error| Error::file("read", path, error))?;
    read_texts(file, column).map_err(|error| {
        Error::input(
            path.display().to_string(),
            error.to_string(),
            "the lake is damaged there: put its last copy in place, or remove the file and export once more",
        )
    })
}

fn read_texts(file: std::fs::File, column: &str) -> Result<Vec<String>, ParquetError> {
    let reader = SerializedFileReader::new(file)?;
    let schema = reader.metadata().file_metadata().schema();
    let wanted = schema
        .get_fields()
        .iter()
        .filter(|field| field.name() == column);
    let wanted = GroupTypeBuilder::new(schema.name())
        .with_fields(wanted.cloned().collect())
        .build()?;
    let mut texts = Vec::new();
    for row in reader.get_row_iter(Some(wanted))? {
        texts.push(row?.get_string(0)?.clone());
    }
    Ok(texts)
}

fn encode(file: std::fs::File, table: &Table, part: &Part) -> Result<(), ParquetError> {
    let schema = Arc::new(parse_message_type(&schema(table))?);
    let properties = Arc::new(WriterProperties::builder().build());
    let mut writer = SerializedFileWriter::new(file, schema, properties)?;
    let mut group = writer.next_row_group()?;
    for ((_, kind), values) in table.columns().zip(&part.columns) {
        encode_column(&mut group, kind, values)?;
    }
    group.close()?;
    writer.close().map(drop)
}

fn schema(table: &Table) -> String {
    let column = |(name, kind): (&str, Kind)| {
        let (primitive, logical) = match kind {
            Kind::Text => ("BYTE_ARRAY", " (UTF8)"),
            Kind::Real => ("DOUBLE", ""),
            Kind::Integer => ("INT64", ""),
            Kind::Boolean => ("BOOLEAN", ""),
            Kind::Time => ("INT64", " (TIMESTAMP(MILLIS,true))"),
        };
        format!("OPTIONAL {primitive} {name}{logical};\n")
    };
    let columns: String = table.columns().map(column).collect();
    format!("message {} {{\n{columns}}}", table.name)
}

fn encode_column(
    group: &mut SerializedRowGroupWriter<'_, std::fs::File>,
    kind: Kind,
    values: &Values,
) -> Result<(), ParquetError> {
    let Some(column) = group.next_column()? else {
        return Err(ParquetError::General("a column too many".to_owned()));
    };
    match values {
        Values::Text(all) => put::<ByteArrayType, _>(column, all, |text| {
            ByteArray::from(text.as_bytes().to_vec())
        }),
        Values::Real(all) => put::<DoubleType, _>(column, all, |value| *value),
        Values::Integer(all) if kind == Kind::Boolean => {
            put::<BoolType, _>(column, all, |value| *value != 0)
        }
        Values::Integer(all) => put::<Int64Type, _>(column, all, |value| *value),
    }
}

/// Values that are there, and for every row whether there is one.
fn put<T: DataType, V>(
    mut column: SerializedColumnWriter<'_>,
    all: &[Option<V>],
    convert: impl Fn(&V) -> T::T,
) -> Result<(), ParquetError> {
    let there: Vec<T::T> = all.iter().flatten().map(convert).collect();
    let levels: Vec<i16> = all.iter().map(|value| i16::from(value.is_some())).collect();
    column
        .typed::<T>()
        .write_batch(&there, Some(&levels), None)?;
    column.close()
}
