//! The part's own USB connector: a serial port (CDC-ACM) at full speed.

use super::selected::Irqs;
use super::wiring::UsbParts;
use embassy_futures::select::select;
use embassy_stm32::pac;
use embassy_stm32::peripherals::USB_OTG_FS;
use embassy_stm32::usb::{Config as OtgConfig, Driver};
use embassy_time::{Duration, Timer};
use embassy_usb::class::cdc_acm::{CdcAcmClass, State};
use embassy_usb::{Builder, Config, UsbDevice};
use static_cell::{ConstStaticCell, StaticCell};

/// Bytes of a bulk packet, the most at full speed (USB 2.0, 5.8.3).
pub(crate) const PACKET_BYTES: usize = 64;

/// Vendor and product number: those pid.codes sets aside for what has none of
/// its own. Who sells instruments needs a number of their own.
const VENDOR: u16 = 0x1209;
const PRODUCT: u16 = 0x0001;
const MAKER_NAME: &str = "calib";
const PRODUCT_NAME: &str = "Field vibration calibrator";

/// The driver of OTG FS.
pub(crate) type UsbDriver = Driver<'static, USB_OTG_FS>;
/// The serial port.
pub(crate) type UsbPort = CdcAcmClass<'static, UsbDriver>;

/// Makes the device with its serial port; nothing shows on the bus before the
/// device runs.
pub(crate) fn usb_port(
    parts: UsbParts,
    serial: &'static str,
) -> (UsbDevice<'static, UsbDriver>, UsbPort) {
    // Packets of endpoint 0 and of the bulk endpoint wait here.
    static OUT: ConstStaticCell<[u8; 2 * PACKET_BYTES]> =
        ConstStaticCell::new([0; 2 * PACKET_BYTES]);
    static CONFIGURATION: ConstStaticCell<[u8; 128]> = ConstStaticCell::new([0; 128]);
    static CONTROL: ConstStaticCell<[u8; PACKET_BYTES]> = ConstStaticCell::new([0; PACKET_BYTES]);
    static STATE: StaticCell<State<'static>> = StaticCell::new();
    let mut otg = OtgConfig::default();
    // The board has its power from elsewhere (USB 2.0, 7.1.5): no pull-up
    // without a host.
    otg.vbus_detection = true;
    let UsbParts {
        otg: peripheral,
        d_plus,
        d_minus,
        _vbus,
    } = parts;
    let driver = Driver::new_fs(peripheral, Irqs, d_plus, d_minus, OUT.take(), otg);
    let mut builder = Builder::new(
        driver,
        identity(serial),
        CONFIGURATION.take(),
        &mut [],
        &mut [],
        CONTROL.take(),
    );
    let port = CdcAcmClass::new(&mut builder, STATE.init(State::new()), PACKET_BYTES as u16);
    (builder.build(), port)
}

/// How often a waiting event of the bus is looked for.
const LOOK: Duration = Duration::from_millis(10);

/// Runs the device for ever, and begins anew when it overhears the bus.
///
/// A control transfer waits for the host to go on with it, and the driver hears
/// nothing else meanwhile (embassy-usb 0.6): when the cable is pulled there, it
/// would wait for ever, and the next host in vain.
pub(crate) async fn run(device: &mut UsbDevice<'static, UsbDriver>) -> ! {
    loop {
        // The device keeps its state, so a new run takes the event.
        select(device.run(), event_waits()).await;
        defmt::debug!("USB: a control transfer was broken off");
    }
}

/// Ends when an event of the bus has not been taken between two looks.
async fn event_waits() {
    let mut waited = false;
    loop {
        Timer::after(LOOK).await;
        let flags = pac::USB_OTG_FS.gintsts().read();
        let waits = flags.usbrst() || flags.enumdne() || flags.otgint() || flags.srqint();
        if waits && waited {
            return;
        }
        waited = waits;
    }
}

/// Numbers of frames at full speed: 11 bits (USB 2.0, 8.4.3).
pub(crate) const FRAME_NUMBERS: u32 = 2048;

/// Number of the frame on the bus (RM0433 Rev 8, 57.14, `FNSOF` of OTG_DSTS).
pub(crate) fn frame_number() -> u32 {
    u32::from(pac::USB_OTG_FS.dsts().read().fnsof()) % FRAME_NUMBERS
}

/// Whether a host has given the device an address, and keeps the bus awake.
pub(crate) fn is_addressed() -> bool {
    let awake = !pac::USB_OTG_FS.dsts().read().suspsts();
    awake && pac::USB_OTG_FS.dcfg().read().dad() != 0
}

/// Who the device says it is.
fn identity(serial: &'static str) -> Config<'static> {
    let mut config = Config::new(VENDOR, PRODUCT);
    config.manufacturer = Some(MAKER_NAME);
    config.product = Some(PRODUCT_NAME);
    config.serial_number = Some(serial);
    config.self_powered = true;
    config.max_power = 0;
    config
}
