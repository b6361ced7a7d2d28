-- Drift of each device at its reference point, per year of 365.25 days, relative to its mean sensitivity.
-- Standard uncertainty of the slope from the scatter about the line: GUM H.3. Three results at least.
WITH results AS (
    SELECT dut_model, dut_serial, time_s / 31557600.0 AS year, sensitivity_v_per_ms2 AS s
    FROM records
    WHERE time_s IS NOT NULL AND sensitivity_v_per_ms2 IS NOT NULL AND dut_serial <> ''
), centred AS (
    SELECT *, year - avg(year) OVER (PARTITION BY dut_model, dut_serial) AS x,
           s / avg(s) OVER (PARTITION BY dut_model, dut_serial) - 1 AS y
    FROM results
), lines AS (
    SELECT dut_model, dut_serial, count(*) AS results, min(year) AS first_year, max(year) AS last_year,
           sum(x * x) AS sxx, sum(x * y) AS sxy, sum(y * y) AS syy
    FROM centred GROUP BY dut_model, dut_serial
)
SELECT dut_model, dut_serial, results, last_year - first_year AS span_years, sxy / sxx AS drift_rel_per_year,
       sqrt(greatest(syy - sxy * sxy / sxx, 0) / (results - 2) / sxx) AS standard_uncertainty_rel_per_year
FROM lines WHERE results >= 3 AND sxx > 0
ORDER BY dut_model, dut_serial
