//! The files: written under a temporary name and renamed, so that no one ever sees half a file.

use std::{
    fs,
    io::{self, Write as _},
    path::{Path, PathBuf},
};

use can_wire::{
    Time,
    output::{CandumpLog, PcapNg, Tap, Vcd},
};

use crate::{Error, Story, html};

/// Value change dump: the bus and every node's pins.
pub const VCD: &str = "bus.vcd";
/// Capture for Wireshark.
pub const PCAPNG: &str = "bus.pcapng";
/// Log of candump.
pub const CANDUMP: &str = "candump.log";
/// The report.
pub const REPORT: &str = "report.html";

/// Writes everything into a folder, which is made if it is not there; returns the paths.
///
/// # Errors
/// [`Error::File`] with the file that cannot be written, [`Error::Template`] if the report cannot be made.
pub fn write(story: &Story, folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let failed = |error| Error::File { path: folder.to_owned(), error };
    fs::create_dir_all(folder).map_err(failed)?;
    let report = html::report(story)?;
    let contents =
        [(REPORT, Ok(report.into_bytes())), (VCD, vcd(story)), (PCAPNG, pcapng(story)), (CANDUMP, candump(story))];
    let mut paths = Vec::new();
    for (name, content) in contents {
        let path = folder.join(name);
        let written = content.and_then(|content| put(&path, &content));
        written.map_err(|error| Error::File { path: path.clone(), error })?;
        paths.push(path);
    }
    Ok(paths)
}

/// The value change dump.
///
/// # Errors
/// None in practice: memory takes every byte.
pub fn vcd(story: &Story) -> io::Result<Vec<u8>> {
    let names: Vec<&str> = story.nodes.iter().map(|node| node.name).collect();
    let mut bytes = Vec::new();
    let mut vcd = Vcd::with_names(&mut bytes, &names)?;
    story.recording.replay(Time::ZERO, &mut vcd);
    vcd.finish(story.end)?;
    drop(vcd);
    Ok(bytes)
}

/// The capture: every frame once.
///
/// # Errors
/// None in practice: memory takes every byte.
pub fn pcapng(story: &Story) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut capture = PcapNg::new(&mut bytes, Tap::Bus, story.nodes.len())?;
    story.recording.replay(Time::ZERO, &mut capture);
    capture.finish()?;
    drop(capture);
    Ok(bytes)
}

/// The log: every frame once.
///
/// # Errors
/// None in practice: memory takes every byte.
pub fn candump(story: &Story) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut log = CandumpLog::new(&mut bytes, Tap::Bus, story.nodes.len());
    story.recording.replay(Time::ZERO, &mut log);
    log.finish()?;
    drop(log);
    Ok(bytes)
}

fn put(path: &Path, content: &[u8]) -> io::Result<()> {
    let folder = path.parent().unwrap_or(Path::new("."));
    let mut file = tempfile::NamedTempFile::new_in(folder)?;
    file.write_all(content)?;
    #[cfg(unix)]
    {
        // A temporary file is private; these are not.
        use std::os::unix::fs::PermissionsExt;
        file.as_file().set_permissions(fs::Permissions::from_mode(0o644))?;
    }
    file.persist(path).map_err(|error| error.error)?;
    Ok(())
}
