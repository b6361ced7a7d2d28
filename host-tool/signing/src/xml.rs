//! An XML signature within the document it signs (W3C XML Signature 1.1, enveloped): over the whole document,
//! in exclusive canonical form, with SHA-256 and RSA or ECDSA.
//!
//! The check takes this one form. It refers to the whole and to no part by a name, so that nothing can be
//! wrapped around what was signed.

use crate::canonical::{
    Bound, Part, SIGNATURE, canonical, malformed, namespace, read_attributes, split,
};
use crate::certificate::{RSA_SHA256, Scheme};
use crate::{Certificate, LaboratoryKey, Problem};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use quick_xml::Reader;
use quick_xml::events::Event;
use sha2::{Digest, Sha256};

const EXCLUSIVE: &str = "http://www.w3.org/2001/10/xml-exc-c14n#";
const ENVELOPED: &str = "http://www.w3.org/2000/09/xmldsig#enveloped-signature";
const SHA256: &str = "http://www.w3.org/2001/04/xmlenc#sha256";
const BY_RSA: &str = "http://www.w3.org/2001/04/xmldsig-more#rsa-sha256";
const BY_ECDSA: &str = "http://www.w3.org/2001/04/xmldsig-more#ecdsa-sha256";

/// Whether a signature is in it; of what is no XML, whether one is named.
pub(crate) fn is_signed(xml: &str) -> bool {
    elements(xml).map_or_else(|_| xml.contains(SIGNATURE), |found| !found.is_empty())
}

/// Signs a document.
pub(crate) fn sign(xml: &str, key: &LaboratoryKey) -> Result<String, Problem> {
    if is_signed(xml) {
        return Err(Problem::new("is signed already"));
    }
    let digest = Sha256::digest(canonical(xml, Part::Enveloping)?);
    let end = xml.rfind("</");
    let end = end.ok_or_else(|| Problem::new("is no XML with content"))?;
    let with = |value: &str| {
        let signature = written(key, &STANDARD.encode(digest), value);
        format!("{}{signature}{}", &xml[..end], &xml[end..])
    };
    let stated = canonical(&with(""), Part::SignedInfo)?;
    let value = key.sign(Scheme::Sha256Fixed, stated.as_bytes())?;
    Ok(with(&STANDARD.encode(value)))
}

fn written(key: &LaboratoryKey, digest: &str, value: &str) -> String {
    let method = match key.algorithm() {
        RSA_SHA256 => BY_RSA,
        _ => BY_ECDSA,
    };
    let certificate = |one: &Certificate| {
        let base64 = STANDARD.encode(one.der());
        format!("<ds:X509Certificate>{base64}</ds:X509Certificate>")
    };
    let certificates: String = key.certificates().iter().map(certificate).collect();
    format!(
        "<ds:Signature xmlns:ds=\"{SIGNATURE}\"><ds:SignedInfo>\
         <ds:CanonicalizationMethod Algorithm=\"{EXCLUSIVE}\"/>\
         <ds:SignatureMethod Algorithm=\"{method}\"/>\
         <ds:Reference URI=\"\"><ds:Transforms><ds:Transform Algorithm=\"{ENVELOPED}\"/>\
         <ds:Transform Algorithm=\"{EXCLUSIVE}\"/></ds:Transforms>\
         <ds:DigestMethod Algorithm=\"{SHA256}\"/><ds:DigestValue>{digest}</ds:DigestValue>\
         </ds:Reference></ds:SignedInfo><ds:SignatureValue>{value}</ds:SignatureValue>\
         <ds:KeyInfo><ds:X509Data>{certificates}</ds:X509Data></ds:KeyInfo></ds:Signature>"
    )
}

/// An element of the signature: its path within it, attributes and text.
#[derive(Debug, Default)]
struct Element {
    path: String,
    attributes: Vec<(String, String)>,
    text: String,
}

/// The elements of all signatures right below the root, in their order; each is of the namespace of signatures,
/// as what is put into canonical form is.
fn elements(xml: &str) -> Result<Vec<Element>, Problem> {
    let mut reader = Reader::from_str(xml);
    reader.config_mut().expand_empty_elements = true;
    let mut found: Vec<Element> = Vec::new();
    let mut open: Vec<(String, Bound)> = Vec::new();
    let mut within = false;
    loop {
        match reader.read_event().map_err(malformed)? {
            Event::Start(start) => {
                let bound = open.last().map(|(_, bound)| bound.clone());
                let (bound, attributes) = read_attributes(&start, bound.unwrap_or_default())?;
                let (prefix, local) = split(start.name().0);
                let of_signature = namespace(&bound, prefix)? == SIGNATURE;
                within |= open.len() == 1 && of_signature && local == "Signature";
                open.push((local.to_owned(), bound));
                if within && !of_signature {
                    return Err(Problem::new(
                        "something of another kind is in its signature",
                    ));
                }
                if within {
                    found.push(Element::new(&open[1..], attributes));
                }
            }
            Event::End(_) => {
                drop(open.pop());
                within &= open.len() > 1;
            }
            Event::Text(text) if within => {
                if let Some(last) = found.last_mut() {
                    last.text += &text;
                }
            }
            Event::Eof => return Ok(found),
            _ => (),
        }
    }
}

impl Element {
    fn new(path: &[(String, Bound)], attributes: Vec<(String, String)>) -> Self {
        let names: Vec<&str> = path.iter().map(|(name, _)| name.as_str()).collect();
        Self {
            path: names.join("/"),
            attributes,
            text: String::new(),
        }
    }
}

/// A signature as it is written, before anything of it is believed.
struct Stated {
    by_rsa: bool,
    digest: Vec<u8>,
    value: Vec<u8>,
    certificates: Vec<Certificate>,
}

/// Content of a signature, element by element, where it has the form this tool writes.
struct Form(std::vec::IntoIter<Element>);

impl Form {
    fn new(xml: &str) -> Result<Self, Problem> {
        let (whole, parts): (Vec<_>, Vec<_>) = elements(xml)?
            .into_iter()
            .partition(|one| one.path == "Signature");
        match whole.len() {
            1 => Ok(Self(parts.into_iter())),
            _ => Err(Problem::new("has not one signature but several, or none")),
        }
    }

    /// The next element, which has this path and one attribute, or none.
    fn next(&mut self, path: &str, attribute: Option<(&str, &[&str])>) -> Result<Element, Problem> {
        let one = self.0.next().unwrap_or_default();
        let given = one.attributes.iter();
        let given: Vec<_> = given
            .map(|(name, value)| (name.as_str(), value.as_str()))
            .collect();
        let fits = match (attribute, &given[..]) {
            (None, []) => true,
            (Some((name, values)), [(found, value)]) => name == *found && values.contains(value),
            _ => false,
        };
        match one.path.strip_prefix("Signature/") == Some(path) && fits {
            true => Ok(one),
            false => Err(Problem::new(format!(
                "its signature is of a form this tool does not check ({path})"
            ))),
        }
    }
}

impl Stated {
    /// Reads it where it has exactly the form this tool writes.
    fn read(xml: &str) -> Result<Self, Problem> {
        let mut form = Form::new(xml)?;
        let algorithm = "Algorithm";
        form.next("SignedInfo", None)?;
        let path = "SignedInfo/CanonicalizationMethod";
        form.next(path, Some((algorithm, &[EXCLUSIVE])))?;
        let path = "SignedInfo/SignatureMethod";
        let method = form.next(path, Some((algorithm, &[BY_RSA, BY_ECDSA])))?;
        form.next("SignedInfo/Reference", Some(("URI", &[""])))?;
        form.next("SignedInfo/Reference/Transforms", None)?;
        let path = "SignedInfo/Reference/Transforms/Transform";
        form.next(path, Some((algorithm, &[ENVELOPED])))?;
        form.next(path, Some((algorithm, &[EXCLUSIVE])))?;
        let path = "SignedInfo/Reference/DigestMethod";
        form.next(path, Some((algorithm, &[SHA256])))?;
        let digest = form.next("SignedInfo/Reference/DigestValue", None)?;
        let value = form.next("SignatureValue", None)?;
        Ok(Self {
            by_rsa: method.attributes.iter().any(|(_, value)| value == BY_RSA),
            digest: bytes(&digest.text)?,
            value: bytes(&value.text)?,
            certificates: certificates(form)?,
        })
    }
}

fn certificates(mut form: Form) -> Result<Vec<Certificate>, Problem> {
    form.next("KeyInfo", None)?;
    form.next("KeyInfo/X509Data", None)?;
    let mut certificates = Vec::new();
    while !form.0.as_slice().is_empty() {
        let one = form.next("KeyInfo/X509Data/X509Certificate", None)?;
        certificates.push(Certificate::from_der(bytes(&one.text)?)?);
    }
    Ok(certificates)
}

fn bytes(base64: &str) -> Result<Vec<u8>, Problem> {
    let digits: String = base64.split_ascii_whitespace().collect();
    let bytes = STANDARD.decode(digits);
    bytes.map_err(|error| Problem::new(format!("its signature is malformed: {error}")))
}

/// Checks the signature of a document. Returns the certificate of its key, and the others it carries.
pub(crate) fn verify(xml: &str) -> Result<(Certificate, Vec<Certificate>), Problem> {
    let stated = Stated::read(xml)?;
    let digest = Sha256::digest(canonical(xml, Part::Enveloping)?);
    if digest[..] != stated.digest[..] {
        return Err(Problem::new("it is not what was signed: it was altered"));
    }
    let signed = canonical(xml, Part::SignedInfo)?;
    let mut certificates = stated.certificates;
    let made_it = |one: &Certificate| {
        one.is_rsa() == stated.by_rsa
            && one.signed(Scheme::Sha256Fixed, signed.as_bytes(), &stated.value)
    };
    let at = certificates.iter().position(made_it);
    let at =
        at.ok_or_else(|| Problem::new("its signature is not that of a certificate it carries"))?;
    let own = certificates.remove(at);
    Ok((own, certificates))
}
