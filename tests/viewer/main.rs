//! The viewer: its frames, its pictures, and itself in a real pseudo-terminal.

#[path = "../support/session.rs"]
mod session;
#[path = "../support/source.rs"]
mod source;
#[path = "../support/mod.rs"]
mod support;

mod beside;
#[cfg(unix)]
mod configuration;
mod frames;
mod pictures;
mod planes;
mod questions;
#[cfg(unix)]
mod saved;
mod schematic;
mod spanish;
#[cfg(unix)]
mod terminal;
#[cfg(unix)]
mod themes;
mod understanding;
mod values;
#[cfg(unix)]
mod waiting;
#[cfg(unix)]
mod what_if;
