//! The clauses that ask for statements, by what they ask for.

/// Name of the laboratory.
pub(super) const LABORATORY: &str = "ISO/IEC 17025 7.8.2.1 b";
/// Where it was calibrated.
pub(super) const PLACE: &str = "ISO/IEC 17025 7.8.2.1 c";
/// Name of the customer.
pub(super) const CUSTOMER: &str = "ISO/IEC 17025 7.8.2.1 e";
/// Method used.
pub(super) const METHOD: &str = "ISO/IEC 17025 7.8.2.1 f";
/// The object, and its condition.
pub(super) const ITEM: &str = "ISO/IEC 17025 7.8.2.1 g";
/// Day the object was received.
pub(super) const RECEIVED: &str = "ISO/IEC 17025 7.8.2.1 h";
/// Day of the calibration.
pub(super) const DAY: &str = "ISO/IEC 17025 7.8.2.1 i";
/// Day of issue.
pub(super) const ISSUED: &str = "ISO/IEC 17025 7.8.2.1 j";
/// Deviations from the method.
pub(super) const DEVIATIONS: &str = "ISO/IEC 17025 7.8.2.1 n";
/// Which certificate it replaces, and why.
pub(super) const AMENDMENT: &str = "ISO/IEC 17025 7.8.8";
/// Who authorises the certificate.
pub(super) const APPROVED: &str = "ISO/IEC 17025 7.8.2.1 o";
/// Conditions that influence the results.
pub(super) const INFLUENCES: &str = "ISO/IEC 17025 7.8.4.1 b";
/// How the results are traceable.
pub(super) const TRACEABILITY: &str = "ISO/IEC 17025 7.8.4.1 c";
/// Results before and after an adjustment.
pub(super) const ADJUSTMENT: &str = "ISO/IEC 17025 7.8.4.1 d";

/// Instruments used.
pub(super) const INSTRUMENTS: &str = "ISO 16063-21 7";
/// Ambient conditions.
pub(super) const AMBIENT: &str = "ISO 16063-21 7 a";
/// Temperature of the transducer.
pub(super) const TRANSDUCER_TEMPERATURE: &str = "ISO 16063-21 7 a, b";
/// Mounting technique.
pub(super) const MOUNTING: &str = "ISO 16063-21 7 c";
/// Settings of the object's amplifier.
pub(super) const AMPLIFIER: &str = "ISO 16063-21 7 d";
/// Results.
pub(in super::super) const RESULTS: &str = "ISO 16063-21 7 e";
/// No clause asks for it.
pub(super) const NONE: &str = "";
