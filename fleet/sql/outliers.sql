-- Instruments that disagree with the fleet: E_n (ISO 13528, 9.7) of what each gives for a device that three instruments
-- or more have measured, against the mean of the others. Beyond 1 it is an outlier.
WITH each AS (
    SELECT dut_serial, instrument_serial, avg(sensitivity_v_per_ms2) AS s,
           -- Common to its results: the mean has hardly a smaller U than one of them.
           max(expanded_uncertainty_rel) AS u_rel
    FROM records
    WHERE sensitivity_v_per_ms2 IS NOT NULL AND dut_serial <> ''
    GROUP BY dut_serial, instrument_serial
), sums AS (
    SELECT *, count(*) OVER (PARTITION BY dut_serial) AS instruments,
           sum(s) OVER (PARTITION BY dut_serial) AS all_s,
           sum(s * u_rel * s * u_rel) OVER (PARTITION BY dut_serial) AS all_u2
    FROM each
), compared AS (
    SELECT dut_serial, instrument_serial, instruments, s, s * u_rel AS u,
           (all_s - s) / (instruments - 1) AS others,
           sqrt(greatest(all_u2 - s * u_rel * s * u_rel, 0)) / (instruments - 1) AS u_others
    FROM sums WHERE instruments >= 3
)
SELECT instrument_serial, dut_serial, instruments, s / others - 1 AS deviation_rel,
       (s - others) / sqrt(u * u + u_others * u_others) AS e_n
FROM compared
ORDER BY instrument_serial, dut_serial
