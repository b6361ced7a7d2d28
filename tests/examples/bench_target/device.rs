//! The shipping image at work.

use crate::row::Row;
use calib_host::emulated::{EmulatedTransport, EmulatedUsbTransport};
use calib_link::session;
use calib_link::{Client, RetryPolicy};
use calib_protocol::message::RunSpec;
use calib_protocol::record::RunLabels;
use calib_tests::rigged::{Fault, Rigged};
use calib_twin::plant::Plant;
use calib_twin::rig::Rig;
use calib_twin::runner::{Emulator, Firmware, Mark, Passages};
use std::sync::{Arc, Mutex};
use std::time::Duration;

/// Clock of the core, cycles per second.
const CLOCK_HZ: f64 = 480.0e6;
/// Pairs per second.
const RATE_HZ: f64 = 50_000.0;
/// Bytes per second of 115 200 baud with start and stop bit.
const LINE_BYTES_PER_S: f64 = 11_520.0;
/// Bytes per second of full-speed bulk transfers: 19 packets of 64 bytes in a
/// frame of 1 ms (USB 2.0, table 5-9).
const USB_BYTES_PER_S: f64 = 1.216e6;
/// A flash word of 32 bytes takes 0.1 ms typically (DS12110 Rev 11, table 140).
const WORD_S: f64 = 1.0e-4;
const WORD_BYTES: f64 = 32.0;
/// Watched part of the run: 20 Hz to 31.5 Hz, with the longest folds. Watching
/// slows the emulator down.
const WATCHED: Duration = Duration::from_secs(8);
/// Time between two half buffers.
const BUFFER: Duration = Duration::from_millis(10);

/// Measures everything that needs the whole image.
pub(crate) fn measure() -> Result<Vec<Row>, Fault> {
    let mut rows = vec![boot()?];
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    let idle = cycles_per_pair(&rigged, Duration::from_secs(1))?;
    let (busy, latency) = run(&mut rigged)?;
    let share = |instructions: f64| 100.0 * instructions * RATE_HZ / CLOCK_HZ;
    let milliseconds = |instructions: u64| 1000.0 * instructions as f64 / CLOCK_HZ;
    rows.push(Row::new("whole image at rest", idle, "instr/pair"));
    rows.push(Row::new("whole image, default list", busy, "instr/pair"));
    rows.push(
        Row::new("the same, share of the core", share(busy), "%").limit(15.0, "aim: at most"),
    );
    rows.push(
        Row::new(
            "half buffer to loop update, worst",
            milliseconds(latency.most_instructions),
            "ms",
        )
        .limit(
            BUFFER.as_secs_f64() * 1000.0,
            format!(
                "aim: within the next buffer; {} instructions, {} buffers",
                latency.most_instructions, latency.count
            ),
        ),
    );
    rows.extend(storing(&mut rigged)?);
    rows.extend(download(&mut rigged)?);
    Ok(rows)
}

/// From power to the first answer over the serial line.
fn boot() -> Result<Row, Fault> {
    let firmware = Firmware::shipping()?;
    let rig = Box::new(Plant::new(&Rig::standard()));
    let emulator = Arc::new(Mutex::new(Emulator::power_on(&firmware, rig)?));
    let transport = Box::new(EmulatedTransport::new(emulator.clone()));
    // An answer takes some 10 ms on the line; an unanswered question is repeated.
    let policy = RetryPolicy {
        attempts: 1,
        answer_timeout: Duration::from_millis(20),
        ..RetryPolicy::default()
    };
    let mut client = Client::with_policy(transport, policy);
    while client.info().is_err() {}
    let board = emulator.lock().map_err(|_| "the emulator failed")?;
    let milliseconds = board.elapsed().as_secs_f64() * 1000.0;
    let note = "aim: below; power to first answer over USART3";
    Ok(Row::new("boot to ready", milliseconds, "ms").limit(300.0, note))
}

/// Instructions executed per sample pair over `duration`.
fn cycles_per_pair(rigged: &Rigged, duration: Duration) -> Result<f64, Fault> {
    let mut board = rigged.board();
    let (instructions, pairs) = (board.instructions(), board.sample_pairs());
    board.run_for(duration)?;
    let instructions = board.instructions() - instructions;
    Ok(instructions as f64 / (board.sample_pairs() - pairs) as f64)
}

/// The default list up to its last point: instructions per pair, and the way from
/// a buffer's interrupt to the command it ends in.
fn run(rigged: &mut Rigged) -> Result<(f64, Passages), Fault> {
    let firmware = Firmware::shipping()?;
    // The controller's interrupt for the converters, and what the measuring task
    // counts up once the command for the drive is out.
    let from = Mark::Arrival(firmware.symbol("DMA1_STREAM0")?);
    let to = Mark::Write(firmware.symbol_at_path(&["state", "MEASURE_ALIVE"])?);
    start(rigged)?;
    let (instructions, pairs) = counters(rigged);
    let passages = rigged.board().watch_passages(from, to, WATCHED)?;
    while !is_at_last_point(rigged)? {
        rigged.client.wait(Duration::from_millis(50))?;
    }
    let (instructions_after, pairs_after) = counters(rigged);
    let per_pair = (instructions_after - instructions) as f64 / (pairs_after - pairs) as f64;
    Ok((per_pair, passages))
}

fn counters(rigged: &Rigged) -> (u64, u64) {
    let board = rigged.board();
    (board.instructions(), board.sample_pairs())
}

fn start(rigged: &mut Rigged) -> Result<(), Fault> {
    let points = session::default_points(10.0);
    rigged.client.start(RunSpec {
        points: points.into_iter().collect(),
        excitation: calib_core::point::ExcitationKind::SingleSine,
        labels: RunLabels::default(),
    })?;
    rigged.client.wait(Duration::from_millis(100))?;
    Ok(())
}

fn is_at_last_point(rigged: &mut Rigged) -> Result<bool, Fault> {
    let status = rigged.client.status()?;
    Ok(!status.state.is_exciting() || status.point + 1 == status.points)
}

/// Time the flash is at work for a record of the default list: from its last point
/// until the run has ended.
fn storing(rigged: &mut Rigged) -> Result<Vec<Row>, Fault> {
    let before = rigged.board().flash_watch().operations();
    let mut working = Duration::ZERO;
    loop {
        working += flash_work(rigged)?;
        if !rigged.client.status()?.state.is_running() {
            break;
        }
    }
    let words = rigged.board().flash_watch().operations() - before;
    let bytes = record_bytes(rigged)?;
    let limit = (bytes / WORD_BYTES).ceil() * WORD_S * 1000.0;
    let note = format!("{bytes} bytes take {words} flash words of 32 bytes at 0.1 ms");
    let milliseconds = working.as_secs_f64() * 1000.0;
    Ok(vec![
        Row::new("flash time of a record of 28 points", milliseconds, "ms").limit(limit, note),
    ])
}

/// How long the flash is at work until it has rested for a while.
fn flash_work(rigged: &mut Rigged) -> Result<Duration, Fault> {
    const STEP: Duration = Duration::from_micros(200);
    const REST_STEPS: u32 = 500;
    let mut seen = rigged.board().flash_watch().operations();
    let (mut working, mut rest) = (0, 0);
    while rest < REST_STEPS {
        rigged.client.wait(STEP)?;
        let now = rigged.board().flash_watch().operations();
        (working, rest) = match now > seen {
            true => (working + 1, 0),
            false => (working, rest + 1),
        };
        seen = now;
    }
    Ok(STEP * working)
}

fn record_bytes(rigged: &mut Rigged) -> Result<f64, Fault> {
    let records = rigged.client.records()?;
    let record = records.last().ok_or("nothing was stored")?;
    Ok(f64::from(record.bytes))
}

/// Bytes of records per second over either link.
fn download(rigged: &mut Rigged) -> Result<Vec<Row>, Fault> {
    let id = rigged.client.records()?.last().ok_or("nothing stored")?.id;
    let shared = rigged.shared();
    let (rate, seconds) = fetch(rigged, None, id)?;
    let mut usb = Client::new(Box::new(EmulatedUsbTransport::plug_in(shared)?));
    let (usb_rate, usb_seconds) = fetch(rigged, Some(&mut usb), id)?;
    Ok(vec![
        Row::new("record bytes over USART3", rate, "bytes/s").limit(
            LINE_BYTES_PER_S,
            "115 200 baud 8N1, without frames and requests",
        ),
        Row::new("500 such records over USART3", 500.0 * seconds, "s"),
        Row::new("record bytes over USB", usb_rate, "bytes/s")
            .limit(USB_BYTES_PER_S, "19 bulk packets of 64 bytes in 1 ms"),
        Row::new("500 such records over USB", 500.0 * usb_seconds, "s").limit(5.0, "aim: below"),
    ])
}

/// Downloads record `id` over `client`, or else over the serial line: bytes per
/// second, and seconds.
fn fetch(rigged: &mut Rigged, client: Option<&mut Client>, id: u32) -> Result<(f64, f64), Fault> {
    let start = rigged.board().elapsed();
    let client = client.unwrap_or(&mut rigged.client);
    let (_, bytes) = session::take(client, id)?;
    let seconds = (rigged.board().elapsed() - start).as_secs_f64();
    Ok((bytes.len() as f64 / seconds, seconds))
}
