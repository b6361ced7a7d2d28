//! The signature container of PAdES: CMS SignedData without the content it signs (RFC 5652), with the signing
//! certificate among what is signed (RFC 5035), as ETSI EN 319 142-1, 6.3 wants of level B-B.

use crate::certificate::{ECDSA_SHA256, RSA, RSA_SHA256, Scheme};
use crate::{Certificate, LaboratoryKey, Problem};
use ::cms::cert::{CertificateChoices, IssuerAndSerialNumber};
use ::cms::content_info::{CmsVersion, ContentInfo};
use ::cms::signed_data::{
    CertificateSet, EncapsulatedContentInfo, SignedAttributes, SignedData, SignerIdentifier,
    SignerInfo, SignerInfos,
};
use der::asn1::{OctetString, SetOfVec};
use der::oid::ObjectIdentifier;
use der::{Any, Decode, DecodeOwned, Encode, Reader, Sequence, SliceReader, Tagged};
use x509_cert::attr::Attribute;
use x509_cert::spki::AlgorithmIdentifierOwned;

const DATA: ObjectIdentifier = ObjectIdentifier::new_unwrap("1.2.840.113549.1.7.1");
const SIGNED_DATA: ObjectIdentifier = ObjectIdentifier::new_unwrap("1.2.840.113549.1.7.2");
const SHA256: ObjectIdentifier = ObjectIdentifier::new_unwrap("2.16.840.1.101.3.4.2.1");
const CONTENT_TYPE: ObjectIdentifier = ObjectIdentifier::new_unwrap("1.2.840.113549.1.9.3");
const MESSAGE_DIGEST: ObjectIdentifier = ObjectIdentifier::new_unwrap("1.2.840.113549.1.9.4");
const SIGNING_CERTIFICATE_V2: ObjectIdentifier =
    ObjectIdentifier::new_unwrap("1.2.840.113549.1.9.16.2.47");

/// `SigningCertificateV2` of RFC 5035.
#[derive(Sequence)]
struct SigningCertificate {
    certificates: Vec<CertificateId>,
    #[asn1(optional = "true")]
    policies: Option<Any>,
}

/// `ESSCertIDv2` of RFC 5035; without an algorithm it is SHA-256.
#[derive(Sequence)]
struct CertificateId {
    #[asn1(optional = "true")]
    algorithm: Option<AlgorithmIdentifierOwned>,
    digest: OctetString,
    #[asn1(optional = "true")]
    issuer_and_serial: Option<Any>,
}

fn failed(error: der::Error) -> Problem {
    Problem::new(format!("the signature is malformed: {error}"))
}

/// Signs what has this SHA-256; DER.
pub(crate) fn sign(key: &LaboratoryKey, digest: [u8; 32]) -> Result<Vec<u8>, Problem> {
    let attributes = attributes(key.certificate(), digest).map_err(failed)?;
    let signature = key.sign(Scheme::Sha256, &attributes.to_der().map_err(failed)?)?;
    let certificates: Vec<_> = key.certificates().iter().collect();
    let signature = OctetString::new(signature).map_err(failed)?;
    container(&certificates, key.algorithm(), attributes, signature).map_err(failed)
}

fn attributes(certificate: &Certificate, digest: [u8; 32]) -> der::Result<SignedAttributes> {
    let id = CertificateId {
        algorithm: None,
        digest: OctetString::new(certificate.fingerprint())?,
        issuer_and_serial: None,
    };
    let signing = SigningCertificate {
        certificates: vec![id],
        policies: None,
    };
    SetOfVec::try_from(vec![
        attribute(CONTENT_TYPE, Any::encode_from(&DATA)?)?,
        attribute(
            MESSAGE_DIGEST,
            Any::encode_from(&OctetString::new(digest)?)?,
        )?,
        attribute(SIGNING_CERTIFICATE_V2, Any::encode_from(&signing)?)?,
    ])
}

fn attribute(oid: ObjectIdentifier, value: Any) -> der::Result<Attribute> {
    Ok(Attribute {
        oid,
        values: SetOfVec::try_from(vec![value])?,
    })
}

/// The container around a signature: certificates, that of the key first, and what is signed.
fn container(
    certificates: &[&Certificate],
    method: ObjectIdentifier,
    attributes: SignedAttributes,
    signature: OctetString,
) -> der::Result<Vec<u8>> {
    let of = |one: &&Certificate| CertificateChoices::Certificate(one.parsed().clone());
    let choices = certificates.iter().map(of).collect::<Vec<_>>();
    // Note(index): a key has its certificate.
    let signer = signer(certificates[0], method, attributes, signature);
    let data = SignedData {
        version: CmsVersion::V1,
        digest_algorithms: SetOfVec::try_from(vec![algorithm(SHA256)])?,
        encap_content_info: EncapsulatedContentInfo {
            econtent_type: DATA,
            econtent: None,
        },
        certificates: Some(CertificateSet(SetOfVec::try_from(choices)?)),
        crls: None,
        signer_infos: SignerInfos(SetOfVec::try_from(vec![signer])?),
    };
    let info = ContentInfo {
        content_type: SIGNED_DATA,
        content: Any::encode_from(&data)?,
    };
    info.to_der()
}

fn signer(
    own: &Certificate,
    method: ObjectIdentifier,
    attributes: SignedAttributes,
    signature: OctetString,
) -> SignerInfo {
    let tbs = own.parsed().tbs_certificate();
    SignerInfo {
        version: CmsVersion::V1,
        sid: SignerIdentifier::IssuerAndSerialNumber(IssuerAndSerialNumber {
            issuer: tbs.issuer().clone(),
            serial_number: tbs.serial_number().clone(),
        }),
        digest_alg: algorithm(SHA256),
        signed_attrs: Some(attributes),
        signature_algorithm: algorithm(method),
        signature,
        unsigned_attrs: None,
    }
}

/// RSA wants NULL for its parameters, the others none.
fn algorithm(oid: ObjectIdentifier) -> AlgorithmIdentifierOwned {
    AlgorithmIdentifierOwned {
        oid,
        parameters: (oid == RSA_SHA256).then(Any::null),
    }
}

/// Checks a container, zeros after it, against the SHA-256 of what it is to sign. Returns the certificate of
/// the signature, and the others it carries.
pub(crate) fn verify(
    bytes: &[u8],
    digest: [u8; 32],
) -> Result<(Certificate, Vec<Certificate>), Problem> {
    let data = read(bytes).map_err(failed)??;
    let [signer] = data.signer_infos.0.as_slice() else {
        return Err(Problem::new(
            "it has not one signature but several, or none",
        ));
    };
    let carried = carried(&data).map_err(failed)?;
    let mut carried: Vec<_> = carried
        .into_iter()
        .map(Certificate::from_der)
        .collect::<Result<_, _>>()?;
    let at = carried.iter().position(|one| is_of(one, &signer.sid));
    let at = at.ok_or_else(|| Problem::new("the certificate of its key is not in it"))?;
    let own = carried.remove(at);
    check(signer, &own, digest)?;
    Ok((own, carried))
}

/// As [`verify`], of a container that [`sign`] made: not one byte of it is another.
pub(crate) fn verify_own(
    bytes: &[u8],
    digest: [u8; 32],
) -> Result<(Certificate, Vec<Certificate>), Problem> {
    let (own, carried) = verify(bytes, digest)?;
    let data = read(bytes).map_err(failed)??;
    let signer = data.signer_infos.0.as_slice().first();
    let certificates: Vec<_> = std::iter::once(&own).chain(&carried).collect();
    let again = signer.and_then(|signer| {
        let attributes = signer.signed_attrs.clone()?;
        let (method, signature) = (signer.signature_algorithm.oid, signer.signature.clone());
        container(&certificates, method, attributes, signature).ok()
    });
    match again.is_some_and(|again| again == bytes) {
        true => Ok((own, carried)),
        false => Err(Problem::new("its signature is not as it was made")),
    }
}

/// The container; after it nothing but zeros.
fn read(bytes: &[u8]) -> der::Result<Result<SignedData, Problem>> {
    let mut reader = SliceReader::new(bytes)?;
    let info = ContentInfo::decode(&mut reader)?;
    let rest = reader.read_slice(reader.remaining_len())?;
    if rest.iter().any(|byte| *byte != 0) {
        return Ok(Err(Problem::new("something stands after its signature")));
    }
    let data = info.content.decode_as::<SignedData>()?;
    let detached = data.encap_content_info.econtent.is_none();
    Ok(match info.content_type == SIGNED_DATA && detached {
        true => Ok(data),
        false => Err(Problem::new("its signature is of another kind")),
    })
}

fn carried(data: &SignedData) -> der::Result<Vec<Vec<u8>>> {
    let certificates = data.certificates.iter().flat_map(|set| set.0.iter());
    let x509 = certificates.filter_map(|choice| match choice {
        CertificateChoices::Certificate(certificate) => Some(certificate.to_der()),
        CertificateChoices::Other(_) => None,
    });
    x509.collect()
}

fn is_of(certificate: &Certificate, signer: &SignerIdentifier) -> bool {
    let tbs = certificate.parsed().tbs_certificate();
    match signer {
        SignerIdentifier::IssuerAndSerialNumber(named) => {
            named.issuer == *tbs.issuer() && named.serial_number == *tbs.serial_number()
        }
        SignerIdentifier::SubjectKeyIdentifier(named) => tbs
            .get_extension::<x509_cert::ext::pkix::SubjectKeyIdentifier>()
            .is_ok_and(|found| found.is_some_and(|(_, own)| own == *named)),
    }
}

fn check(signer: &SignerInfo, own: &Certificate, digest: [u8; 32]) -> Result<(), Problem> {
    if signer.digest_alg.oid != SHA256
        || ![RSA, RSA_SHA256, ECDSA_SHA256].contains(&signer.signature_algorithm.oid)
    {
        return Err(Problem::new(
            "it is signed by a method this tool does not know",
        ));
    }
    let attributes = signer.signed_attrs.as_ref();
    let attributes = attributes.ok_or_else(|| Problem::new("its signature is of another kind"))?;
    let signed = attributes.to_der().map_err(failed)?;
    if !own.signed(Scheme::Sha256, &signed, signer.signature.as_bytes()) {
        return Err(Problem::new("its signature is not that of its certificate"));
    }
    if only::<ObjectIdentifier>(attributes, CONTENT_TYPE)? != DATA {
        return Err(Problem::new("its signature is of another kind"));
    }
    if only::<OctetString>(attributes, MESSAGE_DIGEST)?.as_bytes() != digest {
        return Err(Problem::new(
            "it is not what was signed: bytes were altered",
        ));
    }
    let named = only::<SigningCertificate>(attributes, SIGNING_CERTIFICATE_V2)?;
    let first = named.certificates.first();
    let is_own = first.is_some_and(|id| {
        id.algorithm
            .as_ref()
            .is_none_or(|algorithm| algorithm.oid == SHA256)
            && id.digest.as_bytes() == own.fingerprint()
    });
    match is_own {
        true => Ok(()),
        false => Err(Problem::new("its certificate was exchanged")),
    }
}

/// The one value of an attribute that has to be there once.
fn only<T>(attributes: &SignedAttributes, oid: ObjectIdentifier) -> Result<T, Problem>
where
    T: DecodeOwned<Error = der::Error> + Tagged,
{
    let mut found = attributes.iter().filter(|attribute| attribute.oid == oid);
    match (found.next().map(|one| one.values.as_slice()), found.next()) {
        (Some([value]), None) => {
            let der = value.to_der().map_err(failed)?;
            T::from_der(&der).map_err(failed)
        }
        _ => Err(Problem::new(format!("what is signed lacks {oid}"))),
    }
}
