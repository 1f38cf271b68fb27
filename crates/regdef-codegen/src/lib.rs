//! Emitters over the checked model: model in, text out.

pub mod c;
pub mod svd;
pub mod table;
mod text;
