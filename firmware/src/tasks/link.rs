//! The links to hosts: bytes in, answers out.

use crate::board::{PACKET_BYTES, Port, PortBuffers, UsbDriver, UsbPort, axi_static, run_usb};
use crate::instrument::Calibrator;
use calib_firmware::link::{Aftermath, Link};
use embassy_futures::join::join;
use embassy_time::{Duration, Timer, with_timeout};
use embassy_usb::UsbDevice;
use embassy_usb::class::cdc_acm::Sender;

/// Longest a USB host may leave a packet lying. One that opens the port and
/// never reads loses its answers and holds up nobody.
const HOST_PATIENCE: Duration = Duration::from_secs(1);

/// Serves USART3, the virtual COM port of the ST-LINK, for ever.
#[embassy_executor::task]
pub(crate) async fn serial_link(port: Port, buffers: PortBuffers, mut instrument: Calibrator) -> ! {
    axi_static!(LINK: Link);
    // Note(unwrap): init; the task is spawned once.
    let link = LINK.take();
    let (mut output, input) = port.split();
    let mut input = input.into_ring_buffered(buffers.receive);
    let mut bytes = [0; 64];
    loop {
        let Ok(count) = input.read(&mut bytes).await else {
            // Bytes were lost: what was begun can never be whole.
            link.forget();
            continue;
        };
        for byte in bytes.iter().take(count) {
            let Some((answer, aftermath)) = link.push(*byte, &mut instrument).await else {
                continue;
            };
            for part in answer.chunks(buffers.transmit.len()) {
                let Some(staged) = buffers.transmit.get_mut(..part.len()) else {
                    continue;
                };
                staged.copy_from_slice(part);
                let _ = output.write(staged).await;
            }
            if aftermath == Aftermath::Reset {
                reset().await;
            }
        }
    }
}

/// Serves the USB port for ever, whether a host is there or not.
#[embassy_executor::task]
pub(crate) async fn usb_link(
    mut device: UsbDevice<'static, UsbDriver>,
    port: UsbPort,
    instrument: Calibrator,
) {
    // The device first: it switches on the clock of the registers both use.
    join(run_usb(&mut device), serve_usb(port, instrument)).await;
}

/// Serves hosts one after another.
async fn serve_usb(port: UsbPort, mut instrument: Calibrator) -> ! {
    axi_static!(LINK: Link);
    // Note(unwrap): init; the task is spawned once.
    let link = LINK.take();
    let (output, mut input) = port.split();
    let mut output = UsbOutput {
        output,
        broken_off: false,
    };
    let mut packet = [0; PACKET_BYTES];
    loop {
        input.wait_connection().await;
        while let Ok(count) = input.read_packet(&mut packet).await {
            for byte in packet.iter().take(count) {
                let Some((answer, aftermath)) = link.push(*byte, &mut instrument).await else {
                    continue;
                };
                output.send(answer).await;
                if aftermath == Aftermath::Reset {
                    reset().await;
                }
            }
        }
        // The cable is out, or the host has switched the device off.
        link.forget();
        instrument.leave();
    }
}

/// Answers on their way to a USB host.
struct UsbOutput {
    output: Sender<'static, UsbDriver>,
    /// The last answer did not get through as a whole.
    broken_off: bool,
}

impl UsbOutput {
    /// Sends an answer, or gives it up when the host does not take it: it can
    /// ask again.
    async fn send(&mut self, answer: &[u8]) {
        // A zero ends the part that may have got through.
        let sent = !self.broken_off || self.packet(&[0]).await;
        self.broken_off = !(sent && self.packets(answer).await);
    }

    async fn packets(&mut self, answer: &[u8]) -> bool {
        for packet in answer.chunks(PACKET_BYTES) {
            if !self.packet(packet).await {
                return false;
            }
        }
        // A transfer ends with a short packet (USB 2.0, 5.8.3).
        !answer.len().is_multiple_of(PACKET_BYTES) || self.packet(&[]).await
    }

    async fn packet(&mut self, packet: &[u8]) -> bool {
        let written = with_timeout(HOST_PATIENCE, self.output.write_packet(packet)).await;
        matches!(written, Ok(Ok(())))
    }
}

/// Resets the board once the answer has left it.
async fn reset() -> ! {
    crate::board::silence_now();
    Timer::after_millis(20).await;
    cortex_m::peripheral::SCB::sys_reset()
}
