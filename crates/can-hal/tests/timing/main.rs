//! The bit-timing solver against the manuals' examples, against other people's programs, and against brute force.

mod errors;
mod manual;
mod properties;
mod reference;
