-- Drift of each device at its reference point, per year of 365.25 days, relative to its mean sensitivity.
SELECT dut_model, dut_serial, results, last_year - first_year AS span_years, slope_rel_per_year AS drift_rel_per_year,
       standard_uncertainty_rel_per_year
FROM lines WHERE slope_rel_per_year IS NOT NULL
ORDER BY dut_model, dut_serial
