//! C header.

