-- Advice on the interval of each device, days: until its drift, with twice the uncertainty of the slope, has used up
-- half a per cent beside U; from 30 days to 5 years. Fewer than three results: 1 year (ILAC-G24, 7.4).
WITH rates AS (
    SELECT *, abs(slope_rel_per_year) + 2 * standard_uncertainty_rel_per_year AS rate FROM lines
)
SELECT dut_model, dut_serial, results,
       CASE WHEN rate IS NULL THEN 365.25 ELSE 365.25 * least(greatest(0.005 / greatest(rate, 1e-9), 30 / 365.25), 5) END
           AS interval_days,
       31557600.0 * last_year AS last_s
FROM rates
ORDER BY dut_model, dut_serial
