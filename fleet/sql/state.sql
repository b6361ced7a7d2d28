-- State of the fleet: each instrument with its records, its last check, when the next is due, and how far its last check
-- was from the first.
WITH seen AS (
    SELECT laboratory, instrument_serial, count(*) AS records, max(time_s) AS last_s,
           1.0 * sum(refused) / greatest(sum(points), 1) AS refused_rel
    FROM records GROUP BY laboratory, instrument_serial
), numbered AS (
    SELECT *, row_number() OVER (PARTITION BY instrument_serial, check_serial ORDER BY time_s, record_sha256) AS early,
           row_number() OVER (PARTITION BY instrument_serial ORDER BY time_s DESC, record_sha256) AS late,
           first_value(sensitivity_v_per_ms2) OVER (
               PARTITION BY instrument_serial, check_serial ORDER BY time_s, record_sha256) AS first_s
    FROM checks WHERE state = 'valid'
)
SELECT seen.laboratory, seen.instrument_serial, records, seen.last_s, refused_rel, time_s AS last_check_s,
       time_s + 86400.0 * every_days AS due_s, sensitivity_v_per_ms2 / first_s - 1 AS since_first_rel
FROM seen LEFT JOIN numbered ON numbered.instrument_serial = seen.instrument_serial AND late = 1
ORDER BY due_s IS NULL, due_s, seen.instrument_serial
