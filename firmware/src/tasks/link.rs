//! The virtual COM port: bytes in, answers out.

use crate::board::{Port, PortBuffers};
use crate::instrument::Calibrator;
use calib_firmware::link::{Aftermath, Link};
use embassy_time::Timer;
use static_cell::ConstStaticCell;

/// Serves USART3 for ever.
#[embassy_executor::task]
pub(crate) async fn link(port: Port, buffers: PortBuffers, mut instrument: Calibrator) -> ! {
    static LINK: ConstStaticCell<Link> = ConstStaticCell::new(Link::new());
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

/// Resets the board once the answer has left it.
async fn reset() -> ! {
    crate::board::silence_now();
    Timer::after_millis(20).await;
    cortex_m::peripheral::SCB::sys_reset()
}
