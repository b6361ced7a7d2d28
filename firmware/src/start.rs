//! From reset to running tasks.

use crate::board::{Board, NAME, RecordFlash, axi_static, usb_port};
use crate::identity::Identity;
use crate::instrument::Calibrator;
use crate::state;
use crate::tasks::acquire::Block;
use crate::tasks::store::SharedArchive;
use crate::tasks::{acquire, drive, link, measure, store, supervise, thermometer};
use calib_firmware::archive::{Directory, LastAccess, MAX_ITEM, Memory};
use calib_firmware::session::LinkName;
use calib_protocol::record::Record;
use embassy_executor::{InterruptExecutor, Spawner};
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

/// Brings everything up; returns when all tasks run.
pub(crate) async fn start(spawner: Spawner) {
    static IDENTITY: StaticCell<Identity> = StaticCell::new();
    let identity: &'static Identity = IDENTITY.init(Identity::read());
    let board = Board::start().await;
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

    let archive = open_archive(board.flash).await;
    let instrument = |link| Calibrator {
        link,
        identity,
        archive,
    };
    let (usb_device, usb_port) = usb_port(board.usb, identity.serial.as_str());

    static BLOCKS: ConstStaticCell<[Block; 2]> = ConstStaticCell::new([Block::EMPTY; 2]);
    static CHANNEL: StaticCell<BlockChannel> = StaticCell::new();
    let (sender, receiver) = CHANNEL.init(Channel::new(BLOCKS.take())).split();

    interrupt::UART4.set_priority(Priority::P6);
    interrupt::UART5.set_priority(Priority::P7);
    let converter = CONVERTER.start(interrupt::UART4);
    let metrology = METROLOGY.start(interrupt::UART5);
    // Note(unwrap): init; every task is spawned once.
    converter.spawn(acquire::acquire(board.digitiser, sender).unwrap());
    converter.spawn(drive::drive(board.exciter).unwrap());
    metrology.spawn(measure::measure(receiver).unwrap());
    spawner.spawn(store::store(archive, identity).unwrap());
    spawner.spawn(thermometer::thermometer(board.sensor_converter).unwrap());
    let serial = instrument(LinkName::Serial);
    spawner.spawn(link::serial_link(board.port, board.port_buffers, serial).unwrap());
    let usb = instrument(LinkName::Usb);
    spawner.spawn(link::usb_link(usb_device, usb_port, usb).unwrap());
    spawner.spawn(supervise::supervise(board.lamps, board.button, board.watchdog, serial).unwrap());
    // Last: from here on blocks come and must find their tasks.
    board.sample_clock.start();
}

/// Reads the record area and takes its settings into force.
///
/// # Panics
/// When the flash fails: nothing could be stored, so nothing is measured.
async fn open_archive(flash: RecordFlash) -> &'static SharedArchive {
    axi_static!(DIRECTORY: Directory);
    axi_static!(SCRATCH: [u8; MAX_ITEM]);
    axi_static!(RECORD: Record);
    static LAST_ACCESS: LastAccess = LastAccess::new();
    static ARCHIVE: StaticCell<SharedArchive> = StaticCell::new();
    let memory = Memory {
        directory: DIRECTORY.take(),
        scratch: SCRATCH.take(),
        record: RECORD.take(),
        last_access: &LAST_ACCESS,
    };
    let (archive, settings) = match SharedArchive::open(flash, memory).await {
        Ok(opened) => opened,
        Err(error) => panic!("record area: {error}"),
    };
    defmt::info!("{} records", archive.records());
    if let Some(settings) = settings {
        state::take_settings(settings);
    }
    ARCHIVE.init(archive)
}
