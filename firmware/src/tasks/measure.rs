//! Blocks in, drive commands and results out: the core decides everything.

use crate::board::{APERTURE, BLOCK_PAIRS, CONVERTERS, SAMPLE_RATE_HZ, axi_static, block_end};
use crate::state::{self, Order};
use crate::tasks::acquire::Block;
use crate::tasks::drive::{COMMAND, DriveOrder, LATE, SILENCE, WAY_PAIRS};
use crate::timing;
use calib_core::broadband::SpectraMemory;
use calib_core::closing::Closing;
use calib_core::correlation::FoldMemory;
use calib_core::output::Command;
use calib_core::point::{ExcitationKind, PointResult, PointSpec};
use calib_core::point_state::{PointState, Reason};
use calib_core::sequence::{Activity, Sampling, Sequencer, Survey, SurveyRequest};
use calib_protocol::health::Work;
use calib_protocol::message::RunState;
use calib_protocol::stored_point::as_stored;
use core::sync::atomic::Ordering;
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::zerocopy_channel::Receiver;

/// Pairs by which the converters follow each other.
const CONVERTERS_APART: u32 = 2;

/// At most the ring of the drive is queued, and a block for which it has no room yet; [`Runner::mind_the_way`] says
/// what is.
const SAMPLING: Sampling = Sampling {
    input: CONVERTERS.input,
    sample_rate_hz: SAMPLE_RATE_HZ as f32,
    aperture: APERTURE,
    latency_samples: 3 * BLOCK_PAIRS as u32 + CONVERTERS_APART,
    rest_samples: BLOCK_PAIRS as u32,
};

/// Works on every block.
#[embassy_executor::task]
pub(crate) async fn measure(mut blocks: Receiver<'static, CriticalSectionRawMutex, Block>) -> ! {
    axi_static!(FOLD: FoldMemory);
    axi_static!(SPECTRA: SpectraMemory);
    let fold = FOLD.take();
    let settings = state::settings();
    let mut runner = Runner {
        full_scale_peak_v: settings.drive_full_scale_peak_v,
        survey: Survey::new(SPECTRA.take(), SAMPLING, settings.clone()),
        sequencer: Sequencer::new(fold, SAMPLING, settings),
        broadband: false,
        running: None,
        closes: false,
        stopping: None,
    };
    loop {
        let block = blocks.receive().await;
        timing::begin(Work::MeasureTask);
        let result = runner.take(block);
        blocks.receive_done();
        runner.go_on(result);
        timing::end(Work::MeasureTask);
        state::MEASURE_ALIVE.fetch_add(1, Ordering::Relaxed);
    }
}

/// Walks the sequencer, or a survey, through the points of a run.
struct Runner {
    sequencer: Sequencer<'static>,
    survey: Survey<'static>,
    /// The run is a survey.
    broadband: bool,
    full_scale_peak_v: f32,
    /// Index of the point in work.
    running: Option<usize>,
    /// The point in work is the first valid one again, behind the last.
    closes: bool,
    stopping: Option<Reason>,
}

impl Runner {
    /// Obeys what was ordered, and works on a block.
    fn take(&mut self, block: &Block) -> Option<PointResult> {
        let starts = self.obey_up_to_a_start();
        if block.gap {
            self.interrupt(Reason::Overrun);
        }
        self.mind_the_way();
        state::EVALUATING.store(true, Ordering::Relaxed);
        let result = timing::timed(Work::Evaluate, || self.feed(&block.pairs));
        state::EVALUATING.store(false, Ordering::Relaxed);
        if starts {
            self.obey(Order::Start);
            self.obey_up_to_a_start();
        }
        result
    }

    /// Whether a run is to start: behind the block at hand, which no command reaches.
    fn obey_up_to_a_start(&mut self) -> bool {
        while let Ok(order) = state::ORDERS.try_receive() {
            match order {
                Order::Start => return true,
                Order::Stop(_) => self.obey(order),
            }
        }
        false
    }

    /// Both rings begin together, and then a block is queued when a command comes; they do not behind a loss of
    /// samples or a self-test. The way was the same with the block before, unless a command was late.
    fn mind_the_way(&mut self) {
        let way = WAY_PAIRS.load(Ordering::Relaxed);
        let block = BLOCK_PAIRS as u32;
        // One that seems shorter is of an order that came when the next block was complete.
        let latency = way.clamp(block, 3 * block) + CONVERTERS_APART;
        self.sequencer.set_latency(latency, way.min(block));
        if LATE.swap(false, Ordering::Relaxed) {
            self.sequencer.postpone(block);
        }
    }

    /// Tells what follows from the block.
    fn go_on(&mut self, result: Option<PointResult>) {
        if let Some(result) = result {
            self.finish_point(result);
        }
        self.command_drive();
        self.show();
    }

    /// Tells the drive what the core wants; a mute also stops what is queued.
    fn command_drive(&mut self) {
        let command = self.command();
        let plays = command != Command::Mute;
        // Never false while a tone is on its way to the drive.
        let played = state::PLAYS.fetch_or(plays, Ordering::Relaxed);
        if played && !plays {
            SILENCE.signal(());
        }
        let order = DriveOrder {
            command,
            block_end: block_end(),
            full_scale_peak_v: self.full_scale_peak_v,
        };
        COMMAND.signal(order);
        state::PLAYS.store(plays, Ordering::Relaxed);
    }

    fn obey(&mut self, order: Order) {
        match (order, self.running) {
            (Order::Start, None) => self.start_run(),
            (Order::Stop(reason), Some(_)) => {
                self.stopping = Some(reason);
                self.interrupt(reason);
            }
            (Order::Start, Some(_)) | (Order::Stop(_), None) => {}
        }
    }

    fn start_run(&mut self) {
        let settings = state::settings();
        defmt::info!("run begins");
        crate::fault::let_through();
        self.full_scale_peak_v = settings.drive_full_scale_peak_v;
        (self.stopping, self.closes) = (None, false);
        match survey_request() {
            Some(request) => {
                self.broadband = true;
                self.sequencer.forget_hum();
                self.survey.start(settings, request);
            }
            None => {
                self.broadband = false;
                let kind = state::RUN.lock(|run| run.borrow().spec.excitation);
                self.sequencer
                    .start_run(settings, kind == ExcitationKind::HeldSine);
            }
        }
        self.start_point(0);
    }

    /// Ends what is in work with this reason.
    fn interrupt(&mut self, reason: Reason) {
        match self.broadband {
            true => self.survey.interrupt(reason),
            false => self.sequencer.interrupt(reason),
        }
    }

    /// Hands pairs on. A survey that is over gives one result with every block.
    fn feed(&mut self, pairs: &[u32]) -> Option<PointResult> {
        if !self.broadband {
            return self.sequencer.feed(pairs);
        }
        let over = self.survey.feed(pairs);
        let spec = self.running.and_then(point)?;
        over.then(|| self.survey.result(spec))
    }

    fn command(&self) -> Command {
        match self.broadband {
            true => self.survey.command(),
            false => self.sequencer.command(),
        }
    }

    /// Begins point `index`; behind the last, the first valid one again; or ends the run.
    fn start_point(&mut self, index: usize) {
        match (point(index), repeatable(), self.stopping) {
            (Some(spec), _, None) => self.begin(index, spec),
            (None, Some(first), None) => {
                self.closes = true;
                self.begin(index, first.spec);
            }
            (None, Some(_), Some(reason)) => {
                state::RUN.lock(|run| run.borrow_mut().closing = Closing::Refused(reason));
                self.end_run(true);
            }
            (next, ..) => self.end_run(next.is_none()),
        }
    }

    fn begin(&mut self, index: usize, spec: PointSpec) {
        self.running = Some(index);
        if !self.broadband {
            self.sequencer.start_point(spec);
        }
        state::update_status(|status| {
            status.point = index as u16;
            status.frequency_hz = spec.frequency_hz;
            status.target_rms_ms2 = spec.acceleration_rms_ms2;
        });
    }

    fn finish_point(&mut self, mut result: PointResult) {
        result.instrument_temperature_c = state::TEMPERATURE_C.get();
        defmt::info!(
            "{} Hz: {}, {} V/(m/s2) at {} m/s2",
            result.spec.frequency_hz,
            result.state,
            result.sensitivity_v_per_ms2,
            result.acceleration_rms_ms2
        );
        let Some(index) = self.running else { return };
        if self.closes {
            return self.close(&result);
        }
        if let PointState::Refused(reason) = result.state {
            self.stopping = self.stopping.or(reason.ends_run().then_some(reason));
        }
        // The same numbers now as in the record later.
        let result = as_stored(&result);
        state::RUN.lock(|run| {
            // As many results fit as points were asked for.
            let _ = run.borrow_mut().results.push(result);
        });
        self.start_point(index + 1);
    }

    /// Every point was measured: notes how the first came out again.
    fn close(&mut self, again: &PointResult) {
        if let Some(first) = repeatable() {
            let closing = Closing::new(&first, again);
            state::RUN.lock(|run| run.borrow_mut().closing = closing);
        }
        self.end_run(true);
    }

    fn end_run(&mut self, complete: bool) {
        defmt::info!("run ends");
        self.running = None;
        state::RUN.lock(|run| run.borrow_mut().complete = complete);
        state::update_status(|status| {
            status.state = RunState::Storing;
            status.frequency_hz = 0.0;
            status.target_rms_ms2 = 0.0;
        });
        state::RUN_ENDED.signal(());
    }

    /// Puts the progress where links and lamps see it.
    fn show(&self) {
        if self.running.is_none() {
            return state::update_status(|status| status.drive_peak_v = 0.0);
        }
        let progress = match self.broadband {
            true => self.survey.progress(),
            false => self.sequencer.progress(),
        };
        state::update_status(|status| {
            status.state = match progress.activity {
                Activity::Idle | Activity::Settling => RunState::Settling,
                Activity::Measuring | Activity::Silencing => RunState::Measuring,
            };
            status.acceleration_rms_ms2 = progress.acceleration_rms_ms2;
            status.drive_peak_v = progress.drive_peak_v;
            status.block = progress.block;
            status.blocks = progress.blocks;
        });
    }
}

/// The point to be repeated behind the last: the first valid one of several, tone after tone.
fn repeatable() -> Option<PointResult> {
    state::RUN.lock(|run| {
        let run = run.borrow();
        let several =
            run.spec.points.len() > 1 && run.spec.excitation == ExcitationKind::SingleSine;
        let mut results = run.results.iter().filter(|_| several);
        results
            .find(|result| result.state == PointState::Valid)
            .copied()
    })
}

/// Request for a broadband run; none for single sines.
fn survey_request() -> Option<SurveyRequest> {
    state::RUN.lock(|run| {
        let run = run.borrow();
        let points = &run.spec.points;
        let first = points.first()?;
        let band = |(low, high): (f32, f32), point: &PointSpec| {
            (low.min(point.frequency_hz), high.max(point.frequency_hz))
        };
        run.spec.excitation.is_broadband().then(|| SurveyRequest {
            band_hz: points.iter().fold((f32::INFINITY, 0.0), band),
            acceleration_rms_ms2: first.acceleration_rms_ms2,
            kind: run.spec.excitation,
        })
    })
}

fn point(index: usize) -> Option<PointSpec> {
    state::RUN.lock(|run| run.borrow().spec.points.get(index).copied())
}
