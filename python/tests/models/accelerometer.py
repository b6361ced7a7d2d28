"""An accelerometer as an FMU: a damped resonance, and a low-pass behind it."""

import math

from pythonfmu import Fmi2Causality, Fmi2Slave, Fmi2Variability, Real


class Accelerometer(Fmi2Slave):
    """Output over input is 1 at low frequency."""

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.acceleration = 0.0
        self.voltage = 0.0
        self.resonance_hz = 32e3
        self.damping = 0.05
        self.corner_hz = 60e3
        self.state = [0.0, 0.0, 0.0]
        self.step = None
        self.register_variable(Real("acceleration", causality=Fmi2Causality.input))
        self.register_variable(Real("voltage", causality=Fmi2Causality.output))
        for name in ("resonance_hz", "damping", "corner_hz"):
            self.register_variable(
                Real(name, causality=Fmi2Causality.parameter, variability=Fmi2Variability.tunable)
            )

    def do_step(self, current_time, step_size):
        # Steps of a simulation differ by what their ends are rounded to.
        if self.step is None or abs(step_size / self.step[0] - 1) > 1e-6:
            self.step = (step_size, *self.matrices(step_size))
        _, rows, gains = self.step
        state = self.state
        self.state = [sum(p * q for p, q in zip(row, state)) + g * self.acceleration for row, g in zip(rows, gains)]
        self.voltage = self.state[2]
        return True

    def matrices(self, step_s):
        """The exact step of an input that is held."""
        import numpy
        from scipy.linalg import expm

        w, corner = 2 * math.pi * self.resonance_hz, 2 * math.pi * self.corner_hz
        system = numpy.zeros((4, 4))
        system[:3, :3] = [[0, 1, 0], [-w * w, -2 * self.damping * w, 0], [corner, 0, -corner]]
        system[1, 3] = w * w
        stepped = expm(step_s * system)
        return stepped[:3, :3].tolist(), stepped[:3, 3].tolist()
