//! From reset to running tasks.

use crate::board::{Board, Digitiser, Exciter, NAME, option_bytes, usb_port};
use crate::identity::Identity;
use crate::instrument::Calibrator;
use crate::shared_archive::SharedArchive;
use crate::state;
use crate::tasks::acquire::Block;
use crate::tasks::{acquire, drive, link, measure, store, supervise, thermometer, timebase};
use crate::timing::turns_of;
use calib_core::self_test::BROWN_OUT_LEVEL;
use calib_firmware::restarts::LeftOut;
use calib_firmware::session::LinkName;
use calib_protocol::health::{Defect, Work};
use core::sync::atomic::Ordering;
use embassy_executor::{InterruptExecutor, SendSpawner, Spawner};
use embassy_stm32::interrupt::{self, InterruptExt, Priority};
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::zerocopy_channel::Channel;
use static_cell::{ConstStaticCell, StaticCell};

/// Acquire and drive: above everything but the DMA.
static CONVERTER: InterruptExecutor = InterruptExecutor::new();
/// Measure: below the converters, above the thread.
static METROLOGY: InterruptExecutor = InterruptExecutor::new();

// Two interrupts of peripherals that are not used lend their vectors.
#[embassy_stm32::interrupt]
unsafe fn UART4() {
    // Note(unsafe): called from the interrupt the executor was started with.
    unsafe { CONVERTER.on_interrupt() }
}

#[embassy_stm32::interrupt]
unsafe fn UART5() {
    // Note(unsafe): as above.
    unsafe { METROLOGY.on_interrupt() }
}

type BlockChannel = Channel<'static, CriticalSectionRawMutex, Block>;

/// Brings everything up that can be; returns when all tasks run.
///
/// A part that does not answer is noted and left out: links, lamps and button come up
/// in any case.
pub(crate) async fn start(spawner: Spawner) {
    crate::fault::enable();
    static IDENTITY: StaticCell<Identity> = StaticCell::new();
    let identity: &'static Identity = IDENTITY.init(Identity::read());
    let left_out = identity.left_out;
    state::note_defect(Defect::Restarts, !left_out.is_nothing());
    let board = Board::start(left_out).await;
    state::note_defect(Defect::Clock, !board.clocked);
    defmt::info!(
        "calib-firmware {=str} {=str} for {=str}, serial {=str}",
        identity.version.as_str(),
        identity.git_hash.as_str(),
        NAME,
        identity.serial.as_str()
    );
    if let Some(reason) = &identity.last_panic {
        defmt::error!("restarted after: {=str}", reason.as_str());
    }

    let level = option_bytes().brown_out_level();
    if level != BROWN_OUT_LEVEL {
        defmt::warn!(
            "brown-out level {=u8} and not {=u8}",
            level,
            BROWN_OUT_LEVEL
        );
    }

    static ARCHIVE: StaticCell<SharedArchive> = StaticCell::new();
    let archive: &'static SharedArchive = ARCHIVE.init(SharedArchive::new(board.random));
    let instrument = |link| Calibrator {
        link,
        identity,
        archive,
    };
    // Note(unwrap): init; every task is spawned once.
    let serial = instrument(LinkName::Serial);
    spawner.spawn(turns_of(
        Work::SerialTask,
        link::serial_link(board.port, board.port_buffers, serial).unwrap(),
    ));
    if !left_out.has(LeftOut::USB) {
        let (device, port) = usb_port(board.usb, identity.serial.as_str());
        let usb = instrument(LinkName::Usb);
        spawner.spawn(turns_of(
            Work::UsbTask,
            link::usb_link(device, port, usb).unwrap(),
        ));
        spawner.spawn(turns_of(Work::TimebaseTask, timebase::timebase().unwrap()));
    }
    spawner.spawn(turns_of(
        Work::SuperviseTask,
        supervise::supervise(board.lamps, board.button, board.watchdog, serial).unwrap(),
    ));
    spawner.spawn(turns_of(
        Work::StoreTask,
        store::store(archive, board.flash, identity).unwrap(),
    ));
    if !left_out.has(LeftOut::CONVERTERS) {
        spawner.spawn(turns_of(
            Work::SensorTask,
            thermometer::thermometer(board.sensor_converter).unwrap(),
        ));
    }
    match board.digitiser {
        Some(digitiser) => {
            measure(digitiser, board.exciter);
            // Last: from here on blocks come and must find their tasks.
            board.sample_clock.start();
        }
        // The exciter rests: its converter was enabled at mid-scale, and nothing triggers it.
        None => state::note_defect(Defect::Converters, true),
    }
}

/// Starts what measures.
fn measure(digitiser: Digitiser, exciter: Exciter) {
    static BLOCKS: ConstStaticCell<[Block; 2]> = ConstStaticCell::new([Block::EMPTY; 2]);
    static CHANNEL: StaticCell<BlockChannel> = StaticCell::new();
    let (sender, receiver) = CHANNEL.init(Channel::new(BLOCKS.take())).split();

    interrupt::UART4.set_priority(Priority::P6);
    interrupt::UART5.set_priority(Priority::P7);
    let converter: SendSpawner = CONVERTER.start(interrupt::UART4);
    let metrology: SendSpawner = METROLOGY.start(interrupt::UART5);
    // Note(unwrap): init; every task is spawned once.
    converter.spawn(turns_of(
        Work::AcquireTask,
        acquire::acquire(digitiser, sender).unwrap(),
    ));
    converter.spawn(turns_of(Work::DriveTask, drive::drive(exciter).unwrap()));
    metrology.spawn(measure::measure(receiver).unwrap());
    state::MEASURES.store(true, Ordering::Relaxed);
}
