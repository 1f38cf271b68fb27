//! The stable codes.

/// How bad a finding is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Nothing is generated.
    Error,
    /// Something to look at; generation goes on.
    Warning,
}

macro_rules! codes {
    ($($(#[doc = $doc:literal])+ $name:ident = $id:literal,)*) => {
        /// The kind of a finding. The number never changes; `E` is an error, `W` a warning.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[non_exhaustive]
        pub enum Code {
            $($(#[doc = $doc])+ $name,)*
        }

        impl Code {
            /// Every code in the order of its number.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            /// The code as it is printed.
            #[must_use]
            pub const fn as_str(self) -> &'static str {
                match self { $(Self::$name => $id,)* }
            }

            /// What the code means in general.
            #[must_use]
            pub const fn explanation(self) -> &'static str {
                match self { $(Self::$name => concat!($($doc),+).trim_ascii_start(),)* }
            }
        }
    };
}

codes! {
    /// The file could not be read.
    Unreadable = "E001",
    /// The file, or something in it, is larger than a description can be.
    TooLarge = "E002",
    /// The file is not UTF-8.
    NotUtf8 = "E003",
    /// The file holds nothing.
    Empty = "E004",
    /// The text is not YAML.
    Syntax = "E005",
    /// A tab stands where YAML wants spaces.
    Tab = "E006",
    /// The file holds more than one YAML document.
    SeveralDocuments = "E007",
    /// The same key stands twice in one mapping.
    DuplicateKey = "E008",
    /// Anchors and aliases are not part of the language.
    Alias = "E009",
    /// Mappings and lists are nested deeper than any description needs.
    TooDeep = "E010",
    /// Tags such as `!!str` are not part of the language.
    Tag = "E011",
    /// The text holds a character that is not text, or ends a line for some readers of YAML only.
    BadCharacter = "E012",
    /// The language has no such key here.
    UnknownKey = "E101",
    /// A key is missing.
    MissingKey = "E102",
    /// The value has the wrong type or form.
    WrongType = "E103",
    /// The number is outside the range that makes sense here.
    OutOfRange = "E104",
    /// The name cannot be made into an identifier.
    BadIdentifier = "E105",
    /// Two names become the same identifier in generated code.
    IdentifierClash = "E106",
    /// The same name is declared twice.
    DuplicateName = "E107",
    /// The name refers to nothing.
    UnknownReference = "E108",
    /// The expression cannot be read.
    BadExpression = "E109",
    /// A condition depends on itself.
    ConditionCycle = "E110",
    /// A register copies itself through `like`, or the chain of copies is too long.
    LikeCycle = "E111",
    /// Two statements exclude each other.
    Contradiction = "E112",
    /// Interrupt sources feed each other in a circle.
    FeedCycle = "E113",
    /// Two fields share bits.
    FieldOverlap = "E201",
    /// A field has bits outside its register.
    FieldOutside = "E202",
    /// Two registers share addresses and can be visible at the same time.
    RegisterOverlap = "E203",
    /// A register is not aligned to its width.
    Misaligned = "E204",
    /// An array element overlaps the next one or another register.
    ArrayOverlap = "E205",
    /// The stride is smaller than what it has to step over.
    StrideTooSmall = "E206",
    /// A register lies outside the block.
    OutsideBlock = "E207",
    /// A range of bits is written with the least significant bit first.
    ReversedBits = "E208",
    /// A value of an enumeration does not fit its field.
    EnumTooWide = "E301",
    /// Two entries of an enumeration have the same value.
    DuplicateEnumValue = "E302",
    /// The reset value does not fit the register or field.
    ResetTooWide = "E303",
    /// The reset of the register and that of a field disagree.
    ResetContradicts = "E304",
    /// The reset value sets a bit that no field has.
    ResetOutsideFields = "E305",
    /// A field has no access code and its register gives none.
    NoAccess = "E306",
    /// A field has no reset value and its register gives none.
    NoReset = "E307",
    /// An access rule does not go with the access code.
    AccessMismatch = "E308",
    /// A limit of a field does not fit its bits.
    LimitTooWide = "E309",
    /// A range is empty, or a list does not have the length it needs.
    BadRange = "E310",
    /// A fact has no citation.
    NoCitation = "E401",
    /// A citation names a source that is not declared.
    UnknownSource = "E402",
    /// A window has no field that selects it, or registers of one window are not told apart.
    WindowWithoutSelector = "E403",
    /// The file uses CRLF or CR line ends.
    CrLf = "W001",
    /// There are more findings than are listed.
    TooMany = "W002",
    /// Addresses of the block belong to no register and no reserved range.
    Gap = "W101",
    /// A reset value is one that its enumeration reserves or does not name.
    ResetReserved = "W102",
    /// Two write conditions wait for each other.
    ConditionLock = "W103",
    /// A declaration is used nowhere.
    Unused = "W104",
    /// A citation gives neither section, register, table, figure, example, equation, source nor note.
    VagueCitation = "W105",
    /// An enumeration leaves values unnamed that are not reserved either.
    UnnamedValues = "W106",
    /// A description is empty.
    EmptyDoc = "W107",
}

impl Code {
    /// Error or warning.
    #[must_use]
    pub fn severity(self) -> Severity {
        if self.as_str().starts_with('E') { Severity::Error } else { Severity::Warning }
    }
}
