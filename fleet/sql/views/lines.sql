-- Line of each device through its results at its reference point, relative to its mean sensitivity, years of 365.25 days.
WITH results AS (
    SELECT dut_model, dut_serial, time_s / 31557600.0 AS year, sensitivity_v_per_ms2 AS s
    FROM records
    WHERE time_s IS NOT NULL AND sensitivity_v_per_ms2 IS NOT NULL AND dut_serial <> ''
), centred AS (
    SELECT *, year - avg(year) OVER (PARTITION BY dut_model, dut_serial) AS x,
           s / avg(s) OVER (PARTITION BY dut_model, dut_serial) - 1 AS y
    FROM results
), sums AS (
    SELECT dut_model, dut_serial, count(*) AS results, min(year) AS first_year, max(year) AS last_year,
           sum(x * x) AS sxx, sum(x * y) AS sxy, sum(y * y) AS syy
    FROM centred GROUP BY dut_model, dut_serial
)
-- Standard uncertainty of the slope from the scatter about the line: GUM H.3. Three results at least, else both are NULL.
SELECT dut_model, dut_serial, results, first_year, last_year,
       CASE WHEN results >= 3 AND sxx > 0 THEN sxy / sxx END AS slope_rel_per_year,
       CASE WHEN results >= 3 AND sxx > 0 THEN sqrt(greatest(syy - sxy * sxy / sxx, 0) / (results - 2) / sxx) END
           AS standard_uncertainty_rel_per_year
FROM sums
