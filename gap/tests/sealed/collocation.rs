//! Periodic motion of the nonlinear exciter by collocation in time.

use num_complex::Complex64 as C;
use std::f64::consts::{PI, TAU};

pub(crate) const N: usize = 96;
/// Harmonics kept (below the Nyquist order of the grid).
pub(crate) const H: usize = 30;

#[derive(Clone, Copy)]
pub(crate) struct Coil {
    pub(crate) mass: f64,
    pub(crate) k1: f64,
    pub(crate) c: f64,
    pub(crate) bl: f64,
    pub(crate) emf: f64,
    pub(crate) r: f64,
    pub(crate) l: f64,
    pub(crate) exponent: f64,
    pub(crate) k2: f64,
    pub(crate) k3: f64,
    pub(crate) b2: f64,
    pub(crate) friction: f64,
    pub(crate) gravity: f64,
    pub(crate) clip: Option<f64>,
    pub(crate) even: f64,
}

pub(crate) struct Solved {
    /// Coil voltage, current and acceleration: complex amplitudes of orders 0..=H.
    pub(crate) v: Vec<C>,
    pub(crate) i: Vec<C>,
    pub(crate) a: Vec<C>,
    pub(crate) ok: bool,
}

impl Coil {
    pub(crate) fn z(&self, w: f64) -> C {
        let w0 = TAU * 1000.0;
        let n = self.exponent;
        C::from(self.r) + C::from_polar(w0 * self.l * (w / w0).powf(n), n * PI / 2.0)
    }
    pub(crate) fn linear(&self) -> bool {
        self.k2 == 0.0
            && self.k3 == 0.0
            && self.b2 == 0.0
            && self.friction == 0.0
            && self.clip.is_none()
            && self.even == 0.0
    }

    /// Linear response at level a (peak).
    pub(crate) fn sine(&self, w: f64, a: f64) -> Solved {
        let s = C::new(0.0, w);
        let x = C::from(a) / (s * s);
        let force = x * (self.mass * s * s + self.c * s + self.k1);
        let i = force / self.bl;
        let v = i * self.z(w) + x * s * self.bl * self.emf;
        let pad = |c: C| {
            let mut l = vec![C::ZERO; H + 1];
            l[1] = c;
            l
        };
        Solved {
            v: pad(v),
            i: pad(i),
            a: pad(C::from(a)),
            ok: true,
        }
    }

    /// Drive waveform for a fundamental phasor: sine, or what the amplifier makes of it.
    fn amplifier(&self, v1: C) -> Vec<C> {
        let mut out = vec![C::ZERO; H + 1];
        out[1] = v1;
        out[2] += v1 * v1 * (self.even / 2.0);
        if let Some(t) = self.clip {
            let size = v1.norm();
            // The drive whose clipped waveform has this fundamental, by bisection on a fine grid.
            let coefficient = |e: f64, n: usize| -> f64 {
                let m = 2000;
                (0..m)
                    .map(|k| {
                        let th = TAU * (k as f64 + 0.5) / m as f64;
                        (e * th.cos()).clamp(-t, t) * (n as f64 * th).cos()
                    })
                    .sum::<f64>()
                    * 2.0
                    / m as f64
            };
            if size > 0.999 * t {
                let (mut lo, mut hi) = (size, 40.0 * size);
                for _ in 0..50 {
                    let mid = 0.5 * (lo + hi);
                    if coefficient(mid, 1) < size {
                        lo = mid
                    } else {
                        hi = mid
                    }
                }
                if lo > size * 1.0000001 {
                    for n in [3, 5, 7, 9, 11] {
                        out[n] += (v1 / size).powu(n as u32) * coefficient(lo, n);
                    }
                }
            }
        }
        out
    }

    /// Newton iteration on the harmonics with a numerically built Jacobian in the time domain.
    pub(crate) fn solve(&self, w: f64, a: f64) -> Solved {
        if self.linear() {
            return self.sine(w, a);
        }
        let xf = -a / (w * w);
        // Unknowns: x0, then re and im of orders 2..=H.
        let count = 1 + 2 * (H - 1);
        let mut y = vec![0.0; count];
        let mut ok = self.newton(w, xf, &mut y);
        if !ok {
            // Continuation in the size of the nonlinearity.
            y.fill(0.0);
            for part in [0.25, 0.5, 0.75, 1.0] {
                let me = Coil {
                    k2: self.k2 * part,
                    k3: self.k3 * part,
                    b2: self.b2 * part,
                    friction: self.friction * part,
                    ..*self
                };
                ok = me.newton(w, xf, &mut y);
            }
        }
        let (v, i) = self.forward(w, &self.unpack(xf, &y));
        let x = self.unpack(xf, &y);
        let acc = x
            .iter()
            .enumerate()
            .map(|(n, c)| -c * (n as f64 * w).powi(2))
            .collect();
        Solved { v, i, a: acc, ok }
    }

    fn unpack(&self, xf: f64, y: &[f64]) -> Vec<C> {
        let mut x = vec![C::ZERO; H + 1];
        x[0] = C::from(y[0]);
        x[1] = C::from(xf);
        for n in 2..=H {
            x[n] = C::new(y[2 * n - 3], y[2 * n - 2]);
        }
        x
    }

    fn newton(&self, w: f64, xf: f64, y: &mut [f64]) -> bool {
        let residual = |y: &[f64]| -> Vec<f64> {
            let (v, _) = self.forward(w, &self.unpack(xf, y));
            let want = self.amplifier(v[1]);
            let mut r = vec![v[0].re];
            for n in 2..=H {
                r.push((v[n] - want[n]).re);
                r.push((v[n] - want[n]).im);
            }
            r
        };
        let mut r = residual(y);
        let n = y.len();
        let mut lu = None;
        for step_count in 0..24 {
            if step_count % 6 == 0 {
                let mut jac = nalgebra::DMatrix::<f64>::zeros(n, n);
                for col in 0..n {
                    let h = 1e-6 * xf.abs();
                    let mut y2 = y.to_vec();
                    y2[col] += h;
                    let r2 = residual(&y2);
                    for row in 0..n {
                        jac[(row, col)] = (r2[row] - r[row]) / h;
                    }
                }
                lu = Some(jac.lu());
            }
            let right = nalgebra::DVector::from_vec(r.clone());
            let Some(step) = lu.as_ref().and_then(|l| l.solve(&right)) else {
                return false;
            };
            for (a, b) in y.iter_mut().zip(step.iter()) {
                *a -= b;
            }
            r = residual(y);
            if step.amax() < 1e-8 * xf.abs() {
                return true;
            }
        }
        false
    }

    fn forward(&self, w: f64, x: &[C]) -> (Vec<C>, Vec<C>) {
        let turn = twiddle();
        let time = |c: &[C]| -> Vec<f64> {
            (0..N)
                .map(|k| {
                    c.iter()
                        .enumerate()
                        .map(|(n, c)| {
                            let t = turn[(n * k) % N];
                            c.re * t.re - c.im * t.im
                        })
                        .sum()
                })
                .collect()
        };
        let freq = |t: &[f64]| -> Vec<C> {
            (0..=H)
                .map(|n| {
                    let s: C = t
                        .iter()
                        .enumerate()
                        .map(|(k, v)| turn[(n * k) % N].conj() * *v)
                        .sum();
                    s * (if n == 0 { 1.0 } else { 2.0 } / N as f64)
                })
                .collect()
        };
        let d = |c: &[C]| -> Vec<C> {
            c.iter()
                .enumerate()
                .map(|(n, c)| c * C::new(0.0, n as f64 * w))
                .collect()
        };
        let (xt, vt, at) = (time(x), time(&d(x)), time(&d(&d(x))));
        let mut force: Vec<f64> = (0..N)
            .map(|k| {
                let x = xt[k];
                self.mass * at[k]
                    + self.c * vt[k]
                    + self.k1 * x
                    + self.k2 * x * x
                    + self.k3 * x * x * x
                    + if self.k2 != 0.0 {
                        self.mass * self.gravity
                    } else {
                        0.0
                    }
            })
            .collect();
        if self.friction > 0.0 {
            let f = self.dry(x, &vt);
            for (a, b) in force.iter_mut().zip(time(&f)) {
                *a += b;
            }
        }
        let droop: Vec<f64> = xt.iter().map(|x| 1.0 - self.b2 * x * x).collect();
        let it: Vec<f64> = force
            .iter()
            .zip(&droop)
            .map(|(f, d)| f / (self.bl * d))
            .collect();
        let emf: Vec<f64> = vt
            .iter()
            .zip(&droop)
            .map(|(v, d)| v * self.bl * self.emf * d)
            .collect();
        let i = freq(&it);
        let e = freq(&emf);
        let v = (0..=H)
            .map(|n| {
                i[n] * if n == 0 {
                    C::from(self.r)
                } else {
                    self.z(n as f64 * w)
                } + e[n]
            })
            .collect();
        (v, i)
    }

    /// Series of the friction force from the zeros of the velocity, found by bisection.
    fn dry(&self, x: &[C], vt: &[f64]) -> Vec<C> {
        let velocity = |th: f64| -> f64 {
            let z = C::from_polar(1.0, th);
            let mut p = z;
            let mut sum = 0.0;
            for (n, c) in x.iter().enumerate().skip(1) {
                sum += (c * C::new(0.0, n as f64) * p).re;
                p *= z;
            }
            sum
        };
        let mut cuts = Vec::new();
        for k in 0..N {
            let (v0, v1) = (vt[k], vt[(k + 1) % N]);
            if (v0 < 0.0) != (v1 < 0.0) {
                let (mut a, mut b) = (TAU * k as f64 / N as f64, TAU * (k + 1) as f64 / N as f64);
                for _ in 0..30 {
                    let m = 0.5 * (a + b);
                    if (velocity(m) < 0.0) == (v0 < 0.0) {
                        a = m;
                    } else {
                        b = m;
                    }
                }
                cuts.push((0.5 * (a + b), if v0 < 0.0 { 1.0 } else { -1.0 }));
            }
        }
        let mut out = vec![C::ZERO; H + 1];
        for (k, (a, s)) in cuts.iter().enumerate() {
            let b = if k + 1 < cuts.len() {
                cuts[k + 1].0
            } else {
                cuts[0].0 + TAU
            };
            out[0] += self.friction * s * (b - a) / TAU;
            for (n, o) in out.iter_mut().enumerate().skip(1) {
                let nn = n as f64;
                let integral =
                    (C::from_polar(1.0, -nn * b) - C::from_polar(1.0, -nn * a)) / C::new(0.0, -nn);
                *o += integral * (self.friction * s / PI);
            }
        }
        out
    }
}

fn twiddle() -> &'static [C; N] {
    static TABLE: std::sync::OnceLock<[C; N]> = std::sync::OnceLock::new();
    TABLE.get_or_init(|| std::array::from_fn(|k| C::from_polar(1.0, TAU * k as f64 / N as f64)))
}
