-- Advice on the interval of each device, days: until its drift, with twice the uncertainty of the slope, has used up
-- half a per cent beside U; from 30 days to 5 years. Fewer than three results: 1 year (ILAC-G24, 7.4).
WITH results AS (
    SELECT dut_model, dut_serial, time_s / 31557600.0 AS year, sensitivity_v_per_ms2 AS s
    FROM records
    WHERE time_s IS NOT NULL AND sensitivity_v_per_ms2 IS NOT NULL AND dut_serial <> ''
), centred AS (
    SELECT *, year - avg(year) OVER (PARTITION BY dut_model, dut_serial) AS x,
           s / avg(s) OVER (PARTITION BY dut_model, dut_serial) - 1 AS y
    FROM results
), lines AS (
    SELECT dut_model, dut_serial, count(*) AS results, max(year) AS last_year,
           sum(x * x) AS sxx, sum(x * y) AS sxy, sum(y * y) AS syy
    FROM centred GROUP BY dut_model, dut_serial
), rates AS (
    SELECT *, CASE WHEN results >= 3 AND sxx > 0
        THEN abs(sxy / sxx) + 2 * sqrt(greatest(syy - sxy * sxy / sxx, 0) / (results - 2) / sxx) END AS rate
    FROM lines
)
SELECT dut_model, dut_serial, results,
       CASE WHEN rate IS NULL THEN 365.25 ELSE 365.25 * least(greatest(0.005 / greatest(rate, 1e-9), 30 / 365.25), 5) END
           AS interval_days,
       31557600.0 * last_year AS last_s
FROM rates
ORDER BY dut_model, dut_serial
