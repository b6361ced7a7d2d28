//! The links to hosts: bytes in, answers out.

use crate::board::{PACKET_BYTES, Port, PortBuffers, UsbDriver, UsbPort, axi_static, run_usb};
use crate::instrument::Calibrator;
use calib_firmware::link::{Aftermath, Link};
use calib_firmware::scpi::Console;
use embassy_futures::join::join;
use embassy_stm32::mode::Async;
use embassy_stm32::usart::UartTx;
use embassy_time::{Duration, Timer, with_timeout};
use embassy_usb::UsbDevice;
use embassy_usb::class::cdc_acm::Sender;

/// Longest a USB host may leave a packet lying. One that opens the port and
/// never reads loses its answers and holds up nobody.
const HOST_PATIENCE: Duration = Duration::from_secs(1);

/// Silence in the middle of a frame or line after which its sender is gone. At
/// 115 200 baud bytes follow each other within 0.1 ms; a busy computer's driver
/// may pause for some 100 ms.
const SENDER_GONE: Duration = Duration::from_secs(2);

/// Time between two looks at a run whose end a host waits for.
const LOOK: Duration = Duration::from_millis(20);

/// Wait for a byte when nothing else is to be done.
const IDLE: Duration = Duration::from_secs(3600);

/// How long to wait for the next byte.
fn patience(link: &Link, console: &Console) -> Duration {
    match (console.awaits_end(), link.is_receiving()) {
        (true, _) => LOOK,
        (false, true) => SENDER_GONE,
        (false, false) => IDLE,
    }
}

/// Serves USART3, the virtual COM port of the ST-LINK, for ever.
#[embassy_executor::task]
pub(crate) async fn serial_link(port: Port, buffers: PortBuffers, mut instrument: Calibrator) -> ! {
    axi_static!(LINK: Link);
    // Note(unwrap): init; the task is spawned once.
    let link = LINK.take();
    let (mut output, input) = port.split();
    let mut input = input.into_ring_buffered(buffers.receive);
    let mut bytes = [0; 64];
    let mut console = Console::new();
    loop {
        let patience = patience(link, &console);
        let count = match with_timeout(patience, input.read(&mut bytes)).await {
            Ok(Ok(count)) => count,
            // Bytes were lost: what was begun can never be whole.
            Ok(Err(_)) => {
                link.forget(&mut console);
                continue;
            }
            Err(_) => {
                if let Some(answer) = console.poll(&mut instrument) {
                    send(&mut output, buffers.transmit, answer).await;
                } else if patience == SENDER_GONE {
                    link.forget(&mut console);
                }
                continue;
            }
        };
        for byte in bytes.iter().take(count) {
            let pushed = link.push(*byte, &mut console, &mut instrument).await;
            let Some((answer, aftermath)) = pushed else {
                continue;
            };
            send(&mut output, buffers.transmit, answer).await;
            if aftermath == Aftermath::Reset {
                reset().await;
            }
        }
    }
}

/// Sends bytes by way of the memory DMA can read.
async fn send(output: &mut UartTx<'static, Async>, staging: &mut [u8], answer: &[u8]) {
    for part in answer.chunks(staging.len()) {
        let Some(staged) = staging.get_mut(..part.len()) else {
            continue;
        };
        staged.copy_from_slice(part);
        let _ = output.write(staged).await;
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
    let mut console = Console::new();
    loop {
        input.wait_connection().await;
        loop {
            let patience = patience(link, &console);
            let count = match with_timeout(patience, input.read_packet(&mut packet)).await {
                Ok(Ok(count)) => count,
                Ok(Err(_)) => break,
                Err(_) => {
                    if let Some(answer) = console.poll(&mut instrument) {
                        output.send(answer).await;
                    } else if patience == SENDER_GONE {
                        link.forget(&mut console);
                    }
                    continue;
                }
            };
            for byte in packet.iter().take(count) {
                let pushed = link.push(*byte, &mut console, &mut instrument).await;
                let Some((answer, aftermath)) = pushed else {
                    continue;
                };
                output.send(answer).await;
                if aftermath == Aftermath::Reset {
                    reset().await;
                }
            }
        }
        // The cable is out, or the host has switched the device off.
        link.forget(&mut console);
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
