//! Firmware of the vibration calibrator.
//!
//! Tasks carry, the board wires, `calib-core` computes. Built for the host,
//! the same program prints what a host needs to know about the image.
#![cfg_attr(target_os = "none", no_std)]
#![cfg_attr(target_os = "none", no_main)]

#[cfg(target_os = "none")]
mod board;
#[cfg(target_os = "none")]
mod panic;

#[cfg(target_os = "none")]
#[embassy_executor::main]
async fn main(_spawner: embassy_executor::Spawner) {
    use defmt_rtt as _;
    use grounded::uninit::GroundedArrayCell;
    #[unsafe(link_section = ".axisram")]
    static RX: GroundedArrayCell<u8, 1024> = GroundedArrayCell::uninit();
    #[unsafe(link_section = ".axisram")]
    static TX: GroundedArrayCell<u8, 1024> = GroundedArrayCell::uninit();
    let mut board = board::Board::start();
    let (rx, tx) = unsafe {
        RX.initialize_all_copied(0);
        TX.initialize_all_copied(0);
        let (ptr, len) = RX.get_ptr_len();
        let rx = core::slice::from_raw_parts_mut(ptr, len);
        let (ptr, len) = TX.get_ptr_len();
        (rx, core::slice::from_raw_parts_mut(ptr, len))
    };
    board.lamps.green.set_high();
    defmt::info!("started, {} Hz timers", board::TIMER_HZ);
    let (mut out, input) = board.link.split();
    let mut input = input.into_ring_buffered(rx);
    loop {
        let Ok(n) = input.read(tx).await else {
            continue;
        };
        board.lamps.yellow.toggle();
        let _ = out.write(&tx[..n]).await;
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    println!(
        "calib-firmware {} speaks protocol {}",
        env!("CARGO_PKG_VERSION"),
        calib_protocol::frame::PROTOCOL_VERSION
    );
}
