"""Calculations of the standards: tables and arrays in, documents out."""

from typing import Any, Dict, List, Optional

from . import _tables
from ._answer import Document
from ._tables import Content, Table
from ._verb import carry_out
from .errors import UsageError


def budget(content: Content, *, monte_carlo: bool = False, seed: int = 1, chart: Optional[str] = None) -> Document:
    """Evaluates an uncertainty budget (ISO 16063-21 Annex A, GUM).

    Args:
        content: a TOML file, or a dictionary of what is in one: ``{"measurand": ..., "component": [{"label": ...,
            "value": 0.5, "distribution": "normal", "k": 2}, ...], "correlation": [...]}``. Values in percent, of a
            phase in degrees; docs/metrology/budget.md has every key.
        monte_carlo: propagates the distributions too (GUM-S1), and judges the first-order result.
        seed: of the random numbers.
        chart: writes the contributions into this SVG.

    Returns:
        Combined and expanded uncertainty, coverage factor, effective degrees of freedom, contributions.

    Raises:
        InputError: a component is impossible; the message names it.
    """
    with _tables.folder() as into:
        file = _tables.content_file(content, into, "budget.toml")
        options = {"monte_carlo": monte_carlo, "seed": seed if monte_carlo else None, "chart": chart}
        return carry_out(["budget", str(file)], options, hide=str(into))


def identify(
    points: Optional[Table] = None,
    *,
    shock: Optional[Table] = None,
    unweighted: bool = False,
    significance: float = 0.05,
    trials: int = 20_000,
    seed: int = 1,
    **options: object,
) -> Document:
    """Identifies the model of an accelerometer (ISO 16063-43).

    Args:
        points: columns ``frequency_hz``, ``magnitude``, ``phase_deg``, and with standard uncertainties
            ``u_magnitude_percent``, ``u_phase_deg``; the phase of an output that lags is negative.
        shock: a record instead: ``time_s``, ``input``, ``output``, equally spaced; options ``from_hz``, ``to_hz``,
            ``pre_warp``, ``input_delay_s``, ``u0``.
        unweighted: ignores the stated uncertainties.
        significance: of the chi-squared test, at most 0.05.
        trials: of the Monte Carlo propagation, 0 for none.
        seed: of the random numbers.

    Returns:
        Parameters with uncertainties, and whether the data are consistent with the model.

    Warns:
        NotPassedWarning: the data reject the model.
    """
    if (points is None) == (shock is None):
        raise UsageError("give points, or shock=", "a table of sine points is the first argument")
    with _tables.folder() as into:
        if shock is not None:
            file = _tables.table_file(shock, into, "shock.csv")
            return carry_out(["identify"], {"shock": file, **options}, hide=str(into))
        file = _tables.table_file(points, into, "points.csv")
        options.update(unweighted=unweighted, significance=significance, trials=trials, seed=seed)
        return carry_out(["identify", str(file)], options, hide=str(into))


def phase(content: Content) -> Document:
    """Phase by comparison with the uncertainty of ISO 5347-9.

    Args:
        content: a TOML file or a dictionary: ``reference_deg``, ``phasemeter_deg``, ``amplifier_deg`` (limits of
            Annex A, degrees) and ``frequency``, a list of ``{"frequency_hz", "phase_difference_deg": [...],
            "reference_phase_deg"}``.
    """
    with _tables.folder() as into:
        file = _tables.content_file(content, into, "phase.toml")
        return carry_out(["phase", str(file)], {}, hide=str(into))


def linking(results: Optional[Content] = None, *, doe: Optional[Table] = None, chart: Optional[str] = None) -> Document:
    """Links comparisons, and judges degrees of equivalence.

    Args:
        results: a TOML file or a dictionary with ``cipm`` and ``rmo``, lists of ``{"laboratory", "frequency_hz",
            "value", "standard_uncertainty"}``.
        doe: published degrees of equivalence instead: columns ``laboratory``, ``frequency_hz``,
            ``degree_of_equivalence``, ``expanded_uncertainty``.
        chart: writes the graph into this SVG.
    """
    if (results is None) == (doe is None):
        raise UsageError("give results, or doe=", "results of both comparisons are the first argument")
    with _tables.folder() as into:
        if doe is not None:
            file = _tables.table_file(doe, into, "degrees.csv")
            return carry_out(["linking"], {"doe": file, "chart": chart}, hide=str(into))
        file = _tables.content_file(results, into, "results.toml")
        return carry_out(["linking", str(file)], {"chart": chart}, hide=str(into))


def sensitivity(readings: Table, *, example: int = 2, quantity: str = "acceleration") -> Document:
    """Sensitivity from readings, by clause 6 of ISO 16063-21: comparison, consecutive, calibrator.

    Args:
        readings: columns ``frequency_hz``, ``dut_v`` and those of one method (docs/metrology/sensitivity.md).
        example: drift allowed by Table 3: 1 in a laboratory (0.1 %), 2 in the field (0.3 %).
        quantity: ``acceleration``, ``velocity`` or ``displacement``.

    Warns:
        NotPassedWarning: points were refused; their sensitivity is ``None``.
    """
    with _tables.folder() as into:
        file = _tables.table_file(readings, into, "readings.csv")
        options: Dict[str, object] = {"example": example, "quantity": quantity}
        return carry_out(["sensitivity", str(file)], options, hide=str(into))


def convert(frequency_hz: Any, sensitivity: Any, phase_deg: Any = 0.0, *, quantity: str = "acceleration") -> Any:
    """A sensitivity as that to acceleration, velocity and displacement (clause 6).

    Args:
        frequency_hz: Hz; a number, or an array.
        sensitivity: its magnitude, V per SI unit of ``quantity``.
        phase_deg: its phase, degrees.
        quantity: what it refers to: ``acceleration``, ``velocity`` or ``displacement``.

    Returns:
        A document; for arrays a list of them, in order.
    """
    given = {"frequency_hz": frequency_hz, "sensitivity": sensitivity, "phase_deg": phase_deg}
    rows = _tables.columns(given)
    done: List[Document] = [
        carry_out(["convert"], {"frequency": f, "sensitivity": s, "phase": p, "from": quantity})
        for f, s, p in zip(*rows.values())
    ]
    scalar = not any(hasattr(value, "__len__") for value in given.values())
    return done[0] if scalar else done


def risk(ratio: float, in_tolerance: float = 95.0) -> List[Document]:
    """Risks of decision rules over many sensors (JCGM 106:2012, clause 9).

    Args:
        ratio: tolerance over expanded uncertainty (k = 2), above 1.
        in_tolerance: share of the sensors within tolerance, percent, from 50 to below 100.

    Returns:
        For each rule its acceptance limit and the probabilities of false acceptance and rejection.
    """
    return carry_out(["risk"], {"ratio": ratio, "in_tolerance": in_tolerance})


