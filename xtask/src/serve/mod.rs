//! `serve`: the page of a run on this machine alone, with an answer to what is
//! decided there.
//!
//! It listens on 127.0.0.1, answers only who knows the run's token, and changes
//! something only for the page that it served itself (`guard.rs`). A connection
//! asks once and is closed; one that is slow, or says nothing, keeps neither
//! others nor the process waiting.

mod asked;
mod guard;
mod reply;
mod request;
mod site;
mod tabs;

use std::net::{Ipv4Addr, SocketAddr, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

pub use guard::Token;
pub use site::Site;
pub use tabs::Tabs;

use guard::Guard;
use reply::Reply;
use request::{Incoming, Refusal};

/// The most connections at a time: a browser opens six to a host for each of its
/// profiles, and one of every tab's stays open.
const MAX_CONNECTIONS: usize = 128;

/// Where a page is served.
#[derive(Debug, Clone)]
pub struct Address {
    /// The port.
    pub port: u16,
    /// The token in the page's path.
    pub token: Token,
}

impl Address {
    /// The page's address.
    pub fn url(&self) -> String {
        format!("http://127.0.0.1:{}/{}/", self.port, self.token)
    }
}

/// Serves a site from now on until the process ends, at an address that was used
/// before if there is one and it is free.
///
/// # Errors
/// The system gives no port, no randomness or no thread.
pub fn serve(site: &Arc<Site>, before: Option<Address>) -> std::io::Result<Address> {
    let bind = |port| TcpListener::bind(SocketAddr::from((Ipv4Addr::LOCALHOST, port)));
    let again = before.and_then(|before| Some((bind(before.port).ok()?, before.token)));
    let (listener, token) = match again {
        Some(again) => again,
        None => (bind(0)?, Token::random()?),
    };
    let address = Address { port: listener.local_addr()?.port(), token };
    let guard = Arc::new(Guard { port: address.port, token: address.token.clone() });
    let site = Arc::clone(site);
    thread::Builder::new().name("serve".into()).spawn(move || accept(&listener, &site, &guard))?;
    Ok(address)
}

fn accept(listener: &TcpListener, site: &Arc<Site>, guard: &Arc<Guard>) {
    /// How long nothing is accepted when the system has no more connections.
    const PAUSE: Duration = Duration::from_millis(50);
    let open = Arc::new(AtomicUsize::new(0));
    for stream in listener.incoming() {
        let Ok(stream) = stream else {
            thread::sleep(PAUSE);
            continue;
        };
        let one = Open::count(&open);
        if open.load(Ordering::SeqCst) > MAX_CONNECTIONS {
            continue;
        }
        let (site, guard) = (Arc::clone(site), Arc::clone(guard));
        // Without a thread for it, the connection is closed.
        let _ = thread::Builder::new().spawn(move || {
            answer(stream, &site, &guard);
            drop(one);
        });
    }
}

/// A connection, for as long as it is open.
struct Open(Arc<AtomicUsize>);

impl Open {
    fn count(all: &Arc<AtomicUsize>) -> Self {
        all.fetch_add(1, Ordering::SeqCst);
        Self(Arc::clone(all))
    }
}

impl Drop for Open {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::SeqCst);
    }
}

/// Reads one request and answers it.
fn answer(stream: TcpStream, site: &Site, guard: &Guard) {
    let Ok(mut incoming) = Incoming::new(stream) else { return };
    let reply = match incoming.head() {
        Ok(head) => site.reply(&head, &mut incoming, guard),
        Err(Refusal::SILENT) => return,
        Err(refusal) => refusal.into(),
    };
    let mut stream = incoming.into_stream();
    // Who has gone hears nothing, and nothing follows from that.
    let _ = match reply {
        Reply::Full { .. } => reply.write(&mut stream),
        Reply::Page => site.send_page(&mut stream),
        Reply::Events { edition } => site.stream_events(&mut stream, edition.as_deref()),
    };
    reply::close(&stream);
}
