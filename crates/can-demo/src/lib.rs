//! What `cargo xtask demo` shows: two different controllers on a simulated bus exchange frames, one of them is disturbed,
//! goes error passive and bus off, and comes back.
//!
//! [`run`] plays the story: two drivers, written on [`can_hal`], run on the register models of [`can_sim`] and see what the
//! bus of [`can_wire`] makes of their frames and of the faults that are injected. [`terminal`], [`html`] and [`files`] show
//! what happened. Every number they show comes from the run.

pub mod controllers;
mod error;
pub mod files;
pub mod html;
pub mod moments;
mod picture;
pub mod play;
pub mod story;
pub mod terminal;

use std::path::PathBuf;

pub use error::Error;
pub use story::Story;

/// What to do.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The folder for the files; none are written without one.
    pub out: Option<PathBuf>,
}

/// Plays the story and writes its files.
///
/// # Errors
/// An [`Error`] if a driver does not get where the story wants it, or a file cannot be written.
pub fn run(options: &Options) -> Result<Story, Error> {
    let mut story = play::play::<controllers::MCan, controllers::DsPic33CanFd>()?;
    if let Some(folder) = &options.out {
        story.files = files::write(&story, folder)?;
    }
    Ok(story)
}
