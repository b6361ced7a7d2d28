//! Every sum and number checked again.

use super::Logbook;
use super::records::Content;
use calib_files::Result;

impl Logbook {
    /// Looks at the file, at every record, and at every number made of one.
    /// Returns what is wrong, in words; nothing when all is well.
    ///
    /// # Errors
    /// Those of a file that cannot be read at all.
    pub fn inspect(&self) -> Result<Vec<String>> {
        let mut wrong = self.all("PRAGMA integrity_check", [], |row| row.get::<_, String>(0))?;
        wrong.retain(|line| line != "ok");
        for id in self.all("SELECT id FROM records ORDER BY id", [], |row| row.get(0))? {
            match self.record(id) {
                Err(error) => wrong.push(error.to_string()),
                Ok(bytes) => wrong.extend(self.inspect_record(id, &bytes)?),
            }
        }
        let numbers = "SELECT count(*), coalesce(max(number), 0) FROM certificates";
        let (count, last): (i64, i64) = self
            .connection
            .query_row(numbers, [], |row| Ok((row.get(0)?, row.get(1)?)))
            .map_err(|error| self.failure(error))?;
        if count != last {
            wrong.push(format!("certificates: {count} of {last} are there"));
        }
        Ok(wrong)
    }

    /// Compares the list's line of a record with the record.
    fn inspect_record(&self, id: i64, bytes: &[u8]) -> Result<Vec<String>> {
        let place = format!("record {id}");
        let content = match Content::of(bytes) {
            Ok(content) => content,
            Err(error) => return Ok(vec![format!("{place}: {error}")]),
        };
        let sql = "SELECT instrument, number, unix_time_s, sensor_serial, points,
                   (SELECT count(*) FROM points WHERE record = id) FROM records WHERE id = ?1";
        let listed: (String, u32, i64, String, i64, i64) = self
            .connection
            .query_row(sql, [id], |row| {
                Ok((
                    row.get(0)?,
                    row.get(1)?,
                    row.get(2)?,
                    row.get(3)?,
                    row.get(4)?,
                    row.get(5)?,
                ))
            })
            .map_err(|error| self.failure(error))?;
        let (head, points) = (content.head(), content.points());
        let truth = (
            head.instrument_serial.to_string(),
            head.id,
            i64::try_from(head.labels.unix_time_s).unwrap_or(0),
            head.labels.dut_serial.to_string(),
            points.len() as i64,
            points.len() as i64,
        );
        Ok(match listed == truth {
            true => Vec::new(),
            false => vec![format!(
                "{place}: the list says something else than the record"
            )],
        })
    }
}
