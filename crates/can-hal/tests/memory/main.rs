//! The memory planner against the manuals' worked address examples, and against brute force.

mod errors;
mod manual;
mod properties;
