//! A rig with its truth, and the rows it would write.

use super::collocation::{Coil, H};
use super::design::Condition;
use super::random::Random;
use num_complex::Complex64 as C;
use std::f64::consts::{PI, SQRT_2, TAU};
use std::fmt::Write;

/// Truth: nominal values as they really are, and any effects, all neutral by default.
#[derive(Clone)]
pub(crate) struct Truth {
    pub(crate) s1: f64,
    pub(crate) s2: f64,
    pub(crate) coil: [f64; 6],
    pub(crate) noise: f64,
    pub(crate) e: std::collections::BTreeMap<&'static str, f64>,
}

impl Truth {
    pub(crate) fn get(&self, k: &str) -> Option<f64> {
        self.e.get(k).copied()
    }
    fn or(&self, k: &str, d: f64) -> f64 {
        self.get(k).unwrap_or(d)
    }
}

fn so(f: f64, f0: f64, q: f64) -> C {
    let w = f / f0;
    C::ONE / (C::ONE - w * w + C::new(0.0, w / q))
}

/// Reference and DUT response at a frequency.
fn chains(t: &Truth, c: &Condition, f: f64) -> (C, C, C) {
    let (mut r, mut d, mut table) = (C::ONE, C::ONE, C::ONE);
    let rot = c.rotation.to_radians();
    if let Some(fr) = t.get("dut_resonance.f") {
        d *= so(f, fr, t.or("dut_resonance.q", 30.0));
    }
    if let Some(fr) = t.get("reference_resonance.f") {
        r *= so(f, fr, t.or("reference_resonance.q", 30.0));
    }
    if let Some(km) = t.get("mount_compliance.k") {
        d *= so(
            f,
            (km / c.payload).sqrt() / TAU,
            t.or("mount_compliance.q", 20.0),
        );
    }
    if let Some(k) = t.get("relative_motion.k") {
        d *= 1.0 - k * c.payload * f * f;
    }
    if let Some(t0) = t.get("transverse_motion.t0") {
        let h = so(
            f,
            t.or("transverse_motion.f", 1000.0),
            t.or("transverse_motion.q", 10.0),
        ) * t.or("transverse_motion.t1", 0.0);
        d *= C::ONE + (h + t0) * (rot - t.or("transverse_motion.beta", 0.0)).cos();
    }
    if let Some(s) = t.get("base_strain.s") {
        d *= 1.0 + s * c.payload / 0.04 / (1.0 + (f / t.or("base_strain.f1", 30.0)).powi(2));
    }
    if let Some(g) = t.get("gravity_tilt.g") {
        d *= 1.0 + g * rot.cos() / (f * f);
    }
    if let Some(s) = t.get("dut_frequency_slope.s") {
        d *= 1.0 - s * (f / 159.155).log10();
    }
    if let Some(g) = t.get("dut_level_nonlinearity.g") {
        d *= 1.0 + g * c.level;
    }
    d *= 1.0 + t.or("dut_temperature.a", 0.0) * (c.temperature - 23.0);
    r *= 1.0 + t.or("reference_temperature.a", 0.0) * (c.temperature - 23.0);
    r *= 1.0 / (1.0 + t.or("reference_drift.b", 0.0) * c.time);
    d *= 1.0 + t.or("dut_drift.b", 0.0) * c.time;
    if let Some(fc) = t.get("dut_highpass.f") {
        d *= C::new(0.0, f / fc) / C::new(1.0, f / fc);
    }
    if let Some(fc) = t.get("reference_highpass.f") {
        r *= C::new(0.0, f / fc) / C::new(1.0, f / fc);
    }
    if let Some(fc) = t.get("dut_lowpass_1.f") {
        d /= C::new(1.0, f / fc);
    }
    if let Some(fc) = t.get("dut_lowpass_2.f") {
        d *= so(f, fc, t.or("dut_lowpass_2.q", 0.707));
    }
    if let Some(tt) = t.get("averaging_window.t") {
        let a = PI * f * tt;
        d *= C::from_polar(a.sin() / a, -a);
    }
    if let Some(a) = t.get("crosstalk.c") {
        d *= C::new(1.0, f * a);
    }
    if let Some(a) = t.get("channel_skew.t") {
        d *= C::from_polar(1.0, -TAU * f * a);
    }
    if let Some(a) = t.get("clock_offset.d") {
        d *= C::from_polar(1.0, TAU * f * a * c.time);
    }
    if let Some(s) = t.get("sampling_jitter.s") {
        let g = (-(TAU * f * s).powi(2) / 2.0).exp();
        r *= g;
        d *= g;
    }
    if let Some(k) = t.get("armature_mode.k") {
        let q = f / t.or("armature_mode.f", 5000.0);
        table *= C::ONE + k * q * q / C::new(1.0 - q * q, 2.0 * t.or("armature_mode.z", 0.02) * q);
    }
    (r, d, table)
}

/// Complex amplitudes 0..=5 of a waveform after a static characteristic, by sampling.
fn bent(h: &[C], f: impl Fn(f64) -> f64) -> Vec<C> {
    let m = 4096;
    let mut out = vec![C::ZERO; 6];
    for k in 0..m {
        let th = TAU * (k as f64 + 0.5) / m as f64;
        let v: f64 = h
            .iter()
            .enumerate()
            .map(|(n, c)| (c * C::from_polar(1.0, n as f64 * th)).re)
            .sum();
        let y = f(v);
        for (n, o) in out.iter_mut().enumerate() {
            *o += C::from_polar(y, -(n as f64) * th) * (if n == 0 { 1.0 } else { 2.0 } / m as f64);
        }
    }
    out
}

fn adc(t: &Truth, ch: &str, h: Vec<C>) -> Vec<C> {
    let key = |n: &str| t.get(&format!("{n}.{ch}"));
    if let Some(c3) = key("adc_cubic") {
        return bent(&h, |v| v + c3 * v * v * v);
    }
    if let Some(c2) = key("adc_quadratic") {
        return bent(&h, |v| v + c2 * v * v);
    }
    if let Some(d) = key("adc_dead_zone") {
        return bent(&h, |v| v.signum() * (v.abs() - d).max(0.0));
    }
    if let Some(c) = key("adc_clipping") {
        return bent(&h, |v| v.clamp(-c, c));
    }
    h
}

pub(crate) struct Output {
    pub(crate) points: String,
    pub(crate) rig: String,
    pub(crate) too_distorted: usize,
}

/// Uncertainties of a case.
pub(crate) struct Quality {
    pub(crate) u_ratio: f64,
    pub(crate) u_phase_deg: f64,
    pub(crate) u_drive: f64,
    pub(crate) u_current: f64,
    pub(crate) u_harmonic: f64,
    pub(crate) u_dc: f64,
}

pub(crate) const GOOD: Quality = Quality {
    u_ratio: 0.0005,
    u_phase_deg: 0.03,
    u_drive: 0.001,
    u_current: 0.001,
    u_harmonic: 5e-5,
    u_dc: 5e-6,
};

pub(crate) const NOMINAL: [(&str, f64, f64); 6] = [
    ("moving_mass_kg", 0.05, 0.0005),
    ("stiffness_n_per_m", 8000.0, 400.0),
    ("damping_ns_per_m", 3.0, 0.6),
    ("force_factor_n_per_a", 7.0, 0.2),
    ("coil_resistance_ohm", 4.0, 0.05),
    ("coil_inductance_h", 0.00012, 0.00001),
];

pub(crate) fn honest(random: &mut Random) -> Truth {
    let mut coil = [0.0; 6];
    for (v, (_, n, u)) in coil.iter_mut().zip(NOMINAL) {
        *v = n + u * random.normal().clamp(-2.5, 2.5);
    }
    Truth {
        s1: 0.0102 + 0.00003 * random.normal(),
        s2: 0.01 * (1.0 + 0.05 * random.normal()),
        coil,
        noise: 4e-5 * (1.0 + 0.01 * random.normal()),
        e: Default::default(),
    }
}

pub(crate) fn write(
    truth: &Truth,
    design: &[Condition],
    q: &Quality,
    full: bool,
    random: &mut Random,
) -> Output {
    let s1n = 0.0102;
    let block = 16384.0 / 51200.0;
    let mut csv =
        String::from("frequency_hz,run,time_s,temperature_c,rotation_deg,tilt_deg,payload_kg,");
    csv += if full {
        "acceleration_ms2,coil_v,coil_a,coil_a_deg,ref_v,ref_deg,dut_v,dut_deg,ref_h2,ref_h3,ref_h4,ref_h5,ref_h2_deg,ref_h3_deg,ref_h4_deg,ref_h5_deg,dut_h2,dut_h3,dut_h4,dut_h5,dut_h2_deg,dut_h3_deg,dut_h4_deg,dut_h5_deg,ref_dc_v,dut_dc_v,ref_noise_v,dut_noise_v,u_ratio,u_phase_deg,u_drive,u_current,u_harmonic,u_dc_v\n"
    } else {
        "ratio,dut_deg,u_ratio,u_phase_deg\n"
    };
    let runs = design.iter().map(|c| c.run).max().unwrap_or(0) + 1;
    let gains: Vec<(f64, f64)> = (0..runs)
        .map(|_| (1.0 + 2e-4 * random.normal(), 1.0 + 2e-4 * random.normal()))
        .collect();
    let mut too_distorted = 0;
    for c in design {
        let w = TAU * c.f;
        let (r1, d1, t1) = chains(truth, c, c.f);
        let heat = truth.get("coil_heating.dt").map_or(1.0, |dt| {
            1.0 + 0.0039 * dt * (1.0 - (-c.time / truth.or("coil_heating.tau", 600.0)).exp())
        });
        let coil = Coil {
            mass: truth.coil[0] + c.payload + truth.or("payload_mass.m", 0.0),
            k1: truth.coil[1],
            c: truth.coil[2] + truth.or("mechanical_damping.c", 0.0),
            bl: truth.coil[3],
            emf: 1.0 + truth.or("back_emf.b", 0.0),
            r: truth.coil[4] * heat,
            l: truth.coil[5],
            exponent: truth.or("lossy_inductance.n", 1.0),
            k2: truth.or("suspension_asymmetry.k", 0.0),
            k3: truth.or("suspension_cubic.k", 0.0),
            b2: truth.or("force_factor_droop.b", 0.0),
            friction: truth.or("coulomb_friction.f", 0.0),
            gravity: 9.80665 * c.tilt.to_radians().cos(),
            clip: truth.get("amplifier_clipping.v"),
            even: truth.or("amplifier_even_order.b", 0.0),
        };
        // The level: find the table acceleration whose reference reading is the wanted one.
        let wanted = c.level * s1n * SQRT_2;
        let mut a = wanted / (truth.s1 * gains[c.run].0 * (r1 * t1).norm());
        let mut solved = coil.sine(w, a);
        let (mut ref_h, mut dut_h) = (Vec::new(), Vec::new());
        for _ in 0..3 {
            solved = coil.solve(w, a);
            ref_h = vec![C::ZERO; 6];
            dut_h = vec![C::ZERO; 6];
            for n in 1..=5usize.min(H) {
                let (r, d, t) = chains(truth, c, c.f * n as f64);
                ref_h[n] = solved.a[n] * t * r * truth.s1 * gains[c.run].0;
                dut_h[n] = solved.a[n] * t * d * truth.s2 * gains[c.run].1;
            }
            if let Some(th) = truth.get("loose_mount.t") {
                let side = truth.or("loose_mount.side", -1.0);
                let motion: Vec<C> = (0..=5)
                    .map(|n| {
                        let (_, _, t) = chains(truth, c, c.f * n as f64);
                        if n == 0 { C::ZERO } else { solved.a[n] * t }
                    })
                    .collect();
                let cut = bent(&motion, |v| if side < 0.0 { v.max(-th) } else { v.min(th) });
                for n in 1..=5 {
                    let (_, d, _) = chains(truth, c, c.f * n as f64);
                    dut_h[n] = cut[n] * d * truth.s2 * gains[c.run].1;
                }
            }
            ref_h = adc(truth, "ref", ref_h);
            dut_h = adc(truth, "dut", dut_h);
            if (ref_h[1].norm() / wanted - 1.0).abs() < 1e-7 {
                break;
            }
            a *= wanted / ref_h[1].norm();
        }
        let _ = d1;
        let rel =
            |h: &[C], n: usize| h[n] / h[1].norm() * C::from_polar(1.0, -(n as f64) * h[1].arg());
        if !solved.ok || (2..=5).any(|n| rel(&ref_h, n).norm() > 0.3 || rel(&dut_h, n).norm() > 0.3)
        {
            too_distorted += 1;
            continue;
        }
        let v = solved.v[1];
        let mut drift = 1.0;
        drift *= 1.0 + truth.or("amplifier_gain_drift.b", 0.0) * c.time;
        let mut drive = ref_h[1] / v * drift;
        let current = solved.i[1] / v;
        let mut ratio = dut_h[1] / ref_h[1];
        if truth.get("dut_level_nonlinearity.h2").is_some() {
            let g = truth.or("dut_level_nonlinearity.h2", 0.0) * c.level;
            let turn = C::from_polar(1.0, 2.0 * dut_h[1].arg());
            let added = turn * dut_h[1].norm() * g;
            dut_h[2] += added;
        }
        let (mut n1, mut n2) = (truth.noise.powi(2), truth.noise.powi(2));
        let sinc = |x: f64| {
            if x.abs() < 1e-9 {
                1.0
            } else {
                (PI * x).sin() / (PI * x)
            }
        };
        let (vr, vd) = (ref_h[1].norm() / SQRT_2, dut_h[1].norm() / SQRT_2);
        if let Some(p) = truth.get("mains_pickup.v") {
            n2 += p * p;
            let mains = 50.02;
            for (n, share) in [(1.0, 0.8), (2.0, 0.36), (3.0, 0.48)] {
                let leak = p * share * sinc((c.f - n * mains) * block) / vd;
                ratio *= C::ONE + C::from_polar(leak, TAU * random.uniform());
            }
        }
        if let Some(s) = truth.get("sampling_jitter.s") {
            n1 += (w * s * vr).powi(2);
            n2 += (w * s * vd).powi(2);
        }
        if let Some(b) = truth.get("ambient_vibration.a") {
            let tone = truth.or("ambient_vibration.tone", 0.0);
            n1 += (b * b + tone * tone) * truth.s1.powi(2);
            n2 += (b * b + tone * tone) * truth.s2.powi(2);
            let d = (c.f - truth.or("ambient_vibration.f", 10.0)) * block;
            if d.abs() < 1.0 {
                drive *= C::ONE + C::from_polar(tone * sinc(d) / c.level, TAU * random.uniform());
            }
        }
        if let Some(th) = truth.get("loose_mount.t") {
            let x = (c.level * SQRT_2 - th).max(0.0);
            n2 += (truth.or("loose_mount.noise", 0.0) * x * truth.s2).powi(2);
        }
        let gain = |r: &mut Random, u: f64| 1.0 + u * r.normal();
        let rm = ratio.norm() * gain(random, q.u_ratio);
        let rp = ratio.arg().to_degrees() + q.u_phase_deg * random.normal();
        let _ = write!(
            csv,
            "{},r{},{},{},{},{},{},",
            c.f, c.run, c.time, c.temperature, c.rotation, c.tilt, c.payload
        );
        if !full {
            let _ = writeln!(csv, "{rm},{rp},{},{}", q.u_ratio, q.u_phase_deg);
            continue;
        }
        let ref_v = c.level * s1n;
        let dm = drive.norm() * gain(random, q.u_drive);
        let dp = (drive.arg() + q.u_drive * random.normal()).to_degrees();
        let coil_v = ref_v / dm;
        let coil_a = coil_v * current.norm() * gain(random, q.u_current);
        let ip = (current.arg() + q.u_current * random.normal()).to_degrees();
        let _ = write!(
            csv,
            "{},{coil_v},{coil_a},{ip},{ref_v},{dp},{},{rp},",
            c.level,
            rm * ref_v
        );
        for h in [&ref_h, &dut_h] {
            let noisy: Vec<C> = (2..=5)
                .map(|n| {
                    rel(h, n)
                        + C::new(
                            q.u_harmonic * random.normal(),
                            q.u_harmonic * random.normal(),
                        )
                })
                .collect();
            for n in &noisy {
                let _ = write!(csv, "{},", n.norm());
            }
            for n in &noisy {
                let _ = write!(csv, "{},", n.arg().to_degrees());
            }
        }
        let _ = write!(
            csv,
            "{},{},",
            ref_h[0].re + q.u_dc * random.normal(),
            dut_h[0].re + q.u_dc * random.normal()
        );
        let _ = write!(
            csv,
            "{},{},",
            n1.sqrt() * gain(random, 0.01),
            n2.sqrt() * gain(random, 0.01)
        );
        let _ = writeln!(
            csv,
            "{},{},{},{},{},{}",
            q.u_ratio, q.u_phase_deg, q.u_drive, q.u_current, q.u_harmonic, q.u_dc
        );
    }
    let mut rig = String::from(
        "kind = \"calibrator\"\nmeasurand = \"dut_sensitivity\"\n[reference]\nsensitivity_v_per_ms2 = { value = 0.0102, u = 0.00003 }\n[dut]\nsensitivity_v_per_ms2 = { value = 0.01, u = 0.0005 }\n[exciter]\n",
    );
    for (name, v, u) in NOMINAL {
        let _ = writeln!(rig, "{name} = {{ value = {v}, u = {u} }}");
    }
    rig += "[repeatability]\nreference_gain = 0.0002\ndut_gain = 0.0002\n[digitiser]\nsample_rate_hz = 51200.0\nblock_samples = 16384\nfull_scale_v = 5.0\nbits = 16\nnoise_v = { value = 4e-5, u = 4e-7 }\n[environment]\nreference_temperature_c = 23.0\nmains_hz = 50.0\n";
    Output {
        points: csv,
        rig,
        too_distorted,
    }
}
