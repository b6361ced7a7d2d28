//! Exact stepping of a linear network whose inputs are held constant.
//!
//! # Equation
//! With the inputs constant over `T`, `state(t + T) = e^{A T} state(t) + B' input`, where both come
//! from the exponential of `[[A, B], [0, 0]] T`. No step size has to be chosen: the result is exact
//! at the end of the step whatever the network does in between.

use nalgebra::DMatrix;

/// Rows computed together: enough independent sums to hide the latency of an addition.
const TILE_ROWS: usize = 8;

/// The propagation over one fixed duration.
///
/// Rows are taken in tiles, each with only its non-zero columns: a cascade is lower triangular and
/// its two channels do not see each other, so about half of the full matrix is zero.
#[derive(Clone, Debug)]
pub(super) struct Propagator {
    tiles: Vec<Vec<TileColumn>>,
}

#[derive(Clone, Debug)]
struct TileColumn {
    column: usize,
    factors: [f64; TILE_ROWS],
}

impl Propagator {
    /// `matrix` holds A and B side by side; `duration_s` is the step.
    pub(super) fn new(matrix: &DMatrix<f64>, duration_s: f64) -> Self {
        let (states, width) = matrix.shape();
        let exponential = transition(matrix, duration_s);
        let tile = |first_row: usize| {
            let column = |column| TileColumn {
                column,
                factors: std::array::from_fn(|index| {
                    let row = first_row + index;
                    if row < states {
                        exponential[(row, column)]
                    } else {
                        0.0
                    }
                }),
            };
            let nonzero = |part: &TileColumn| part.factors.iter().any(|&factor| factor != 0.0);
            (0..width).map(column).filter(nonzero).collect()
        };
        Self {
            tiles: (0..states).step_by(TILE_ROWS).map(tile).collect(),
        }
    }

    /// Writes the state at the end of the step to `next`, which is padded to whole tiles;
    /// `source` is (state, inputs).
    ///
    /// A sum is the same to the bit however wide the computer's registers are.
    pub(super) fn apply(&self, source: &[f64], next: &mut [f64]) {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has what the function is compiled for.
            return unsafe { self.apply_avx2(source, next) };
        }
        self.apply_tiles(source, next);
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn apply_avx2(&self, source: &[f64], next: &mut [f64]) {
        self.apply_tiles(source, next);
    }

    #[inline(always)]
    fn apply_tiles(&self, source: &[f64], next: &mut [f64]) {
        let (rows, _) = next.as_chunks_mut::<TILE_ROWS>();
        for (rows, tile) in rows.iter_mut().zip(&self.tiles) {
            let mut sums = [0.0; TILE_ROWS];
            for part in tile {
                let value = source[part.column];
                #[expect(clippy::needless_range_loop, reason = "keeps all sums in registers")]
                for row in 0..TILE_ROWS {
                    sums[row] += part.factors[row] * value;
                }
            }
            *rows = sums;
        }
    }
}

/// Matrix that takes (state, inputs) over `duration_s`, the inputs being held; `matrix` as in
/// [`Propagator::new`].
fn transition(matrix: &DMatrix<f64>, duration_s: f64) -> DMatrix<f64> {
    let (states, width) = matrix.shape();
    let mut augmented = DMatrix::zeros(width, width);
    augmented
        .rows_mut(0, states)
        .copy_from(&(matrix * duration_s));
    // Rows of inputs are zero: their exponential is one.
    augmented.exp()
}

/// A linear network in time, its inputs held constant over each step.
#[derive(Clone, Debug)]
pub(super) struct Stepper {
    matrix: DMatrix<f64>,
    tick_ns: u64,
    tick: Propagator,
    /// Propagators over 2^k ns for steps other than a tick, made when first needed.
    binary: Vec<Option<Propagator>>,
    /// (state, inputs)
    source: Vec<f64>,
    /// The state after a step, padded to whole tiles.
    next: Vec<f64>,
    states: usize,
}

/// 2^41 ns is 36 minutes; longer holds repeat it.
const LONGEST_BINARY_STEP: usize = 41;

/// Below this a state is set to zero: 1e-100 of any SI unit is no physics, and denormal numbers
/// make the processor a hundred times slower. Test
/// `a_network_at_rest_never_reaches_denormal_numbers`.
const NEGLIGIBLE: f64 = 1e-100;

impl Stepper {
    /// At rest. `matrix` holds A and B side by side, `states` rows.
    pub(super) fn new(matrix: DMatrix<f64>, tick_ns: u64) -> Self {
        let (states, width) = matrix.shape();
        Self {
            tick: Propagator::new(&matrix, tick_ns as f64 * 1e-9),
            matrix,
            tick_ns,
            binary: vec![None; LONGEST_BINARY_STEP + 1],
            source: vec![0.0; width],
            next: vec![0.0; states.next_multiple_of(TILE_ROWS)],
            states,
        }
    }

    /// Matrix that takes (state, inputs) over `duration_ns`, the inputs being held.
    pub(super) fn transition(&self, duration_ns: u64) -> DMatrix<f64> {
        transition(&self.matrix, duration_ns as f64 * 1e-9)
    }

    /// Sets input number `index` from now on.
    pub(super) fn set_input(&mut self, index: usize, value: f64) {
        self.source[self.states + index] = value;
    }

    /// Sets state number `index` now.
    pub(super) fn set_state(&mut self, index: usize, value: f64) {
        self.source[index] = value;
    }

    /// The states at present.
    pub(super) fn clone_state(&self) -> Vec<f64> {
        self.source[..self.states].to_vec()
    }

    /// Goes back to earlier states; the inputs stay.
    pub(super) fn restore(&mut self, states: &[f64]) {
        self.source[..self.states].copy_from_slice(states);
    }

    /// Goes on from a copy of [`Stepper::source`].
    pub(super) fn go_on(&mut self, source: &[f64]) {
        for (place, value) in self.source.iter_mut().zip(source) {
            *place = *value;
        }
    }

    /// (state, inputs) at present.
    pub(super) fn source(&self) -> &[f64] {
        &self.source
    }

    /// Advances by `duration_ns`. One tick takes the fast path; any other duration is a sum of
    /// powers of two, so its cost is bounded whatever its length.
    pub(super) fn advance(&mut self, duration_ns: u64) {
        if duration_ns == self.tick_ns {
            self.tick.apply(&self.source, &mut self.next);
            self.accept();
            return;
        }
        let longest = 1_u64 << LONGEST_BINARY_STEP;
        for _ in 0..duration_ns / longest {
            self.advance_binary(LONGEST_BINARY_STEP);
        }
        for exponent in 0..LONGEST_BINARY_STEP {
            if duration_ns >> exponent & 1 == 1 {
                self.advance_binary(exponent);
            }
        }
    }

    fn advance_binary(&mut self, exponent: usize) {
        let matrix = &self.matrix;
        let propagator = self.binary[exponent]
            .get_or_insert_with(|| Propagator::new(matrix, (1_u64 << exponent) as f64 * 1e-9));
        propagator.apply(&self.source, &mut self.next);
        self.accept();
    }

    fn accept(&mut self) {
        let states = &mut self.source[..self.states];
        for (state, &value) in states.iter_mut().zip(&self.next) {
            *state = if value.abs() < NEGLIGIBLE { 0.0 } else { value };
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::DVector;

    use super::super::network::{MovingCoil, Network};
    use super::*;
    use crate::rig::Rig;

    /// The state at which the network stays for ever with its inputs at `inputs`.
    fn equilibrium(matrix: &DMatrix<f64>, inputs: &[f64]) -> Option<DVector<f64>> {
        let states = matrix.nrows();
        let drive = matrix.columns(states, inputs.len()) * DVector::from_column_slice(inputs);
        matrix.columns(0, states).into_owned().lu().solve(&-drive)
    }

    fn coil() -> Network {
        let mut network = Network::default();
        let voltage = network.input();
        let force = network.input();
        let coil = MovingCoil::of(&Rig::standard().exciter.model(), 0.0);
        network.moving_coil(&voltage, &force, &coil);
        network
    }

    #[test]
    fn any_split_of_a_hold_gives_the_same_state() {
        let matrix = coil().matrix();
        let mut whole = Stepper::new(matrix.clone(), 20_000);
        let mut parts = whole.clone();
        for stepper in [&mut whole, &mut parts] {
            stepper.set_input(0, 3.0);
            stepper.set_input(1, -0.4);
        }
        whole.advance(20_000);
        for part_ns in [1, 7_777, 12_000, 222] {
            parts.advance(part_ns);
        }
        // The exponential is exact, so only rounding remains: 1e-15 times a norm of about 4.
        for (a, b) in whole.source().iter().zip(parts.source()) {
            assert!((a - b).abs() < 1e-13 * a.abs().max(1e-2), "{a} {b}");
        }
    }

    #[test]
    fn a_long_hold_ends_at_the_static_deflection() {
        let matrix = coil().matrix();
        let rest = equilibrium(&matrix, &[3.0, -0.4]).expect("stable");
        let mut stepper = Stepper::new(matrix, 20_000);
        stepper.set_input(0, 3.0);
        stepper.set_input(1, -0.4);
        stepper.advance(10_000_000_000);
        for (a, b) in stepper.source().iter().zip(rest.iter()) {
            assert!((a - b).abs() < 1e-9 * b.abs().max(1e-3), "{a} {b}");
        }
        // k x = Bl u / R + F, with the travel stated in units of 1 mm.
        let travel_m = stepper.source()[2] * 1e-3;
        assert!((travel_m - (7.0 * 3.0 / 4.0 - 0.4) / 8000.0).abs() < 1e-12);
    }

    #[test]
    fn a_network_at_rest_never_reaches_denormal_numbers() {
        let mut stepper = Stepper::new(coil().matrix(), 20_000);
        stepper.set_input(0, 1.0);
        stepper.advance(20_000);
        stepper.set_input(0, 0.0);
        // 3 s: e^-330 or 1e-143 with the slowest time constant, 9 ms.
        for _ in 0..150_000 {
            stepper.advance(20_000);
        }
        // A state may stay where its rate is negligible, a hundred times above.
        let settled = |value: &f64| *value == 0.0 || (1e-100..1e-97).contains(&value.abs());
        assert!(
            stepper.source().iter().all(settled),
            "{:?}",
            stepper.source()
        );
    }
}
