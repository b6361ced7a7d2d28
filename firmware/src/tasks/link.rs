//! The links to hosts: bytes in, answers out.

use crate::board::{
    PACKET_BYTES, Port, PortBuffers, RECEIVE_BYTES, UsbDriver, UsbPort, axi_static, restart,
    run_usb, silence_now,
};
use crate::instrument::Calibrator;
use crate::shared_archive::SharedArchive;
use crate::{retained, state};
use calib_firmware::lease::Lease;
use calib_firmware::link::{Aftermath, Link};
use calib_firmware::restarts::{Reason, Way};
use calib_firmware::scpi::Console;
use core::sync::atomic::Ordering;
use core::task::Poll;
use embassy_futures::join::join;
use embassy_futures::poll_once;
use embassy_stm32::mode::Async;
use embassy_stm32::usart::{RingBufferedUartRx, UartTx};
use embassy_time::{Duration, TimeoutError, Timer, with_timeout};
use embassy_usb::UsbDevice;
use embassy_usb::class::cdc_acm::Sender;

/// Longest a USB host may leave a packet lying. One that opens the port and
/// never reads loses its answers and holds up nobody.
const HOST_PATIENCE: Duration = Duration::from_secs(1);

/// Silence in the middle of a frame or line after which its sender is gone. At
/// 115 200 baud bytes follow each other within 0.1 ms; a busy computer's driver
/// may pause for some 100 ms.
const SENDER_GONE: Duration = Duration::from_secs(2);

/// How long the serial line is not listened to after damage: bounds what a line
/// full of noise costs the processor.
const AFTER_DAMAGE: Duration = Duration::from_millis(2);

/// Time between two looks at a run whose end a host waits for.
const LOOK: Duration = Duration::from_millis(20);

/// How long an answer takes to leave the board.
const ANSWER_OUT: Duration = Duration::from_millis(20);

/// Longest time to store what is being stored: three sectors erased, 2.2 s each at most.
const STORED: Duration = Duration::from_secs(9);

/// Wait for a byte when nothing else is to be done.
const IDLE: Duration = Duration::from_secs(3600);

/// Where a link's answers go.
trait Output {
    /// Sends one answer as a whole, or gives it up.
    async fn send(&mut self, answer: &[u8]);
}

/// A host's bytes and what they do, whichever way they come.
struct Conversation {
    link: &'static mut Link,
    console: Console,
    instrument: Calibrator,
}

impl Conversation {
    fn new(link: &'static mut Link, instrument: Calibrator) -> Self {
        Self {
            link,
            console: Console::new(),
            instrument,
        }
    }

    /// How long to wait for the next byte.
    fn patience(&self) -> Duration {
        match (self.console.awaits_end(), self.link.is_receiving()) {
            (true, _) => LOOK,
            (false, true) => SENDER_GONE,
            (false, false) => IDLE,
        }
    }

    /// Goes on after a wait: `heard` is the number of bytes that came, the end
    /// of the patience, or the reader's error, which is handed back.
    async fn go_on<E>(
        &mut self,
        heard: Result<Result<usize, E>, TimeoutError>,
        bytes: &[u8],
        output: &mut impl Output,
    ) -> Result<(), E> {
        match heard {
            Ok(count) => self.answer(bytes.iter().take(count?), output).await,
            Err(TimeoutError) => self.wait(output).await,
        }
        Ok(())
    }

    /// Carries out what bytes complete.
    async fn answer(&mut self, bytes: impl Iterator<Item = &u8>, output: &mut impl Output) {
        for byte in bytes {
            let pushed = self
                .link
                .push(*byte, &mut self.console, &mut self.instrument)
                .await;
            let Some((answer, aftermath)) = pushed else {
                continue;
            };
            output.send(answer).await;
            state::with_lease(Lease::hear);
            if aftermath == Aftermath::Reset {
                reset(self.instrument.archive).await;
            }
        }
    }

    /// Nothing came: answers what was waited for, or gives up what was begun.
    async fn wait(&mut self, output: &mut impl Output) {
        let waited = self.console.awaits_end();
        let answer = self.link.poll(&mut self.console, &mut self.instrument);
        if let Some(answer) = answer.await {
            output.send(answer).await;
        } else if !waited {
            self.forget();
        }
    }

    /// Forgets what was begun: it can never be whole.
    fn forget(&mut self) {
        self.link.forget(&mut self.console);
    }
}

/// Serves USART3, the virtual COM port of the ST-LINK, for ever.
#[embassy_executor::task]
pub(crate) async fn serial_link(port: Port, buffers: PortBuffers, instrument: Calibrator) -> ! {
    axi_static!(LINK: Link);
    // Note(unwrap): init; the task is spawned once.
    let mut conversation = Conversation::new(LINK.take(), instrument);
    let (output, input) = port.split();
    let mut input = input.into_ring_buffered(buffers.receive);
    let mut output = SerialOutput {
        output,
        staging: buffers.transmit,
    };
    let mut bytes = [0; 64];
    loop {
        let heard = with_timeout(conversation.patience(), input.read(&mut bytes)).await;
        let went_on = conversation.go_on(heard, &bytes, &mut output).await;
        // Bytes were lost.
        if went_on.is_err() {
            conversation.forget();
            until_whole(&mut input, &mut bytes).await;
        }
    }
}

/// Listens again after damage, once bytes arrive whole or not at all.
async fn until_whole(input: &mut RingBufferedUartRx<'static>, bytes: &mut [u8]) {
    loop {
        Timer::after(AFTER_DAMAGE).await;
        if is_restarted(input, bytes) {
            return;
        }
    }
}

/// Starts reception anew and drops what is in the ring; false when that was damaged too.
///
/// An error stops the driver's DMA (embassy-stm32 0.6). It starts at the beginning
/// of the ring again while the driver goes on where it was: what follows there, up
/// to a whole ring of requests answered long ago, would be heard once more.
fn is_restarted(input: &mut RingBufferedUartRx<'static>, bytes: &mut [u8]) -> bool {
    // The first look only takes away the errors of bytes nobody listened to.
    let _ = poll_once(input.read(bytes));
    for _ in 0..=RECEIVE_BYTES.div_ceil(bytes.len()) + 1 {
        match poll_once(input.read(bytes)) {
            Poll::Pending => return true,
            Poll::Ready(Ok(_)) => {}
            Poll::Ready(Err(_)) => return false,
        }
    }
    false
}

/// Answers on their way through USART3.
struct SerialOutput {
    output: UartTx<'static, Async>,
    /// Memory that DMA can read.
    staging: &'static mut [u8],
}

impl Output for SerialOutput {
    async fn send(&mut self, answer: &[u8]) {
        for part in answer.chunks(self.staging.len()) {
            let Some(staged) = self.staging.get_mut(..part.len()) else {
                continue;
            };
            staged.copy_from_slice(part);
            let _ = self.output.write(staged).await;
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
async fn serve_usb(port: UsbPort, instrument: Calibrator) -> ! {
    axi_static!(LINK: Link);
    // Note(unwrap): init; the task is spawned once.
    let mut conversation = Conversation::new(LINK.take(), instrument);
    let (output, mut input) = port.split();
    let mut output = UsbOutput {
        output,
        broken_off: false,
    };
    let mut packet = [0; PACKET_BYTES];
    loop {
        input.wait_connection().await;
        loop {
            let heard = with_timeout(conversation.patience(), input.read_packet(&mut packet)).await;
            let went_on = conversation.go_on(heard, &packet, &mut output).await;
            if went_on.is_err() {
                break;
            }
        }
        // The cable is out, or the host has switched the device off.
        conversation.forget();
        conversation.instrument.leave();
    }
}

/// Answers on their way to a USB host.
struct UsbOutput {
    output: Sender<'static, UsbDriver>,
    /// The last answer did not get through as a whole.
    broken_off: bool,
}

impl Output for UsbOutput {
    /// Gives an answer up when the host does not take it: it can ask again.
    async fn send(&mut self, answer: &[u8]) {
        // A zero ends the part that may have got through.
        let sent = !self.broken_off || self.packet(&[0]).await;
        self.broken_off = !(sent && self.packets(answer).await);
    }
}

impl UsbOutput {
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

/// Resets the board once the answer has left it and the archive is at rest: a record that is being
/// stored is stored first, and no word or sector is torn.
async fn reset(archive: &SharedArchive) -> ! {
    state::RESTARTING.store(true, Ordering::Relaxed);
    silence_now();
    Timer::after(ANSWER_OUT).await;
    // Kept to the end, so that nothing more is begun.
    let _at_rest = with_timeout(STORED, archive.hold()).await;
    retained::leave(Way::Asked, Reason::new());
    restart()
}
