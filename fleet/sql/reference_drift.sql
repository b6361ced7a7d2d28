-- Drift of each instrument's reference, per year, as its check standards show it: the slope common to all of them, each
-- about its own mean, the other way round: a reference that gives more makes every standard look less. A standard that
-- drifts itself shows in every instrument that measures it.
WITH results AS (
    SELECT instrument_serial, check_serial, time_s / 31557600.0 AS year, sensitivity_v_per_ms2 AS s
    FROM checks WHERE state = 'valid' AND time_s IS NOT NULL
), centred AS (
    SELECT *, year - avg(year) OVER (PARTITION BY instrument_serial, check_serial) AS x,
           s / avg(s) OVER (PARTITION BY instrument_serial, check_serial) - 1 AS y
    FROM results
), lines AS (
    SELECT instrument_serial, count(*) AS results, count(DISTINCT check_serial) AS standards,
           sum(x * x) AS sxx, sum(x * y) AS sxy, sum(y * y) AS syy
    FROM centred GROUP BY instrument_serial
)
SELECT instrument_serial, results, standards, -sxy / sxx AS drift_rel_per_year,
       sqrt(greatest(syy - sxy * sxy / sxx, 0) / (results - standards - 1) / sxx) AS standard_uncertainty_rel_per_year
FROM lines WHERE results > standards + 1 AND sxx > 0
ORDER BY instrument_serial
