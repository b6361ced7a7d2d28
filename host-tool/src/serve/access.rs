//! Who may come in: loopback freely, others with a token.

use std::fmt::Write;
use std::net::SocketAddr;

/// Bytes of a token: nobody guesses 128 bits.
const TOKEN_BYTES: usize = 16;

/// Conditions a request must meet.
#[derive(Clone, Debug)]
pub struct Access {
    address: SocketAddr,
    token: Option<String>,
}

impl Access {
    /// The rule of a server at this address.
    pub fn new(address: SocketAddr) -> Self {
        let token = (!address.ip().is_loopback()).then(new_token);
        Self { address, token }
    }

    /// Address for a browser.
    pub fn url(&self) -> String {
        match &self.token {
            None => format!("http://{}/", self.address),
            Some(token) => format!("http://{}/?token={token}", self.address),
        }
    }

    /// Whether a request may come in: its `Host` header, and the token it brings.
    ///
    /// A page of a stranger can make this browser ask a loopback address by a name
    /// of the stranger's: the header gives it away.
    pub fn admits(&self, host: Option<&str>, token: Option<&str>) -> bool {
        match &self.token {
            Some(wanted) => token.is_some_and(|token| same(token, wanted)),
            None => host.is_some_and(|host| self.is_loopback_name(host)),
        }
    }

    fn is_loopback_name(&self, host: &str) -> bool {
        let names = ["localhost", "127.0.0.1", "[::1]"];
        let with_port = |name: &&str| host == format!("{name}:{}", self.address.port());
        host == self.address.to_string() || names.iter().any(with_port)
    }
}

/// Compares in a time that does not tell how much was right.
fn same(a: &str, b: &str) -> bool {
    let differences = a.bytes().zip(b.bytes()).map(|(a, b)| a ^ b);
    a.len() == b.len() && differences.fold(0, |all, one| all | one) == 0
}

/// From the system's random numbers, by way of the keys of std's hasher, which
/// are drawn from them once per process and differ by a counter afterwards: so
/// one hasher is asked for all of it.
fn new_token() -> String {
    use rand_chacha::ChaCha20Rng;
    use rand_chacha::rand_core::{Rng, SeedableRng};
    use std::hash::{BuildHasher, RandomState};
    let keys = RandomState::new();
    let mut seed = [0; 32];
    for (place, part) in seed.as_chunks_mut::<8>().0.iter_mut().enumerate() {
        *part = keys.hash_one(place).to_le_bytes();
    }
    let mut bytes = [0; TOKEN_BYTES];
    ChaCha20Rng::from_seed(seed).fill_bytes(&mut bytes);
    bytes.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn access(address: &str) -> Access {
        Access::new(address.parse().expect("an address"))
    }

    #[test]
    fn loopback_is_free_but_not_under_a_strangers_name() {
        let access = access("127.0.0.1:8080");
        assert_eq!(access.url(), "http://127.0.0.1:8080/");
        for host in ["127.0.0.1:8080", "localhost:8080"] {
            assert!(access.admits(Some(host), None), "{host}");
        }
        for host in ["evil.example:8080", "localhost:80", "localhost", ""] {
            assert!(!access.admits(Some(host), None), "{host}");
        }
        assert!(!access.admits(None, None));
    }

    #[test]
    fn others_need_the_token() {
        let access = access("0.0.0.0:8080");
        let url = access.url();
        let (_, token) = url.split_once("token=").expect("a token");
        assert_eq!(token.len(), 2 * TOKEN_BYTES);
        assert!(access.admits(Some("bench.example"), Some(token)));
        let wrong = format!("{}0", &token[..token.len() - 1]);
        let long = format!("{token}0");
        for token in [None, Some(""), Some("x"), Some(long.as_str())] {
            assert!(!access.admits(Some("127.0.0.1:8080"), token));
        }
        assert_eq!(access.admits(None, Some(&wrong)), wrong == token);
        assert_ne!(
            url,
            Access::new(access.address).url(),
            "a new one each time"
        );
    }
}
