//! CMSIS-SVD 1.3.9.
//!
//! Arrays and clusters become `dim` elements, except registers whose field names run on from element to element:
//! those are written one by one, so that a debugger shows the manual's names. Registers of a window carry an
//! `alternateGroup`; alias registers are registers of their own.

mod alias;
mod enums;
mod field;
mod name;
mod peripheral;
mod register;

use std::fmt;

use regdef::model::Model;
use svd_encoder::Config;
use svd_rs::{Access, Device, RegisterProperties, ValidateLevel};

use crate::text;
use enums::Shared;

/// The level at which everything is validated while it is built.
const LEVEL: ValidateLevel = ValidateLevel::Strict;

/// Why a model has no SVD.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// A part is not valid SVD.
    Invalid {
        /// The register, field or peripheral.
        at: String,
        /// What the SVD rules say.
        source: svd_rs::SvdError,
    },
    /// An offset or distance exceeds 32 bits.
    TooFar {
        /// The register or cluster.
        at: String,
        /// The offset in bytes.
        offset: u64,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Invalid { at, source } => write!(f, "`{at}` cannot be written as SVD: {source}"),
            Self::TooFar { at, offset } => write!(f, "`{at}`: offset {offset:#x} exceeds the 32 bits of SVD"),
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Invalid { source, .. } => Some(source),
            Self::TooFar { .. } => None,
        }
    }
}

/// Attaches the place to a rule that was broken.
trait At<T> {
    fn at(self, place: &str) -> Result<T, Error>;
}

impl<T> At<T> for Result<T, svd_rs::SvdError> {
    fn at(self, place: &str) -> Result<T, Error> {
        self.map_err(|source| Error::Invalid { at: place.to_owned(), source })
    }
}

/// The controller as an SVD file.
///
/// # Errors
/// If the description cannot be said in SVD: a name that SVD does not allow, an address beyond 32 bits.
pub fn svd(model: &Model) -> Result<String, Error> {
    let device = device(model)?;
    let Ok(mut text) = svd_encoder::encode_with_config(&device, &Config::default());
    text.push('\n');
    Ok(text)
}

/// The controller as a device.
///
/// # Errors
/// As for [`svd`].
pub fn device(model: &Model) -> Result<Device, Error> {
    let width = u32::from(model.access_widths.iter().copied().max().unwrap_or(32));
    let properties = RegisterProperties::new().size(Some(width)).access(Some(Access::ReadWrite));
    Device::builder()
        .vendor(Some(plain(&model.manual.publisher)))
        .name(name::identifier(&model.names.id))
        .version(plain(&model.manual.revision))
        .description(description(model))
        .address_unit_bits(8)
        .width(width)
        .default_register_properties(properties)
        .peripherals(peripheral::all(model, &mut Shared::default())?)
        .schema_version("1.3.9".to_owned())
        .no_namespace_schema_location("CMSIS-SVD.xsd".to_owned())
        .build(LEVEL)
        .at(&model.names.id)
}

fn description(model: &Model) -> String {
    let manual = &model.manual;
    let mut sentences = vec![
        text::sentence(&model.title),
        text::sentence(&model.doc),
        text::sentence(&format!(
            "Described after {}, {}, revision {}",
            manual.title, manual.publisher, manual.revision
        )),
    ];
    if !model.messages.is_empty() {
        let names: Vec<&str> = model.messages.iter().map(|message| message.name.as_str()).collect();
        sentences.push(format!("SVD has no place for message layouts; left out are {}.", names.join(", ")));
    }
    let device: Vec<&str> = model.registers.iter().filter(|r| r.offset.is_none()).map(|r| r.label.as_str()).collect();
    if !device.is_empty() {
        sentences.push(format!("Left out, because they belong to the chip around it: {}.", device.join(", ")));
    }
    join(sentences)
}

/// Sentences as one text that XML and the `%s` of SVD leave as it is.
fn join(sentences: Vec<String>) -> String {
    let text = sentences.into_iter().filter(|s| !s.is_empty()).collect::<Vec<_>>().join(" ");
    plain(&text)
}

/// One line without control characters and without what SVD takes for an index.
fn plain(text: &str) -> String {
    text::one_line(text).chars().filter(|c| !c.is_control()).collect::<String>().replace("%s", "% s")
}

/// A byte offset as SVD counts it.
fn offset32(at: &str, offset: u64) -> Result<u32, Error> {
    u32::try_from(offset).map_err(|_| Error::TooFar { at: at.to_owned(), offset })
}
