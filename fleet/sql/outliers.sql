-- Instruments that disagree with the fleet: E_n (ISO 13528, 9.7) of what each gives for a device that three instruments
-- or more have measured, against their median, which one that is out does not move. Beyond 1 it is an outlier.
WITH each AS (
    SELECT dut_serial, instrument_serial, avg(sensitivity_v_per_ms2) AS s,
           -- Common to its results: the mean has hardly a smaller U than one of them.
           avg(sensitivity_v_per_ms2) * max(expanded_uncertainty_rel) AS u
    FROM records
    WHERE sensitivity_v_per_ms2 IS NOT NULL AND dut_serial <> ''
    GROUP BY dut_serial, instrument_serial
), fleet AS (
    SELECT dut_serial, count(*) AS instruments, median(s) AS s,
           -- A median has the uncertainty of a mean times sqrt(pi / 2).
           1.2533 * sqrt(sum(u * u)) / count(*) AS u
    FROM each GROUP BY dut_serial HAVING count(*) >= 3
)
SELECT instrument_serial, each.dut_serial, instruments, each.s / fleet.s - 1 AS deviation_rel,
       (each.s - fleet.s) / sqrt(each.u * each.u + fleet.u * fleet.u) AS e_n
FROM each JOIN fleet ON each.dut_serial = fleet.dut_serial
ORDER BY instrument_serial, each.dut_serial
