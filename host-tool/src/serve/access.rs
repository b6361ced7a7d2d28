//! Who may come in: loopback freely, others with a token.

use axum::http::HeaderMap;
use std::net::SocketAddr;

/// Bytes of a token: nobody guesses 128 bits.
const TOKEN_BYTES: usize = 16;

/// Conditions a request must meet.
#[derive(Clone, Debug)]
pub struct Access {
    address: SocketAddr,
    stop_port: u16,
    token: Option<String>,
}

/// Where a request says it comes from.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Caller<'a> {
    /// `Host`: the address this server was called by.
    pub(super) host: Option<&'a str>,
    /// `Origin`: the page that sent it, from browsers alone.
    pub(super) origin: Option<&'a str>,
    /// `Sec-Fetch-Site`: how that page stands to this server, from browsers alone.
    pub(super) site: Option<&'a str>,
    pub(super) token: Option<&'a str>,
}

impl<'a> Caller<'a> {
    pub(super) fn of(headers: &'a HeaderMap, token: Option<&'a str>) -> Self {
        let text = |name: &str| headers.get(name).and_then(|value| value.to_str().ok());
        Self {
            host: text("host"),
            origin: text("origin"),
            site: text("sec-fetch-site"),
            token,
        }
    }

    /// Whether it comes from the page of this server, or from no browser's page at all.
    pub(super) fn is_page_itself(&self) -> bool {
        let site = matches!(self.site, None | Some("same-origin" | "none"));
        let own = |origin: &str| self.host.is_some_and(|host| is_origin(origin, host));
        site && self.origin.is_none_or(own)
    }
}

fn is_origin(origin: &str, host: &str) -> bool {
    origin.strip_prefix("http://") == Some(host)
}

/// A `Host` without its port.
fn without_port(host: &str) -> &str {
    host.rsplit_once(':').map_or(host, |(name, _)| name)
}

impl Access {
    /// The rule of a server at this address, which takes stops on `stop_port` too.
    pub fn new(address: SocketAddr, stop_port: u16) -> Self {
        let token = (!address.ip().is_loopback()).then(new_token);
        Self {
            address,
            stop_port,
            token,
        }
    }

    /// Port for stops.
    pub fn stop_port(&self) -> u16 {
        self.stop_port
    }

    /// Addresses the page may load from and speak to, and who may frame it.
    pub fn content_policy(&self) -> String {
        let (page, port) = (self.address.port(), self.stop_port);
        format!(
            "default-src 'self'; connect-src 'self' ws://*:{page} http://*:{port}; frame-ancestors 'none'"
        )
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
    pub(super) fn admits(&self, from: &Caller<'_>) -> bool {
        self.knows(from, self.address.port())
    }

    /// Whether a stop may come in on the port for stops: from the page of this server, or from no page.
    pub(super) fn admits_stop(&self, from: &Caller<'_>) -> bool {
        let page = from
            .host
            .map(|host| format!("{}:{}", without_port(host), self.address.port()));
        let own = |origin| page.as_deref().is_some_and(|page| is_origin(origin, page));
        // Another port of the same host is the same site to a browser.
        let site = matches!(from.site, None | Some("same-site" | "none"));
        self.knows(from, self.stop_port) && site && from.origin.is_none_or(own)
    }

    fn knows(&self, from: &Caller<'_>, port: u16) -> bool {
        match &self.token {
            Some(wanted) => from.token.is_some_and(|token| same(token, wanted)),
            None => from
                .host
                .is_some_and(|host| self.is_loopback_name(host, port)),
        }
    }

    fn is_loopback_name(&self, host: &str, port: u16) -> bool {
        let own = self.address.ip().to_string();
        let names = ["localhost", "127.0.0.1", "[::1]", &own];
        names.iter().any(|name| host == format!("{name}:{port}"))
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
    hex::encode(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn access(address: &str) -> Access {
        Access::new(address.parse().expect("an address"), 8081)
    }

    fn by(host: &str) -> Caller<'_> {
        Caller {
            host: Some(host),
            ..Caller::default()
        }
    }

    #[test]
    fn loopback_is_free_but_not_under_a_strangers_name() {
        let access = access("127.0.0.1:8080");
        assert_eq!(access.url(), "http://127.0.0.1:8080/");
        for host in ["127.0.0.1:8080", "localhost:8080"] {
            assert!(access.admits(&by(host)), "{host}");
        }
        for host in [
            "evil.example:8080",
            "localhost:80",
            "localhost:8081",
            "localhost",
            "",
        ] {
            assert!(!access.admits(&by(host)), "{host}");
        }
        assert!(!access.admits(&Caller::default()));
    }

    #[test]
    fn others_need_the_token() {
        let access = access("0.0.0.0:8080");
        let url = access.url();
        let (_, token) = url.split_once("token=").expect("a token");
        assert_eq!(token.len(), 2 * TOKEN_BYTES);
        let with = |token| Caller {
            token,
            ..by("bench.example:8080")
        };
        assert!(access.admits(&with(Some(token))) && access.admits_stop(&with(Some(token))));
        let wrong = format!("{}0", &token[..token.len() - 1]);
        let long = format!("{token}0");
        for token in [None, Some(""), Some("x"), Some(long.as_str())] {
            assert!(!access.admits(&with(token)));
            assert!(!access.admits_stop(&with(token)));
        }
        assert_eq!(access.admits(&with(Some(&wrong))), wrong == token);
        let again = Access::new(access.address, access.stop_port);
        assert_ne!(url, again.url(), "a new one each time");
    }

    /// Browsers say of which page a request comes.
    #[test]
    fn other_sites_are_told_by_their_browser() {
        let access = access("127.0.0.1:8080");
        for (origin, site, page, stop) in [
            (None, None, true, true),
            (None, Some("none"), true, true),
            (
                Some("http://localhost:8080"),
                Some("same-origin"),
                true,
                false,
            ),
            (Some("http://localhost:8080"), None, true, false),
            (
                Some("http://evil.example"),
                Some("cross-site"),
                false,
                false,
            ),
            (
                Some("http://localhost:8080"),
                Some("same-site"),
                false,
                false,
            ),
            (Some("http://localhost:9"), Some("same-site"), false, false),
            (Some("null"), None, false, false),
            (None, Some("cross-site"), false, false),
        ] {
            let from = |host| Caller {
                origin,
                site,
                ..by(host)
            };
            let case = format!("{origin:?} {site:?}");
            assert_eq!(from("localhost:8080").is_page_itself(), page, "{case}");
            if origin != Some("http://localhost:8080") {
                assert_eq!(access.admits_stop(&from("localhost:8081")), stop, "{case}");
            }
        }
        let page = Caller {
            origin: Some("http://localhost:8080"),
            site: Some("same-site"),
            ..by("localhost:8081")
        };
        assert!(access.admits_stop(&page));
    }
}
