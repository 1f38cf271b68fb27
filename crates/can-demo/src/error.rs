//! What can go wrong.

use std::{fmt, io, path::PathBuf};

use can_wire::Time;

/// Why there is no story to show.
#[derive(Debug)]
pub enum Error {
    /// The place of a controller on the bus makes no node.
    Place(can_wire::TimingError),
    /// A controller's clock cannot make the bit rates.
    Timing(can_hal::timing::TimingError),
    /// A driver has refused its configuration.
    Setup(String),
    /// A frame of the story is none.
    Frame(String),
    /// A driver has refused a frame.
    Send(can_hal::SendError),
    /// A controller did not follow within the bound of its driver.
    TimedOut(&'static str),
    /// The story does not go on: what it waits for has not happened.
    Stuck {
        /// What it waits for.
        waiting_for: &'static str,
        /// When it gave up.
        time: Time,
    },
    /// A template of the report does not work.
    Template(minijinja::Error),
    /// A file cannot be written.
    File {
        /// The file.
        path: PathBuf,
        /// Why.
        error: io::Error,
    },
}

impl Error {
    /// A driver's refusal.
    pub fn setup(error: impl fmt::Display) -> Self {
        Self::Setup(error.to_string())
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Place(error) => write!(f, "a controller's place on the bus: {error}"),
            Self::Timing(error) => write!(f, "a controller's bit timing: {error}"),
            Self::Setup(error) => write!(f, "a controller's configuration: {error}"),
            Self::Frame(text) => write!(f, "not a frame: {text}"),
            Self::Send(error) => write!(f, "a frame was not taken for sending: {error}"),
            Self::TimedOut(what) => write!(f, "a controller did not follow: {what}"),
            Self::Stuck { waiting_for, time } => write!(f, "at {time} still waiting for {waiting_for}"),
            Self::Template(error) => write!(f, "the report: {error:#}"),
            Self::File { path, error } => write!(f, "{}: {error}", path.display()),
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::File { error, .. } => Some(error),
            Self::Template(error) => Some(error),
            _ => None,
        }
    }
}
