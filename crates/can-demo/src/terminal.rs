//! The timeline in the terminal.
use crate::Story;
/// x
pub fn timeline(story: &Story) -> String {
    let mut s = String::new();
    for a in &story.acts { s += &format!("{:?}\n", a); }
    for st in &story.steps { s += &format!("{} {} {:?} {}\n", st.time, st.node, st.deed, st.records.len()); }
    for e in story.recording.events() { s += &format!("{e}\n"); }
    s += &format!("{:#?}", story.diagnostics);
    s
}
/// x
pub fn files(story: &Story) -> String { format!("{:?}", story.files) }
